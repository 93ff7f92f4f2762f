// RAII owners of OpenGL objects. Their context must be current when they are created and destroyed.
#pragma once

#include <glad/gl.h>

#include <string>
#include <utility>

namespace plumbline {

/// Move-only owner of a GL object; `Kind` creates and deletes it.
template <class Kind>
class GlObject {
  public:
    GlObject() = default; // none
    static GlObject make() {
        GlObject object;
        object.name_ = Kind::make();
        return object;
    }
    ~GlObject() { reset(); }
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    GLuint get() const { return name_; }
    explicit operator bool() const { return name_ != 0; }
    void reset() {
        if (name_) Kind::destroy(name_);
        name_ = 0;
    }

  private:
    GLuint name_ = 0;
};

// NOLINTBEGIN(bugprone-macro-parentheses): a type's name can't be in parentheses
#define PLUMBLINE_GL_KIND(Kind, Gen, Delete)                                                                 \
    struct Kind##Kind {                                                                                      \
        static GLuint make() {                                                                               \
            GLuint name = 0;                                                                                 \
            Gen(1, &name);                                                                                   \
            return name;                                                                                     \
        }                                                                                                    \
        static void destroy(GLuint name) { Delete(1, &name); }                                               \
    };                                                                                                       \
    using Kind = GlObject<Kind##Kind>

PLUMBLINE_GL_KIND(GlBuffer, glGenBuffers, glDeleteBuffers);
PLUMBLINE_GL_KIND(GlVertexArray, glGenVertexArrays, glDeleteVertexArrays);
PLUMBLINE_GL_KIND(GlTexture, glGenTextures, glDeleteTextures);
PLUMBLINE_GL_KIND(GlRenderbuffer, glGenRenderbuffers, glDeleteRenderbuffers);
PLUMBLINE_GL_KIND(GlFramebuffer, glGenFramebuffers, glDeleteFramebuffers);
PLUMBLINE_GL_KIND(GlQuery, glGenQueries, glDeleteQueries);
#undef PLUMBLINE_GL_KIND
// NOLINTEND(bugprone-macro-parentheses)

/// Throws MachineError naming `doing` ("the frame of 800 x 600") if GL reports an error.
void checkGl(const std::string& doing);
/// Discards earlier errors.
void clearGlErrors();

} // namespace plumbline
