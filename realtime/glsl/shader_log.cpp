#include "realtime/glsl/shader_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace plumbline {
namespace {

// Longer lines of a log are truncated.
constexpr size_t kLongestLine = 2000;
constexpr size_t kLongestFlatLog = 600;

/// The line number and the message, if the line begins with a location of this form. `form` ends in %n.
std::optional<ShaderMessage> parsePlace(const std::string& line, const char* form) {
    int number = 0, end = 0;
    if (std::sscanf(line.c_str(), form, &number, &end) != 1 || end == 0 || number < 0) return std::nullopt;
    return ShaderMessage{number / kLinesPerFile, number % kLinesPerFile, true,
                         line.substr(static_cast<size_t>(end))};
}

/// Removes "error: " or "warning: " from the start of the text, including NVIDIA's error code.
bool takeSeverity(ShaderMessage& message) {
    constexpr std::string_view kPreprocessor = "preprocessor "; // Mesa's, before the word
    if (message.text.starts_with(kPreprocessor)) message.text.erase(0, kPreprocessor.size());
    const size_t colon = message.text.find(": ");
    if (colon == std::string::npos) return false;
    const std::string severity = message.text.substr(0, std::min(colon, message.text.find(' ')));
    if (severity != "error" && severity != "warning") return false;
    message.isError = severity == "error";
    message.text.erase(0, colon + 2);
    return true;
}

std::optional<ShaderMessage> parseLine(const std::string& line) {
    for (const char* form : {"%*9d:%9d(%*9d): %n", "%*9d(%9d) : %n"}) // Mesa, NVIDIA
        if (auto message = parsePlace(line, form); message && takeSeverity(*message)) return message;
    if (auto message = parsePlace(line, "ERROR: %*9d:%9d: %n")) return message; // ANGLE, glslang
    return std::nullopt;                                                        // ANGLE's warnings too
}

} // namespace

std::vector<ShaderMessage> parseShaderLog(const std::string& log) {
    std::vector<ShaderMessage> messages;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\0'))
            line.pop_back();
        line.resize(std::min(line.size(), kLongestLine));
        if (auto message = parseLine(line)) messages.push_back(std::move(*message));
    }
    return messages;
}

std::optional<LocatedMessage> locateFirstError(const std::string& log,
                                               const std::vector<std::string>& files) {
    std::optional<LocatedMessage> first;
    int further = 0;
    for (const ShaderMessage& message : parseShaderLog(log)) {
        if (!message.isError) continue;
        if (first) {
            ++further;
            continue;
        }
        const auto index = static_cast<size_t>(message.file);
        const std::string file =
            index < files.size() ? files[index] : fmt::format("shader source {}", message.file);
        first = LocatedMessage{fmt::format("{}:{}", file, message.line), message.text};
    }
    if (first && further > 0)
        first->what += fmt::format(" (and {} more {})", further, further == 1 ? "error" : "errors");
    return first;
}

std::string flattenLog(const std::string& log) {
    std::string flat;
    for (const char c : log) {
        const bool blank = static_cast<unsigned char>(c) <= ' ';
        if (blank && (flat.empty() || flat.back() == ' ')) continue;
        flat += blank ? ' ' : c;
    }
    while (!flat.empty() && flat.back() == ' ')
        flat.pop_back();
    if (flat.size() > kLongestFlatLog) flat = flat.substr(0, kLongestFlatLog) + " …";
    return flat.empty() ? "the driver gives no reason" : flat;
}

} // namespace plumbline
