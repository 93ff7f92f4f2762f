// Maps compiler messages of OpenGL drivers to the original file and line.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// Lines of file k of a shader are numbered from k * kLinesPerFile + 1: Mesa drops the source number of a
/// #line directive in most of its messages, but all drivers report the line.
inline constexpr int kLinesPerFile = 1000000;

/// One message of a log.
struct ShaderMessage {
    int file = 0;
    int line = 0; // in that file
    bool isError = true;
    std::string text;
};

/// Reads the styles of Mesa "0:12(3): error: …", NVIDIA "0(12) : error C1008: …" and ANGLE or glslang
/// "ERROR: 0:12: …"; other lines are ignored, as are warnings of the third style.
std::vector<ShaderMessage> parseShaderLog(const std::string& log);

/// The first error of a log as "file:line" and text, with the number of further errors in the text; nothing
/// if no line of the log has a known style. `files`: names by number.
struct LocatedMessage {
    std::string where, what;
};
std::optional<LocatedMessage> locateFirstError(const std::string& log, const std::vector<std::string>& files);

/// A log as one line of at most 600 characters, for logs of unknown style.
std::string flattenLog(const std::string& log);

} // namespace plumbline
