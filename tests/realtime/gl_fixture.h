// Helpers of the tests that need OpenGL: skipping where it is unavailable, small scenes, pixel access.
#pragma once

#include "realtime/gl/gl_context.h"
#include "realtime/realtime.h"
#include "scenes/core/error.h"
#include "scenes/mesh/shapes/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace plumbline {

/// The context that the tests of a program share, opened by the first. Throws MachineError if there is none.
inline const std::shared_ptr<GlContext>& testContext() {
    // Never destroyed: at exit the driver's own statics may be gone already.
    static const auto* const context = new std::shared_ptr<GlContext>(createGlContext({}));
    return *context;
}

/// The reason why no context can be created; empty if one can.
inline std::string missingGl(GlBackend backend = GlBackend::Auto) {
    try {
        if (backend == GlBackend::Auto)
            testContext();
        else
            createGlContext({backend, -1});
        return {};
    } catch (const MachineError& error) {
        return error.what();
    }
}

#define PLUMBLINE_NEEDS_GL(backend)                                                                          \
    if (const std::string reason = missingGl(backend); !reason.empty()) GTEST_SKIP() << reason

/// An orthographic camera with a square image `viewHeight` world units high that looks at the origin from
/// `position`; its rays are easy to derive.
inline Camera orthographicCamera(const Vec3& position, const Vec3& up, double viewHeight, int pixels) {
    Camera camera;
    camera.positionWorld = position;
    camera.targetWorld = Vec3(0);
    camera.upWorld = up;
    camera.projection = Camera::Projection::Orthographic;
    camera.viewHeight = viewHeight;
    camera.width = camera.height = pixels;
    return camera;
}

/// A square in the plane y = 0, facing +y, that covers the unit square of uv: s along +x, t along -z.
inline SceneObject squareObject(double side, std::shared_ptr<const HeightMap> map, double depth) {
    SceneObject object;
    object.name = "square";
    object.mesh = makePlane(side, side, 1, 1);
    object.scheme = Scheme::None;
    if (map) object.relief = Relief{std::move(map), depth, 0.0, Vec2(1), Vec2(0)};
    return object;
}

inline Light directionalLight(const std::string& name, const Vec3& toLight) {
    Light light;
    light.name = name;
    light.toLightWorld = glm::normalize(toLight);
    return light;
}

inline Scene sceneOf(SceneObject object, const Camera& camera) {
    Scene scene;
    scene.name = "test";
    scene.background = Vec3(0.25, 0.5, 0.75);
    scene.camera = camera;
    scene.lights = {directionalLight("sun", {0.3, 1, 0.2})};
    scene.objects.push_back(std::move(object));
    return scene;
}

/// All channels of covered pixels must be finite numbers. Only the first violation is reported.
inline void expectNoNan(const Frame& frame) {
    const auto coverage = frame.channel("A");
    for (const std::string& name : frame.channelNames()) {
        const auto plane = frame.channel(name);
        for (size_t i = 0; i < plane.size(); ++i) {
            if (coverage[i] == 0 || std::isfinite(plane[i])) continue;
            const auto width = static_cast<size_t>(frame.width());
            ADD_FAILURE() << name << " is " << plane[i] << " at column " << i % width << ", row "
                          << i / width;
            return;
        }
    }
}

/// Draws one frame without timing.
inline Frame draw(const Scene& scene, const std::string& technique) {
    RealtimeRenderer renderer(scene, {GlBackend::Auto, -1, 0}, testContext());
    Frame frame = renderer.render(resolveTechnique(technique), nullptr).frame;
    expectNoNan(frame);
    return frame;
}

/// Index of a pixel; row 0 on top.
inline size_t pixelAt(const Frame& frame, int x, int y) {
    return static_cast<size_t>(y) * static_cast<size_t>(frame.width()) + static_cast<size_t>(x);
}

inline Vec3 vectorAt(const Frame& frame, const std::string& name, size_t pixel) {
    return {frame.channel(name + ".X")[pixel], frame.channel(name + ".Y")[pixel],
            frame.channel(name + ".Z")[pixel]};
}

inline Vec2 stAt(const Frame& frame, size_t pixel) {
    return {frame.channel("st.S")[pixel], frame.channel("st.T")[pixel]};
}

inline size_t coveredPixels(const Frame& frame) {
    size_t count = 0;
    for (const float a : frame.channel("A"))
        count += a > 0;
    return count;
}

} // namespace plumbline
