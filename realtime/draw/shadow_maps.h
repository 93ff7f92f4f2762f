// The shadow maps of one technique: the scene drawn from every light by the technique itself, and read by
// what the camera sees.
//
// shadow_projection.h says where texels lie, shaders/shadow_map.glsl how they are read.
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
    /// Sizes and bias are the technique's `shadow_map_size` and `shadow_map_bias`. Throws InputError for a
    /// shader, MachineError if the maps don't fit.
    ShadowMaps(const Technique& technique, const Scene& scene, const Bounds& boundsWorld,
               const Vec3& originWorld, const GlContext& context);

    /// The light passes: reliefs by the technique's own hits, their back faces culled; other objects as they
    /// are, both sides. Leaves a framebuffer of its own bound.
    void draw(const GpuScene& objects) const;
    /// What a receiver reads, in the program in use.
    void setUniforms(const GlProgram& receiver) const;

  private:
    void allocate(const GlContext& context);

    int size_; // texels a side
    float bias_;
    std::vector<ShadowProjection> lights_;
    std::unique_ptr<GlProgram> reliefProgram_, plainProgram_;
    GlFramebuffer framebuffer_;
    GlTexture layers_;
};

} // namespace plumbline
