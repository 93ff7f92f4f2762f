// A directional or point light without size or distance falloff.
#pragma once

#include "scenes/core/math.h"

#include <string>

namespace plumbline {

struct Light {
    enum class Kind { Directional, Point };

    std::string name;
    Kind kind = Kind::Directional;
    Vec3 toLightWorld{0, 1, 0};  // directional: unit vector toward the light
    Vec3 positionWorld{0, 0, 0}; // point
};

/// Unit vector from `pointWorld` toward the light and the distance to it (infinite for a directional one).
struct LightSample {
    Vec3 toLightWorld;
    double distance;
};
inline LightSample sampleLight(const Light& light, const Vec3& pointWorld) {
    if (light.kind == Light::Kind::Directional) return {light.toLightWorld, kInfinity};
    const Vec3 offset = light.positionWorld - pointWorld;
    const double distance = glm::length(offset);
    return {distance > 0 ? offset / distance : Vec3(0), distance};
}

} // namespace plumbline
