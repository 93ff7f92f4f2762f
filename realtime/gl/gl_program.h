// Shader programs made of several source files, with compiler errors reported in the author's file and line.
#pragma once

#include "realtime/gl/gl_objects.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

/// Text of one shader stage in pieces; each piece keeps the name of the file it came from.
class ShaderSource {
  public:
    /// Appends a file's text. Throws InputError if it can't be read.
    void addFile(const std::filesystem::path& file);
    /// Appends text under a name in brackets, such as "(parameters)".
    void addText(const std::string& name, const std::string& text);

    /// Everything after a first line `#version VERSION` and `preamble`, each piece after a #line of its own
    /// (kLinesPerFile in shader_log.h).
    std::string assemble(std::string_view version = "410 core", std::string_view preamble = {}) const;
    /// Names by number; 0 is the preamble.
    const std::vector<std::string>& files() const { return files_; }
    /// Name of the last piece: the technique's own.
    const std::string& author() const { return files_.back(); }

  private:
    std::vector<std::string> files_{"(preamble)"};
    std::vector<std::string> texts_{""};
};

class GlProgram {
  public:
    /// Compiles and links. Throws InputError: "file:line: message" if the log says where, else the log.
    GlProgram(const ShaderSource& vertex, const ShaderSource& fragment);

    void use() const { glUseProgram(program_); }
    /// Location, -1 (which GL ignores) for a uniform the shader doesn't use.
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
