#include "realtime/draw/shadow_maps.h"

#include "realtime/draw/technique_program.h"
#include "realtime/technique/baked_family.h"
#include "scenes/core/error.h"
#include "scenes/core/free_memory.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace plumbline {
namespace {

void checkLayers(const std::string& what, int size, int layers) {
    GLint widest = 0, deepest = 0, viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &widest);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &deepest);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    widest = std::min({widest, viewport[0], viewport[1]});
    if (size > widest || layers > deepest)
        throw MachineError(
            "shadow_map_size", what,
            fmt::format("at most {} layers of {} x {} texels on this OpenGL", deepest, widest, widest));
}

float numberOf(const Technique& technique, const char* setting) {
    return static_cast<float>(technique.harness(setting)->value.number);
}

} // namespace

ShadowMaps::ShadowMaps(const Technique& technique, const Scene& scene, const GpuScene& objects,
                       const Vec3& originWorld, const GlContext& context)
    : size_(static_cast<int>(numberOf(technique, "shadow_map_size"))),
      bias_(numberOf(technique, "shadow_map_bias")),
      lights_(shadowProjections(scene.lights, objects.boundsWorld(), originWorld, size_)) {
    if (lights_.empty()) return;
    reliefProgram_ = buildReliefLightProgram(technique, Side::Front);
    if (objects.hasReliefBacks(&BackSides::toLight))
        reliefBackProgram_ = buildReliefLightProgram(technique, Side::Back);
    plainProgram_ = buildPlainLightProgram();
    allocate(context);
}

void ShadowMaps::allocate(const GlContext& context) {
    const int layers = layerCount(lights_);
    const std::string what = fmt::format("shadow maps of {} layers of {} x {} texels", layers, size_, size_);
    checkLayers(what, size_, layers);
    if (context.softwareRasterizer()) requireMemory(what, 1.0 * sizeof(float) * layers * size_ * size_);
    clearGlErrors();
    layers_ = GlTexture::make();
    glBindTexture(GL_TEXTURE_2D_ARRAY, layers_.get());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, size_, size_, layers, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    // Distances are fetched unfiltered; there are no mip levels.
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    framebuffer_ = GlFramebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, layers_.get(), 0, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    checkGl(what);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw MachineError("OpenGL", fmt::format("{}: framebuffer status {:#x}", what, status));
}

void ShadowMaps::draw(const GpuScene& objects) const {
    if (lights_.empty()) return;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    glViewport(0, 0, size_, size_);
    const GLfloat farthest = 1;
    for (const ShadowProjection& light : lights_)
        for (size_t i = 0; i < light.layers.size(); ++i) {
            glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, layers_.get(), 0,
                                      light.firstLayer + static_cast<GLint>(i));
            glClearBufferfv(GL_DEPTH, 0, &farthest);
            plainProgram_->use();
            light.layers[i].set(*plainProgram_);
            objects.drawPlainFromLight(*plainProgram_);
            reliefProgram_->use();
            light.layers[i].set(*reliefProgram_);
            objects.drawReliefs(*reliefProgram_, Side::Front, &BackSides::toLight);
            if (!reliefBackProgram_) continue;
            reliefBackProgram_->use();
            light.layers[i].set(*reliefBackProgram_);
            objects.drawReliefs(*reliefBackProgram_, Side::Back, &BackSides::toLight);
        }
}

void ShadowMaps::setUniforms(const GlProgram& receiver) const {
    if (lights_.empty()) return;
    std::vector<glm::mat4> places;
    std::vector<glm::vec4> maps;
    std::vector<float> roundings;
    for (const ShadowProjection& light : lights_) {
        places.push_back(light.placeFromRelative);
        maps.emplace_back(light.firstLayer, light.nearest, 1 / (light.farthest - light.nearest),
                          light.halfDiagonal);
        roundings.push_back(static_cast<float>(light.rounding));
    }
    const auto count = static_cast<GLsizei>(lights_.size());
    glUniformMatrix4fv(receiver.uniform("uShadowPlaceFromRelative"), count, GL_FALSE,
                       glm::value_ptr(places[0]));
    glUniform4fv(receiver.uniform("uShadowMap"), count, glm::value_ptr(maps[0]));
    glUniform1fv(receiver.uniform("uShadowRounding"), count, roundings.data());
    glUniform1f(receiver.uniform("uShadowMapBias"), bias_);
    glActiveTexture(GL_TEXTURE0 +
                    static_cast<GLenum>(unitBehindBaked())); // the unit used by receivers (technique_program)
    glBindTexture(GL_TEXTURE_2D_ARRAY, layers_.get());
}

} // namespace plumbline
