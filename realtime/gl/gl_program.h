// Shader programs composed of several source files, with compiler errors reported at the original file and
// line.
#pragma once

#include "realtime/gl/gl_objects.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// The text of one shader stage as a list of pieces, each with the name of its file.
class ShaderSource {
  public:
    /// Appends a file's text. Throws InputError if it can't be read.
    void addFile(const std::filesystem::path& file);
    /// Appends text under a name in brackets, such as "(parameters)".
    void addText(const std::string& name, const std::string& text);

    /// The line `#version VERSION`, the preamble, and all pieces, each preceded by a #line directive
    /// (kLinesPerFile in shader_log.h).
    std::string assemble(std::string_view version = "410 core", std::string_view preamble = {}) const;
    /// File names by number; 0 is the preamble.
    const std::vector<std::string>& files() const { return files_; }
    /// Name of the last piece, which is the technique's file.
    const std::string& author() const { return files_.back(); }

  private:
    std::vector<std::string> files_{"(preamble)"};
    std::vector<std::string> texts_{""};
};

class GlProgram {
  public:
    /// Compiles and links. Throws InputError: "file:line: message" if the log contains a location, otherwise
    /// the log.
    GlProgram(const ShaderSource& vertex, const ShaderSource& fragment);

    void use() const { glUseProgram(program_); }
    /// The location; -1, which GL ignores, for a uniform that the shader doesn't use.
    GLint uniform(const char* name) const { return glGetUniformLocation(program_, name); }
    /// Names of the uniforms in use, without "[0]".
    std::set<std::string> activeUniforms() const;

    ~GlProgram();
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

  private:
    GLuint program_ = 0;
};

} // namespace plumbline
