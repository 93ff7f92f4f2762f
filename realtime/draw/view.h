// The camera's uniforms, computed in double precision relative to an origin near the visible part of the
// scene.
#pragma once

#include "realtime/gl/gl_program.h"
#include "scenes/scene/camera.h"
#include "scenes/scene/scene.h"

namespace plumbline {

/// Margin of the depth range of a camera, and of the distance range of a light, as a fraction of the scene's
/// diagonal: a technique's hits may be outside the true surface's bounds. Hits beyond the margin are kept but
/// not depth-sorted.
constexpr double kDepthMargin = 0.5;

/// The uniforms of camera.glsl.
struct CameraUniforms {
    glm::mat4 clipFromRelative{1};
    glm::vec4 eye{0}, depthPlane{0};
    glm::vec2 depthRange{0}; // lowest depth, 1 / extent

    /// Sets them in the program in use.
    void set(const GlProgram& program) const;
};

class View {
  public:
    /// `boundsWorld`: bounds of everything drawn, including relief.
    View(const Scene& scene, const Bounds& boundsWorld);

    /// Positions on the GPU are world positions minus this.
    const Vec3& originWorld() const { return originWorld_; }
    /// Sets the uniforms of camera.glsl and the lights in the program in use.
    void setUniforms(const GlProgram& program) const;

  private:
    const Scene& scene_;
    Vec3 originWorld_;
    CameraUniforms camera_;
};

} // namespace plumbline
