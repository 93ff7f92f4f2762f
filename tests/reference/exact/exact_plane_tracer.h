// An exact ray tracer for one flat parallelogram with a relief, the ground truth for the reference's
// micro-triangles.
//
//     P(a,b) = corner + a edgeU + b edgeV + n (offset - depth d(st)),    a, b in [0,1],    st = tile uv(a,b)
//     + uvOffset
//
// with uv affine in (a,b). Between texel centers d is a bilinear patch, so a ray intersects it at the roots
// of a quadratic. They are computed cell by cell, in double, without ray marching or triangles. The surface
// is an open sheet, visible from both sides, without walls at its boundary. World space, world units.
#pragma once

#include "scenes/scene/scene.h"

#include <optional>

namespace plumbline {

/// A flat base with affine uvs, and its relief.
struct FlatRelief {
    Vec3 corner, edgeU, edgeV;         // world
    Vec3 normal;                       // unit, outward
    Vec2 uvCorner, uvAlongU, uvAlongV; // uv(a,b) = uvCorner + a uvAlongU + b uvAlongV
    Relief relief;
};

/// The flat base of an object whose mesh is a rectangle in uv; throws std::invalid_argument if the mesh isn't
/// flat or its uvs aren't affine.
FlatRelief flatRelief(const SceneObject& object);

class ExactPlaneTracer {
  public:
    explicit ExactPlaneTracer(FlatRelief plane);

    struct Hit {
        double distance; // along the ray
        Vec3 position;
        Vec3 normal; // unit, outward, of the bilinear patch hit
        Vec2 st;     // tiled, unwrapped
        /// |N . direction|, 0 = grazing. It is proportional to the square root of the quadratic's
        /// discriminant: the slope of (ray's height - relief's height) at the root is normal.direction over
        /// normal.n.
        double crossing;
    };
    /// Nearest hit at a distance in [0, maxDistance]. `ray.direction` must be unit.
    std::optional<Hit> trace(const Ray& ray, double maxDistance = kInfinity) const;

    bool occluded(const Vec3& origin, const Vec3& direction, double maxDistance) const;

    /// Whether the side of a hit facing `toCamera` is in shadow: it faces away from the light, or the light
    /// is occluded.
    bool shadowed(const Hit& hit, const Vec3& toCamera, const LightSample& light) const;

    const FlatRelief& plane() const { return plane_; }

  private:
    struct TexelRay;
    TexelRay texelRay(const Ray& ray) const;
    std::optional<double> firstRoot(const TexelRay& ray, double begin, double end, Vec2i& cell) const;
    Hit hitAt(const Ray& ray, double distance, const Vec2i& cell) const;

    FlatRelief plane_;
    Vec3 dualU_, dualV_; // a = dot(P - corner, dualU_), b likewise
    Vec2 mapSize_;
    double lowest_, highest_; // of the relief, along n
};

/// Smallest root of a x^2 + 2 halfB x + c in [0, length]; 0 where all of it vanishes.
std::optional<double> firstRootOfQuadratic(double a, double halfB, double c, double length);

} // namespace plumbline
