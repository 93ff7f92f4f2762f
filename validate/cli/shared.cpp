#include "validate/cli/shared.h"

#include "scenes/core/error.h"
#include "scenes/scene/scene_limits.h"
#include "validate/report/page_bundle.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sys/resource.h>
#include <unistd.h>

namespace plumbline {
namespace {
constexpr const char* kClearLine = "\r\033[K";
}

uint64_t parseMemorySize(const std::string& text) {
    constexpr uint64_t kSmallest = uint64_t(1) << 20, kLargest = uint64_t(1) << 46;
    uint64_t number = 0;
    const char* end = text.data() + text.size();
    const auto [unit, error] = std::from_chars(text.data(), end, number);
    const std::string suffix(unit, end);
    const int shift = suffix.empty() ? 0 : suffix == "K" ? 10 : suffix == "M" ? 20 : suffix == "G" ? 30 : -1;
    const bool fits = error == std::errc() && shift >= 0 && number <= (kLargest >> shift);
    if (!fits || (number << shift) < kSmallest)
        throw InputError("--memory", fmt::format("'{}' is not a size of memory", text),
                         "a whole number of bytes, or with K, M or G behind it, from 1M to 65536G");
    return number << shift;
}

std::map<std::string, std::string> parseSettings(const std::vector<std::string>& texts) {
    std::map<std::string, std::string> settings;
    for (const std::string& text : texts) {
        const size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError("--set", fmt::format("found '{}'", text),
                             "key=value, for example linear_steps=64");
        if (!settings.emplace(text.substr(0, equals), text.substr(equals + 1)).second)
            throw InputError("--set", fmt::format("'{}' is given twice", text.substr(0, equals)));
    }
    return settings;
}

std::string parseChoice(const char* option, const std::string& text,
                        const std::vector<std::string>& choices) {
    if (std::find(choices.begin(), choices.end(), text) == choices.end())
        throw InputError(option, fmt::format("found '{}'", text), listOf(choices), didYouMean(text, choices));
    return text;
}

std::pair<std::string, std::string> parsePair(const char* option, const std::string& text,
                                              const char* example) {
    const size_t comma = text.find(',');
    if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
        throw InputError(option, fmt::format("found '{}'", text),
                         fmt::format("two with a comma between, along s and t, for example {}", example));
    return {text.substr(0, comma), text.substr(comma + 1)};
}

namespace {

/// All of a text is a number; NaN if it isn't.
double numberOf(const std::string& text) {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && stopped == end ? number : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

double parseLength(const char* option, const std::string& text) {
    const double length = numberOf(text);
    if (!(length >= kSmallestLength && length <= kLargestLength))
        throw InputError(option, fmt::format("'{}' is not a length", text),
                         "world units from 1e-9 to 1e9, for example 0.1");
    return length;
}

double parseTile(const char* option, const std::string& text) {
    constexpr double kSmallest = 1e-6, kLargest = 1e6; // as in scene files
    const double tile = numberOf(text);
    if (!(std::abs(tile) >= kSmallest && std::abs(tile) <= kLargest))
        throw InputError(option, fmt::format("'{}' is not a number of repeats", text),
                         "a number from 1e-6 to 1e6, or less than 0 to mirror");
    return tile;
}

std::pair<Wrap, Wrap> parseWraps(const std::optional<std::string>& text) {
    const auto wrapOf = [](const std::string& word) {
        return parseChoice("--wrap", word, {"repeat", "clamp"}) == "repeat" ? Wrap::Repeat : Wrap::Clamp;
    };
    const auto [s, t] = parsePair("--wrap", text.value_or("repeat,repeat"), "repeat,clamp");
    return {wrapOf(s), wrapOf(t)};
}

BaseChoice parseBase(const std::string& text, bool bothIsAChoice) {
    std::vector<std::string> choices{"limit", "proxy"};
    if (bothIsAChoice) choices.emplace_back("both");
    const auto found = std::find(choices.begin(), choices.end(), text);
    if (found == choices.end())
        throw InputError("--base", fmt::format("found '{}'", text), listOf(choices),
                         didYouMean(text, choices));
    return static_cast<BaseChoice>(found -
                                   choices.begin()); // the choices are in the order of the enumeration
}

double parseErrorPx(const std::string& text) {
    constexpr double kSmallest = 1e-6; // below it floats of the micro-triangles are the limit
    constexpr double kLargest = 1000;  // wider than a picture's features: surely a slip of the finger
    const double pixels = numberOf(text);
    if (!(pixels >= kSmallest && pixels <= kLargest))
        throw InputError("--error-px", fmt::format("'{}' is not an error in pixels", text),
                         "a number from 0.000001 to 1000, for example 0.05");
    return pixels;
}

ReferenceSummary summaryOf(const ReferenceStats& stats, const Frame& frame) {
    ReferenceSummary summary;
    summary.microTriangles = static_cast<double>(stats.microTriangles);
    summary.tessellateMs = stats.tessellateMs;
    summary.buildMs = stats.buildMs;
    summary.traceMs = stats.traceMs;
    summary.peakBytes = static_cast<double>(peakBytes());
    summary.certificate = summaryOf(stats.certificate, frame);
    for (const ReferenceStats::Object& object : stats.objects)
        summary.objects.push_back({object.name, object.rate, object.wantedRate, object.microTriangles});
    return summary;
}

SceneSummary summaryOf(const Scene& scene) {
    return {scene.name, scene.purpose, scene.hash, scene.changes, scene.camera.width, scene.camera.height};
}

std::string reportLine(const std::filesystem::path& page) {
    const std::string_view plain = report::plainReportReason();
    return fmt::format("report: {}\n{}", page.string(),
                       plain.empty() ? "" : fmt::format("(a plain one: {})\n", plain));
}

void printWarnings(const std::vector<std::string>& warnings) {
    const bool terminal = ::isatty(STDERR_FILENO) == 1; // where a line of progress may stand
    for (const std::string& warning : warnings)
        fmt::print(stderr, "{}warning: {}\n", terminal ? kClearLine : "", warning);
}

uint64_t peakBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<uint64_t>(usage.ru_maxrss) * 1024; // Linux counts in KiB
}

Progress::Progress() : terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (terminal_) std::fputs(kClearLine, stderr);
}

void Progress::step(const std::string& what) {
    step_ = what;
    if (!terminal_) return;
    std::fputs((kClearLine + what + " …").c_str(), stderr);
    std::fflush(stderr);
}

void Progress::say(const std::string& line) {
    if (terminal_) std::fputs(kClearLine, stderr);
    std::fputs((line + "\n").c_str(), stderr);
    step(step_);
}

} // namespace plumbline
