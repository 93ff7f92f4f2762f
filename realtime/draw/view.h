// The camera as the GPU needs it: everything relative to an origin near what is seen, worked out in double
// precision.
#pragma once

#include "realtime/gl/gl_program.h"
#include "scenes/scene/camera.h"
#include "scenes/scene/scene.h"

namespace plumbline {

/// Room before and behind the scene's range of depths from a camera, and of distances from a light, as a
/// fraction of its diagonal: a hit of a technique may lie outside of the true surface's bounds. What lies
/// further still is kept, but not put in order.
constexpr double kDepthMargin = 0.5;

/// What camera.glsl declares.
struct CameraUniforms {
    glm::mat4 clipFromRelative{1};
    glm::vec4 eye{0}, depthPlane{0};
    glm::vec2 depthRange{0}; // lowest depth, 1 / extent

    /// In the program in use.
    void set(const GlProgram& program) const;
};

class View {
  public:
    /// `boundsWorld`: all that may be drawn, relief included.
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
