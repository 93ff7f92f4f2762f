#include "validate/cli/option_values.h"

#include "scenes/core/contains.h"
#include "scenes/core/error.h"
#include "scenes/core/numbers.h"
#include "scenes/scene/scene_limits.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace plumbline {

std::string parseChoice(const char* option, const std::string& text,
                        const std::vector<std::string>& choices) {
    if (!contains(choices, text))
        throw InputError(option, fmt::format("found '{}'", text), listOf(choices), didYouMean(text, choices));
    return text;
}

std::pair<std::string, std::string> parsePair(const char* option, const std::string& text,
                                              const char* example) {
    const size_t comma = text.find(',');
    if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
        throw InputError(
            option, fmt::format("found '{}'", text),
            fmt::format("two values separated by a comma, along s and t, for example {}", example));
    return {text.substr(0, comma), text.substr(comma + 1)};
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

uint64_t parseMemorySize(const char* option, const std::string& text) {
    constexpr uint64_t kSmallest = uint64_t(1) << 20, kLargest = uint64_t(1) << 46;
    uint64_t number = 0;
    const char* end = text.data() + text.size();
    const auto [unit, error] = std::from_chars(text.data(), end, number);
    const std::string suffix(unit, end);
    const int shift = suffix.empty() ? 0 : suffix == "K" ? 10 : suffix == "M" ? 20 : suffix == "G" ? 30 : -1;
    const bool fits = error == std::errc() && shift >= 0 && number <= (kLargest >> shift);
    if (!fits || (number << shift) < kSmallest)
        throw InputError(
            option, fmt::format("'{}' is not a size of memory", text),
            "an integer number of bytes, optionally with the suffix K, M or G, from 1M to 65536G");
    return number << shift;
}

double parseErrorPx(const std::string& text) {
    constexpr double kSmallest = 1e-6; // below it floats of the micro-triangles are the limit
    constexpr double kLargest = 1000;  // wider than a picture's features: surely a slip of the finger
    const std::optional<double> pixels = parseNumber<double>(text);
    if (!pixels || *pixels < kSmallest || *pixels > kLargest)
        throw InputError("--error-px", fmt::format("'{}' is not an error in pixels", text),
                         "a number from 0.000001 to 1000, for example 0.05");
    return *pixels;
}

double parseLength(const char* option, const std::string& text) {
    const std::optional<double> length = parseNumber<double>(text);
    if (!length || *length < kSmallestLength || *length > kLargestLength)
        throw InputError(option, fmt::format("'{}' is not a length", text),
                         "world units from 1e-9 to 1e9, for example 0.1");
    return *length;
}

double parseTile(const char* option, const std::string& text) {
    constexpr double kSmallest = 1e-6, kLargest = 1e6; // as in scene files
    const std::optional<double> tile = parseNumber<double>(text);
    if (!tile || std::abs(*tile) < kSmallest || std::abs(*tile) > kLargest)
        throw InputError(option, fmt::format("'{}' is not a number of repeats", text),
                         "a number from 1e-6 to 1e6, or less than 0 to mirror");
    return *tile;
}

std::pair<Wrap, Wrap> parseWraps(const std::string& text) {
    const auto wrapOf = [](const std::string& word) {
        return parseChoice("--wrap", word, {"repeat", "clamp"}) == "repeat" ? Wrap::Repeat : Wrap::Clamp;
    };
    const auto [s, t] = parsePair("--wrap", text, "repeat,clamp");
    return {wrapOf(s), wrapOf(t)};
}

} // namespace plumbline
