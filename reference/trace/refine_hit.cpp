#include "reference/trace/refine_hit.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

namespace {

// Newton's method doubles the number of correct digits per step. From a micro-triangle it converges in two or
// three steps, plus one for each crossed crease between texels.
constexpr int kMaxSteps = 12;
// Number of starting points when searching for an earlier intersection.
constexpr int kStartsBefore = 6;
// Converged: the distance from the ray is less than this fraction of the coordinates. At 1 degree to the
// surface, the error in depth is then 60 times larger, 2^-26, which is the last bits of the frame's floats.
// (The rounding error of the evaluation is about 2^-50.)
constexpr double kConverged = 0x1p-32;
bool isInside(const Vec2& uv, bool triangular) {
    return uv.x >= 0 && uv.y >= 0 && (triangular ? uv.x + uv.y <= 1 : uv.x <= 1 && uv.y <= 1);
}

Vec2 clampToPatch(const Vec2& uv, bool triangular) {
    Vec2 inside = glm::clamp(uv, Vec2(0), Vec2(1));
    const double over = inside.x + inside.y - 1;
    if (triangular && over > 0) inside = glm::max(inside - Vec2(over / 2), Vec2(0));
    return inside;
}

/// Two orthonormal vectors perpendicular to the ray.
struct Across {
    Vec3 x, y;
    explicit Across(const Vec3& direction) {
        const Vec3 size = glm::abs(direction);
        const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                          : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                               : Vec3(0, 0, 1);
        x = glm::normalize(glm::cross(direction, axis));
        y = glm::cross(direction, x);
    }
    Vec2 of(const Vec3& vector) const { return {glm::dot(vector, x), glm::dot(vector, y)}; }
};

} // namespace

SurfaceSample HitRefiner::sampleAt(const PatchPlace& place) {
    if (place.patch != patch_) {
        evaluator_.setPatch(place.patch);
        patch_ = place.patch;
    }
    const BaseSample base = evaluator_.sample(place.uv.x, place.uv.y);
    return {base, displace(base, relief_)};
}

PatchPlace HitRefiner::clamped(const PatchPlace& place) const {
    return {place.patch, clampToPatch(place.uv, surface_.patch(place.patch).triangular)};
}

bool HitRefiner::move(PatchPlace& place, const Vec2& next) const {
    if (isInside(next, surface_.patch(place.patch).triangular)) {
        place.uv = next;
        return true;
    }
    if (const auto beyond = neighbors_.beyond(place.patch, next)) {
        place = clamped(*beyond);
        return true;
    }
    const PatchPlace onRim = clamped({place.patch, next});
    if (onRim.uv == place.uv) return false;
    place = onRim;
    return true;
}

std::optional<RefinedHit> HitRefiner::refine(const Ray& ray, const PatchPlace& start, double distance,
                                             double reachWorld) {
    const Across across(ray.direction);
    const Vec3 origin = glm::abs(ray.origin);
    const double tolerance = kConverged * (std::max({origin.x, origin.y, origin.z}) + std::abs(distance));
    PatchPlace place = clamped(start);
    double smallest = kInfinity;
    for (int step = 0; step < kMaxSteps; ++step) {
        const SurfaceSample sample = sampleAt(place);
        const Vec2 residual = across.of(sample.displaced.position - ray.origin);
        const double size = glm::length(residual);
        if (size <= tolerance) {
            const double along = glm::dot(sample.displaced.position - ray.origin, ray.direction);
            if (!(std::abs(along - distance) <= reachWorld)) return std::nullopt;
            return RefinedHit{place, along, sample};
        }
        const Vec2 byU = across.of(sample.displaced.positionU), byV = across.of(sample.displaced.positionV);
        const double determinant = byU.x * byV.y - byU.y * byV.x;
        if (!(std::abs(determinant) > 0)) return std::nullopt;
        // The iteration may oscillate between two creases; half steps prevent that.
        const double damping = size < smallest ? 1 : 0.5;
        smallest = std::min(smallest, size);
        const Vec2 next =
            place.uv +
            damping * Vec2(residual.y * byV.x - residual.x * byV.y, residual.x * byU.y - residual.y * byU.x) /
                determinant;
        if (!move(place, next)) return std::nullopt;
    }
    return std::nullopt;
}

RefinedHit HitRefiner::first(const Ray& ray, const RefinedHit& hit, double reachWorld) {
    const BaseSample& base = hit.sample.base;
    const AcrossRelief across = tangentsAcross(base, relief_);
    const double uu = glm::dot(across.byU, across.byU), uv = glm::dot(across.byU, across.byV),
                 vv = glm::dot(across.byV, across.byV), determinant = uu * vv - uv * uv;
    RefinedHit first = hit;
    if (!(determinant > 0)) return first;
    // Moves backwards along the ray: the component of a step orthogonal to the relief's direction, in u and
    // v.
    const double alongU = -glm::dot(ray.direction, across.byU), alongV = -glm::dot(ray.direction, across.byV);
    const Vec2 byWorld = Vec2(alongU * vv - alongV * uv, alongV * uu - alongU * uv) / determinant;
    for (int step = 1; step <= kStartsBefore; ++step) {
        const double before = reachWorld * step / kStartsBefore;
        const auto other =
            refine(ray, {hit.place.patch, hit.place.uv + byWorld * before}, hit.distance, reachWorld);
        if (other && other->distance < first.distance) first = *other;
    }
    return first;
}

} // namespace plumbline
