#include "tests/realtime/draw/evaluate_glsl.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

constexpr GLint kArgumentUnit = 7;

GlTexture floatTexture(int width, const glm::vec4* texels) {
    GlTexture texture = GlTexture::make();
    glActiveTexture(GL_TEXTURE0 + kArgumentUnit);
    glBindTexture(GL_TEXTURE_2D, texture.get());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, 1, 0, GL_RGBA, GL_FLOAT, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

} // namespace

std::vector<glm::vec4> evaluateGlsl(ShaderSource functions, const std::vector<glm::vec4>& arguments,
                                    const std::function<void(const GlProgram&)>& setUp) {
    ShaderSource vertex;
    vertex.addText("(triangle)",
                   "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? "
                   "3.0 : -1.0, 0.0, 1.0); }");
    functions.addText(
        "(evaluate)",
        "uniform sampler2D uArguments;\nlayout(location = 0) out vec4 outValue;\n"
        "void main() { outValue = evaluate(texelFetch(uArguments, ivec2(int(gl_FragCoord.x), 0), 0)); }");
    const GlProgram program(vertex, functions);
    const auto width = static_cast<int>(arguments.size());
    const GlTexture target = floatTexture(width, nullptr);
    const GlFramebuffer framebuffer = GlFramebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.get(), 0);
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
    const GlTexture source = floatTexture(width, arguments.data());
    const GlVertexArray vertexArray = GlVertexArray::make();
    glBindVertexArray(vertexArray.get());
    glViewport(0, 0, width, 1);
    program.use();
    glUniform1i(program.uniform("uArguments"), kArgumentUnit);
    if (setUp) setUp(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<glm::vec4> values(arguments.size());
    glReadPixels(0, 0, width, 1, GL_RGBA, GL_FLOAT, values.data());
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    return values;
}

} // namespace plumbline
