#include "realtime/gl/gl_program.h"

#include "realtime/glsl/shader_log.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

/// Owns a shader object until the program is linked.
class Shader {
  public:
    Shader(GLenum stage, const ShaderSource& source) : name_(glCreateShader(stage)) {
        const std::string text = source.assemble();
        const GLchar* pointer = text.c_str();
        glShaderSource(name_, 1, &pointer, nullptr);
        glCompileShader(name_);
        GLint compiled = GL_FALSE;
        glGetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) return;
        const std::string log = readLog();
        glDeleteShader(name_);
        if (const auto error = locateFirstError(log, source.files()))
            throw InputError(error->where, error->what);
        throw InputError(source.author(), "doesn't compile: " + flattenLog(log));
    }
    ~Shader() { glDeleteShader(name_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    GLuint get() const { return name_; }

  private:
    std::string readLog() const {
        GLint length = 0;
        glGetShaderiv(name_, GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
        glGetShaderInfoLog(name_, length, nullptr, log.data());
        log.resize(std::min(log.find('\0'), log.size()));
        return log;
    }
    GLuint name_;
};

std::string readProgramLog(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    log.resize(std::min(log.find('\0'), log.size()));
    return log;
}

} // namespace

GlProgram::GlProgram(const ShaderSource& vertex, const ShaderSource& fragment) {
    const Shader vertexShader(GL_VERTEX_SHADER, vertex);
    const Shader fragmentShader(GL_FRAGMENT_SHADER, fragment);
    program_ = glCreateProgram();
    glAttachShader(program_, vertexShader.get());
    glAttachShader(program_, fragmentShader.get());
    glLinkProgram(program_);
    glDetachShader(program_, vertexShader.get());
    glDetachShader(program_, fragmentShader.get());
    GLint linked = GL_FALSE;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    const std::string log = readProgramLog(program_);
    glDeleteProgram(program_);
    if (const auto error = locateFirstError(log, fragment.files()))
        throw InputError(error->where, error->what);
    throw InputError(fragment.author(), "doesn't link: " + flattenLog(log));
}

GlProgram::~GlProgram() {
    glDeleteProgram(program_);
}

std::set<std::string> GlProgram::activeUniforms() const {
    GLint count = 0;
    glGetProgramiv(program_, GL_ACTIVE_UNIFORMS, &count);
    std::set<std::string> names;
    for (GLint i = 0; i < count; ++i) {
        GLchar buffer[256];
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program_, static_cast<GLuint>(i), sizeof buffer, nullptr, &size, &type, buffer);
        std::string name = buffer;
        names.insert(name.substr(0, name.find('[')));
    }
    return names;
}

} // namespace plumbline
