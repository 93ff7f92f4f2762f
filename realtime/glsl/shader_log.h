// Compiler messages of OpenGL drivers, brought back to the author's file and line.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// Lines of file k of a shader are numbered from k * kLinesPerFile + 1: Mesa forgets the source number of a
/// #line directive in most of its messages, but no driver loses the line.
inline constexpr int kLinesPerFile = 1000000;

/// One message of a log.
struct ShaderMessage {
    int file = 0;
    int line = 0; // in that file
    bool isError = true;
    std::string text;
};

/// Reads the styles of Mesa "0:12(3): error: …", NVIDIA "0(12) : error C1008: …" and ANGLE or glslang
/// "ERROR: 0:12: …"; lines of any other form are left out, and warnings of the third.
std::vector<ShaderMessage> parseShaderLog(const std::string& log);

/// The first error of a log as "file:line" and text, with the number of further errors in the text; nothing
/// if no line of the log is understood. `files`: names by number.
struct LocatedMessage {
    std::string where, what;
};
std::optional<LocatedMessage> locateFirstError(const std::string& log, const std::vector<std::string>& files);

/// A log as one line of at most 600 characters, for when it isn't understood.
std::string flattenLog(const std::string& log);

} // namespace plumbline
