// Shader programs, with compiler errors reported at the original file and line.
#pragma once

#include "realtime/gl/gl_objects.h"
#include "realtime/glsl/shader_source.h"

#include <set>
#include <string>

namespace plumbline {

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
