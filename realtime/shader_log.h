// Compiler messages of OpenGL drivers, brought back to the author's file and line.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// The number to give line `line` of source `source` in a #line directive. Mesa forgets the source number in
/// every message about a name (it says 0), so the line number carries it too; locateFirstError takes it out.
inline constexpr int kLinesASource = 100000;
constexpr int lineInShader(size_t source, int line) {
    return static_cast<int>(source) * kLinesASource + line;
}

/// One message of a log. `source` and `line` are those of the #line directives the shader was assembled with.
struct ShaderMessage {
    int source = 0;
    int line = 0;
    bool isError = true;
    std::string text;
};

/// Reads the styles of Mesa "0:12(3): error: …", NVIDIA "0(12) : error C1008: …" and ANGLE or glslang
/// "ERROR: 0:12: …"; lines of any other form are left out.
std::vector<ShaderMessage> parseShaderLog(const std::string& log);

/// The first error of a log as "file:line" and text, with the number of further errors in the text; nothing
/// if no line of the log is understood. `files`: names by source number.
struct LocatedMessage {
    std::string where, what;
};
std::optional<LocatedMessage> locateFirstError(const std::string& log, const std::vector<std::string>& files);

/// A log as one line of at most 600 characters, for when it isn't understood.
std::string flattenLog(const std::string& log);

} // namespace plumbline
