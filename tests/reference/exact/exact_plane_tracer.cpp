#include "tests/reference/exact/exact_plane_tracer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline {

namespace {

// Tolerance for the corners of a rectangular mesh, as a fraction of its size.
constexpr double kAffineTolerance = 1e-12;

// Margin by which the searched layer is thicker than the relief, as a fraction of all heights involved: far
// above rounding (2^-52), and cheap, because it adds at most one cell.
constexpr double kLayerMargin = 1e-6;

// Offset of a shadow ray's origin from the hit, as a fraction of the base's size: above the rounding error of
// a hit and far below anything visible.
constexpr double kLeaveSurface = 1e-9;

/// a b - c d without cancellation (Kahan's algorithm: W. Kahan 1998, "Matlab's loss is nobody's gain").
double differenceOfProducts(double a, double b, double c, double d) {
    const double cd = c * d;
    return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/// Intersects [begin, end] with the distances at which base + slope * distance is in [low, high].
void clipToSlab(double base, double slope, double low, double high, double& begin, double& end) {
    if (slope == 0) {
        if (base < low || base > high) end = -kInfinity;
        return;
    }
    const double first = (low - base) / slope, second = (high - base) / slope;
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
}

/// d = d00 + slopeX x + slopeY y + twist x y over a cell, (x, y) in texels from its lower left corner, the
/// center of texel `cell`.
struct BilinearPatch {
    double d00, slopeX, slopeY, twist;
};

BilinearPatch patchOf(const HeightMap& map, const Vec2i& cell) {
    const double d00 = map.texel(cell.x, cell.y), d10 = map.texel(cell.x + 1, cell.y);
    const double d01 = map.texel(cell.x, cell.y + 1), d11 = map.texel(cell.x + 1, cell.y + 1);
    return {d00, d10 - d00, d01 - d00, (d11 - d01) - (d10 - d00)};
}

/// a x^2 + 2 halfB x + c.
struct Quadratic {
    double a, halfB, c;
    double at(double x) const { return (a * x + 2 * halfB) * x + c; }
};

} // namespace

FlatRelief flatRelief(const SceneObject& object) {
    if (!object.relief || !object.mesh.hasUvs())
        throw std::invalid_argument(object.name + " has no relief or no uvs");
    const ControlMesh mesh = object.meshWorld();
    Vec2 low(kInfinity), high(-kInfinity);
    for (const Vec2& uv : mesh.uvs) {
        low = glm::min(low, uv);
        high = glm::max(high, uv);
    }
    const auto pointAt = [&](const Vec2& uv) {
        for (size_t i = 0; i < mesh.faceUvs.size(); ++i)
            if (mesh.uvs[static_cast<size_t>(mesh.faceUvs[i])] == uv)
                return mesh.points[static_cast<size_t>(mesh.faceVertices[i])];
        throw std::invalid_argument(object.name + " is no rectangle in uv");
    };
    FlatRelief plane;
    plane.relief = *object.relief;
    plane.corner = pointAt(low);
    plane.edgeU = pointAt({high.x, low.y}) - plane.corner;
    plane.edgeV = pointAt({low.x, high.y}) - plane.corner;
    plane.uvCorner = low;
    plane.uvAlongU = {high.x - low.x, 0};
    plane.uvAlongV = {0, high.y - low.y};
    const auto faceCorner = [&](size_t k) { return mesh.points[static_cast<size_t>(mesh.faceVertices[k])]; };
    plane.normal = glm::normalize(glm::cross(faceCorner(1) - faceCorner(0), faceCorner(2) - faceCorner(0)));
    const double size = glm::length(plane.edgeU) + glm::length(plane.edgeV);
    for (size_t i = 0; i < mesh.faceUvs.size(); ++i) {
        const Vec2 ab = (mesh.uvs[static_cast<size_t>(mesh.faceUvs[i])] - low) / (high - low);
        const Vec3 expected = plane.corner + ab.x * plane.edgeU + ab.y * plane.edgeV;
        if (glm::length(faceCorner(i) - expected) > kAffineTolerance * size)
            throw std::invalid_argument(object.name + " isn't affine in its uvs");
    }
    return plane;
}

/// The ray as linear functions of the distance: (a, b) on the base, texels (s W, t H), height along n.
struct ExactPlaneTracer::TexelRay {
    Vec2 ab, abStep;
    Vec2 texel, texelStep;
    double height, heightStep;
};

ExactPlaneTracer::ExactPlaneTracer(FlatRelief plane) : plane_(std::move(plane)) {
    // The dual vectors: acrossU is orthogonal to edgeV and n, and likewise acrossV.
    const Vec3 acrossU = glm::cross(plane_.edgeV, plane_.normal),
               acrossV = glm::cross(plane_.normal, plane_.edgeU);
    dualU_ = acrossU / glm::dot(plane_.edgeU, acrossU);
    dualV_ = acrossV / glm::dot(plane_.edgeV, acrossV);
    const HeightMap& map = *plane_.relief.map;
    mapSize_ = {map.width(), map.height()};
    const auto [least, most] = std::minmax_element(map.depths().begin(), map.depths().end());
    lowest_ = plane_.relief.offset - plane_.relief.depth * *most;
    highest_ = plane_.relief.offset - plane_.relief.depth * *least;
}

ExactPlaneTracer::TexelRay ExactPlaneTracer::texelRay(const Ray& ray) const {
    const Vec3 fromCorner = ray.origin - plane_.corner;
    TexelRay result;
    result.ab = {glm::dot(fromCorner, dualU_), glm::dot(fromCorner, dualV_)};
    result.abStep = {glm::dot(ray.direction, dualU_), glm::dot(ray.direction, dualV_)};
    const auto texels = [&](const Vec2& ab) {
        return plane_.relief.tile * (ab.x * plane_.uvAlongU + ab.y * plane_.uvAlongV) * mapSize_;
    };
    result.texel =
        texels(result.ab) + (plane_.relief.tile * plane_.uvCorner + plane_.relief.uvOffset) * mapSize_;
    result.texelStep = texels(result.abStep);
    result.height = glm::dot(fromCorner, plane_.normal);
    result.heightStep = glm::dot(ray.direction, plane_.normal);
    return result;
}

std::optional<double> firstRootOfQuadratic(double a, double halfB, double c, double length) {
    const double discriminant = differenceOfProducts(halfB, halfB, a, c);
    if (discriminant < 0) return std::nullopt;
    // First the root without cancellation, then the other one from the product c / a (Vieta).
    const double sum = -(halfB + std::copysign(std::sqrt(discriminant), halfB));
    double roots[2] = {kInfinity, kInfinity};
    if (sum == 0) { // halfB = 0 and a c = 0
        if (c == 0) return 0.0;
        return std::nullopt;
    }
    if (a != 0) roots[0] = sum / a;
    roots[1] = c / sum;
    double first = kInfinity;
    for (const double root : roots)
        if (root >= 0 && root <= length) first = std::min(first, root);
    if (first == kInfinity) return std::nullopt;
    return first;
}

/// Traverses the cells between texel centers from `begin` to `end`. Cell (i,j) has the centers of texels
/// (i,j) and (i+1,j+1) as corners. Borders are computed from their index, so rounding errors don't
/// accumulate. The surface is continuous, so if the sign of (ray's height - relief's height) differs between
/// two ends that should agree, or between which no root was found, a root was lost to rounding; it is placed
/// at the border.
std::optional<double> ExactPlaneTracer::firstRoot(const TexelRay& ray, double begin, double end,
                                                  Vec2i& cell) const {
    const Vec2 start = ray.texel + begin * ray.texelStep - 0.5;
    cell = {static_cast<int>(std::floor(start.x)), static_cast<int>(std::floor(start.y))};
    const auto borderDistance = [&](int axis) {
        if (ray.texelStep[axis] == 0) return kInfinity;
        const int border = ray.texelStep[axis] > 0 ? cell[axis] + 1 : cell[axis];
        return (border + 0.5 - ray.texel[axis]) / ray.texelStep[axis];
    };
    const auto heightAbove = [&](double at) { // on the patch of `cell`, at distance `at`
        const Relief& relief = plane_.relief;
        const BilinearPatch patch = patchOf(*relief.map, cell);
        const Vec2 p = ray.texel + at * ray.texelStep - (Vec2(cell) + 0.5), step = ray.texelStep;
        const double byDistance =
            patch.slopeX * step.x + patch.slopeY * step.y + patch.twist * (p.x * step.y + p.y * step.x);
        const double depth = patch.d00 + patch.slopeX * p.x + patch.slopeY * p.y + patch.twist * p.x * p.y;
        return Quadratic{relief.depth * patch.twist * step.x * step.y,
                         0.5 * (ray.heightStep + relief.depth * byDistance),
                         ray.height + at * ray.heightStep - relief.offset + relief.depth * depth};
    };
    double previous = 0; // difference of heights at the end of the previous cell; 0 = none yet
    for (double at = begin; at <= end;) {
        const Vec2 border(borderDistance(0), borderDistance(1));
        const double next = std::clamp(std::min(border.x, border.y), at, std::max(at, end));
        const Quadratic above = heightAbove(at);
        if (above.c == 0 || above.c * previous < 0) return at;
        const double length = next - at;
        if (const auto root = firstRootOfQuadratic(above.a, above.halfB, above.c, length)) return at + *root;
        previous = above.at(length);
        if (previous == 0 || previous * above.c < 0) return next;
        if (next >= end) break;
        const int axis = border.x <= border.y ? 0 : 1;
        cell[axis] += ray.texelStep[axis] > 0 ? 1 : -1;
        at = next;
    }
    return std::nullopt;
}

ExactPlaneTracer::Hit ExactPlaneTracer::hitAt(const Ray& ray, double distance, const Vec2i& cell) const {
    const TexelRay line = texelRay(ray);
    const Vec2 texel = line.texel + distance * line.texelStep, p = texel - (Vec2(cell) + 0.5);
    const BilinearPatch patch = patchOf(*plane_.relief.map, cell);
    const Vec2 depthByTexel(patch.slopeX + patch.twist * p.y, patch.slopeY + patch.twist * p.x);
    const Vec2 heightByUv = -plane_.relief.depth * depthByTexel * mapSize_ * plane_.relief.tile;
    const Vec3 byA = plane_.edgeU + plane_.normal * glm::dot(heightByUv, plane_.uvAlongU);
    const Vec3 byB = plane_.edgeV + plane_.normal * glm::dot(heightByUv, plane_.uvAlongV);
    const Vec3 normal = glm::normalize(glm::cross(byA, byB));
    Hit hit;
    hit.distance = distance;
    hit.position = ray.at(distance);
    hit.normal =
        glm::dot(normal, plane_.normal) < 0 ? -normal : normal; // a relief never overhangs its own base
    hit.st = texel / mapSize_;
    hit.crossing = std::abs(glm::dot(hit.normal, ray.direction));
    return hit;
}

std::optional<ExactPlaneTracer::Hit> ExactPlaneTracer::trace(const Ray& ray, double maxDistance) const {
    const TexelRay line = texelRay(ray);
    double begin = 0, end = maxDistance;
    clipToSlab(line.ab.x, line.abStep.x, 0, 1, begin, end);
    clipToSlab(line.ab.y, line.abStep.y, 0, 1, begin, end);
    const double margin = kLayerMargin * (std::abs(line.height) + std::abs(lowest_) + std::abs(highest_));
    clipToSlab(line.height, line.heightStep, lowest_ - margin, highest_ + margin, begin, end);
    if (!(begin <= end)) return std::nullopt;
    Vec2i cell;
    const auto root = firstRoot(line, begin, end, cell);
    if (!root) return std::nullopt;
    return hitAt(ray, *root, cell);
}

bool ExactPlaneTracer::occluded(const Vec3& origin, const Vec3& direction, double maxDistance) const {
    return trace({origin, direction}, maxDistance).has_value();
}

bool ExactPlaneTracer::shadowed(const Hit& hit, const Vec3& toCamera, const LightSample& light) const {
    const Vec3 facing = glm::dot(hit.normal, toCamera) < 0 ? -hit.normal : hit.normal;
    if (glm::dot(facing, light.toLightWorld) <= 0) return true;
    const double size = glm::length(plane_.edgeU) + glm::length(plane_.edgeV);
    return occluded(hit.position + facing * (kLeaveSurface * size), light.toLightWorld, light.distance);
}

} // namespace plumbline
