// What several commands need: argument texts to values, progress, the reference's summary.
#pragma once

#include "reference/reference.h"
#include "scenes/maps/height_map.h"
#include "validate/results/results.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plumbline {

/// "268435456", "256M", "2G", "512K" (powers of 1024) to bytes. Throws InputError; at least 1M, at most 64T.
uint64_t parseMemorySize(const std::string& text);

/// "key=value" texts to a map. Throws InputError for a text without '=', without a key, or a key given twice.
std::map<std::string, std::string> parseSettings(const std::vector<std::string>& texts);

/// A word of `choices`. Throws InputError naming `option`, as those below.
std::string parseChoice(const char* option, const std::string& text, const std::vector<std::string>& choices);
/// "a,b" to {"a", "b"}: one each for s and t.
std::pair<std::string, std::string> parsePair(const char* option, const std::string& text,
                                              const char* example);
/// World units, within the bounds of scene files and above 0.
double parseLength(const char* option, const std::string& text);
/// Repeats of a map along an axis, not 0.
double parseTile(const char* option, const std::string& text);
/// "repeat,clamp" along s and t; nullopt: both repeat.
std::pair<Wrap, Wrap> parseWraps(const std::optional<std::string>& text);

/// Which references a run draws.
enum class BaseChoice { Limit, Proxy, Both };
/// "limit", "proxy" or, where that is a choice, "both". Throws InputError.
BaseChoice parseBase(const std::string& text, bool bothIsAChoice);

/// A number of pixels from 1e-6 to 1000. Throws InputError.
double parseErrorPx(const std::string& text);

/// Of the reference that drew `frame`.
ReferenceSummary summaryOf(const ReferenceStats& stats, const Frame& frame);
SceneSummary summaryOf(const Scene& scene);

/// Where the report is, and why it is a plain one if it is: a line for stdout.
std::string reportLine(const std::filesystem::path& page);

/// Prints them on stderr, a line "warning: …" each.
void printWarnings(const std::vector<std::string>& warnings);

/// Largest resident set of this process so far, bytes.
uint64_t peakBytes();

/// Says on stderr what is being done, on one line that is overwritten, if stderr is a terminal; else only
/// what is to stay.
class Progress {
  public:
    Progress();
    ~Progress();
    void step(const std::string& what);
    /// A line that stays, terminal or not; the step is said again after it.
    void say(const std::string& line);

  private:
    bool terminal_;
    std::string step_;
};

} // namespace plumbline
