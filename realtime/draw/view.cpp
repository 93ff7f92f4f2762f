#include "realtime/draw/view.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace plumbline {
namespace {

// Near plane as a fraction of the far plane. It doesn't affect depth precision, because gl_FragDepth is
// linear in the planar depth; it only prevents a division by zero for points at the camera.
constexpr double kNearFraction = 1e-6;

struct DepthRange {
    double low, high;
};

DepthRange planarDepthRange(const Camera& camera, const Bounds& bounds) {
    const CameraRays rays(camera);
    DepthRange range{kInfinity, -kInfinity};
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 point(corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                         corner & 4 ? bounds.high.z : bounds.low.z);
        const double depth = rays.planarDepth(point);
        range.low = std::min(range.low, depth);
        range.high = std::max(range.high, depth);
    }
    const double margin = kDepthMargin * bounds.diagonal();
    range.low = std::max(range.low - margin, 0.0);
    range.high += margin;
    return range;
}

} // namespace

View::View(const Scene& scene, const Bounds& boundsWorld) : scene_(scene) {
    const Camera& camera = scene.camera;
    const bool perspective = camera.projection == Camera::Projection::Perspective;
    Bounds bounds = boundsWorld;
    if (bounds.empty()) bounds.add(camera.targetWorld);
    // The point of the scene nearest to the camera, where single precision is then best.
    originWorld_ = glm::clamp(camera.positionWorld, bounds.low, bounds.high);

    DepthRange range = planarDepthRange(camera, bounds);
    if (!(range.high > range.low)) range = {0, 1}; // a single point, or everything behind the camera
    const Mat4 viewFromWorldMatrix = viewFromWorld(camera);
    const Mat4 viewFromRelative = viewFromWorldMatrix * glm::translate(Mat4(1.0), originWorld_);
    camera_.clipFromRelative =
        glm::mat4(clipFromView(camera, kNearFraction * range.high, range.high) * viewFromRelative);

    const Vec3 towardCamera(viewFromWorldMatrix[0][2], viewFromWorldMatrix[1][2], viewFromWorldMatrix[2][2]);
    camera_.eye = perspective ? glm::vec4(glm::vec3(camera.positionWorld - originWorld_), 1)
                              : glm::vec4(glm::vec3(towardCamera), 0);
    // Z = -z_view.
    camera_.depthPlane = glm::vec4(glm::vec3(-towardCamera), static_cast<float>(-viewFromRelative[3][2]));
    camera_.depthRange = glm::vec2(range.low, 1.0 / (range.high - range.low));
}

void CameraUniforms::set(const GlProgram& program) const {
    glUniformMatrix4fv(program.uniform("uClipFromRelative"), 1, GL_FALSE, glm::value_ptr(clipFromRelative));
    glUniform4fv(program.uniform("uEye"), 1, glm::value_ptr(eye));
    glUniform4fv(program.uniform("uDepthPlane"), 1, glm::value_ptr(depthPlane));
    glUniform2fv(program.uniform("uDepthRange"), 1, glm::value_ptr(depthRange));
}

void View::setUniforms(const GlProgram& program) const {
    camera_.set(program);
    std::vector<glm::vec4> lights;
    for (const Light& light : scene_.lights)
        lights.push_back(light.kind == Light::Kind::Directional
                             ? glm::vec4(glm::vec3(light.toLightWorld), 0)
                             : glm::vec4(glm::vec3(light.positionWorld - originWorld_), 1));
    if (!lights.empty())
        glUniform4fv(program.uniform("uLights"), static_cast<GLsizei>(lights.size()),
                     glm::value_ptr(lights.front()));
}

} // namespace plumbline
