// The shadow maps of one technique: the scene drawn from every light with the technique itself, for lookup
// when drawing the camera's view.
//
// shadow_projection.h defines the positions of texels, shaders/shadow_map.glsl the lookup.
#pragma once

#include "realtime/draw/gpu_scene.h"
#include "realtime/draw/shadow_projection.h"
#include "realtime/gl/gl_context.h"
#include "realtime/gl/gl_objects.h"
#include "realtime/technique/technique.h"

#include <memory>

namespace plumbline {

class ShadowMaps {
  public:
    /// Size and bias are the technique's `shadow_map_size` and `shadow_map_bias`. Throws InputError for
    /// shader errors, MachineError if the maps exceed GL's limits.
    ShadowMaps(const Technique& technique, const Scene& scene, const GpuScene& objects,
               const Vec3& originWorld, const GlContext& context);

    /// Draws the light passes: reliefs with the technique's hits, their back sides only where they aren't
    /// hidden from the lights; other objects with both sides. Leaves its own framebuffer bound.
    void draw(const GpuScene& objects) const;
    /// Sets the uniforms of a receiver; its program must be in use.
    void setUniforms(const GlProgram& receiver) const;

  private:
    void allocate(const GlContext& context);

    int size_; // texels per side
    float bias_;
    std::vector<ShadowProjection> lights_;
    std::unique_ptr<GlProgram> reliefProgram_, plainProgram_;
    std::unique_ptr<GlProgram> reliefBackProgram_; // null: no back sides
    GlFramebuffer framebuffer_;
    GlTexture layers_;
};

} // namespace plumbline
