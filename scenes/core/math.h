// Vectors and matrices of the project, all GLM. Geometry is double; buffers for Embree and GL are float.
// Matrices are named target-from-source (viewFromWorld) and multiply column vectors.
#pragma once

#include <glm/glm.hpp>

#include <limits>
#include <numbers>

namespace plumbline {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;
using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec2i = glm::ivec2;

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr float kInfinityF = std::numeric_limits<float>::infinity();
inline constexpr float kNanF = std::numeric_limits<float>::quiet_NaN();

using glm::degrees;
using glm::radians;

/// The normalized vector; 0 for the zero vector.
inline Vec3 unitOrZero(const Vec3& vector) {
    const double length = glm::length(vector);
    return length > 0 ? vector / length : Vec3(0);
}

/// Ray in world space; `direction` is unit, so `t` is a distance in world units.
struct Ray {
    Vec3 origin;
    Vec3 direction;
    Vec3 at(double t) const { return origin + direction * t; }
};

/// Axis-aligned box, empty until the first `add`.
struct Bounds {
    Vec3 low{kInfinity};
    Vec3 high{-kInfinity};
    void add(const Vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    bool empty() const { return low.x > high.x; }
    double diagonal() const { return empty() ? 0.0 : glm::length(high - low); }
    Vec3 center() const { return 0.5 * (low + high); }
};

} // namespace plumbline
