// Scenes whose shadows can be derived by hand.
#pragma once

#include "realtime/draw/shadow_projection.h"
#include "tests/realtime/gl_fixture.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace plumbline {

inline Light pointLight(const std::string& name, const Vec3& position) {
    Light light;
    light.name = name;
    light.kind = Light::Kind::Point;
    light.positionWorld = position;
    return light;
}

/// A box without relief, centered at `center`.
inline SceneObject boxObject(const std::string& name, const Vec3& size, const Vec3& center) {
    SceneObject object;
    object.name = name;
    object.mesh = makeBox(size, 1);
    object.scheme = Scheme::None;
    object.translate = center;
    return object;
}

/// `squareObject` at a height.
inline SceneObject plateObject(const std::string& name, double side, double height,
                               std::shared_ptr<const HeightMap> map = nullptr, double depth = 0) {
    SceneObject object = squareObject(side, std::move(map), depth);
    object.name = name;
    object.translate = Vec3(0, height, 0);
    return object;
}

inline Scene sceneOfObjects(std::vector<SceneObject> objects, std::vector<Light> lights,
                            const Camera& camera) {
    Scene scene = sceneOf(std::move(objects.front()), camera);
    scene.objects.insert(scene.objects.end(), std::make_move_iterator(objects.begin() + 1),
                         std::make_move_iterator(objects.end()));
    scene.lights = std::move(lights);
    return scene;
}

struct ShadowCount {
    size_t pixels = 0, shadowed = 0;
};

/// Counts the pixels of an object (0: of all objects), and those in shadow.
inline ShadowCount countShadows(const Frame& frame, const std::string& light, int id = 0) {
    const auto ids = frame.channel("id"), shadow = frame.channel("shadow." + light);
    ShadowCount count;
    for (size_t i = 0; i < frame.pixelCount(); ++i)
        if (ids[i] > 0 && (id == 0 || static_cast<int>(ids[i]) == id)) {
            ++count.pixels;
            count.shadowed += shadow[i] == 1;
        }
    return count;
}

/// The expected state of a point relative to a shadow given by a formula.
enum class Expected { Shadow, Lit, Either };

/// Compares every pixel of an object; returns the number of pixels that were not Either.
inline size_t expectShadows(const Frame& frame, const std::string& light, int id,
                            const std::function<Expected(const Vec3& positionWorld)>& formula) {
    const auto ids = frame.channel("id"), shadow = frame.channel("shadow." + light);
    size_t wrong = 0, decided = 0;
    for (size_t i = 0; i < frame.pixelCount(); ++i) {
        if (static_cast<int>(ids[i]) != id) continue;
        const Vec3 position = vectorAt(frame, "P", i);
        const Expected expected = formula(position);
        if (expected == Expected::Either) continue;
        ++decided;
        if ((shadow[i] == 1) == (expected == Expected::Shadow)) continue;
        if (wrong++ == 0)
            ADD_FAILURE() << light << " at " << position.x << " " << position.y << " " << position.z << " is "
                          << shadow[i];
    }
    EXPECT_EQ(wrong, 0u);
    return decided;
}

/// A rectangular shadow whose edges are known to within `margin`.
inline Expected inRectangle(double x, double y, const Vec2& low, const Vec2& high, double margin) {
    const double outside = std::max({low.x - x, x - high.x, low.y - y, y - high.y});
    return outside > margin ? Expected::Lit : outside < -margin ? Expected::Shadow : Expected::Either;
}

} // namespace plumbline
