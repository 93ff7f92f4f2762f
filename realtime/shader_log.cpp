#include "shader_log.h"

#include <fmt/format.h>

#include <regex>
#include <sstream>

namespace plumbline {
namespace {

// A log line longer than this is cut before it is matched: std::regex recurses per character.
constexpr size_t kLongestLine = 2000;
constexpr size_t kLongestFlatLog = 600;

ShaderMessage messageAt(const std::string& line, bool isError, const std::string& text) {
    const int number = std::stoi(line);
    return {number / kLinesPerFile, number % kLinesPerFile, isError, text};
}

std::optional<ShaderMessage> parseLine(const std::string& line) {
    static const std::regex mesa(R"(^\d{1,6}:(\d{1,9})\(\d+\): (error|warning): (.*))");
    static const std::regex nvidia(R"(^\d{1,6}\((\d{1,9})\) : (error|warning) \w+: (.*))");
    static const std::regex angle(R"(^(ERROR|WARNING): \d{1,6}:(\d{1,9}): (.*))");
    std::smatch match;
    if (std::regex_match(line, match, mesa) || std::regex_match(line, match, nvidia))
        return messageAt(match[1], match[2] == "error", match[3]);
    if (std::regex_match(line, match, angle)) return messageAt(match[2], match[1] == "ERROR", match[3]);
    return std::nullopt;
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
