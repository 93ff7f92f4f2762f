#include "scenes/mesh/outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace plumbline {

namespace {

/// Sine of a turn the wrong way up to which a corner counts as straight. Coordinates that a file rounds to
/// six digits give 1e-6 on an edge as long as the mesh and 1e-4 on one of a hundredth of it; a quad folds
/// there by as little of an edge.
constexpr double kStraightSine = 1e-4;
/// Area vectors below this fraction of the squared perimeter have canceled: an 8 has none. Rounding leaves
/// 1e-15.
constexpr double kNoArea = 1e-9;
/// Three points within this fraction of their squared distances are on a line: 16 roundings of a double.
constexpr double kCollinear = 0x1p-48;

double cross2(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Twice the area of a triangle, 0 if it is within rounding: positive if it is counterclockwise.
double turnOf(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 e = b - a, f = c - a;
    const double twice = cross2(e, f);
    return std::abs(twice) > kCollinear * (glm::dot(e, e) + glm::dot(f, f)) ? twice : 0;
}

/// The direction from which the outline is seen; zero if all points are on a line.
Vec3 bestNormal(const ControlMesh& mesh, const MeshFace& face) {
    const Vec3& origin = mesh.pointAt(face.firstCorner);
    Vec3 area(0), largest(0);
    double perimeter = 0;
    for (size_t k = 0; k < face.size; ++k) {
        const Vec3 a = mesh.pointAt(face.corner(k)) - origin, b = mesh.pointAt(face.corner(k + 1)) - origin;
        const Vec3 triangle = glm::cross(a, b);
        area += triangle;
        if (glm::length(triangle) > glm::length(largest)) largest = triangle;
        perimeter += glm::length(b - a);
    }
    const double least = kNoArea * perimeter * perimeter;
    return glm::length(area) > least      ? glm::normalize(area)
           : glm::length(largest) > least ? glm::normalize(largest)
                                          : Vec3(0);
}

std::vector<Vec2> flattened(const ControlMesh& mesh, const MeshFace& face, const Vec3& normal) {
    const Vec3 size = glm::abs(normal);
    const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                      : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                           : Vec3(0, 0, 1);
    const Vec3 right = glm::normalize(glm::cross(axis, normal)), up = glm::cross(normal, right);
    const Vec3& origin = mesh.pointAt(face.firstCorner);
    std::vector<Vec2> points;
    for (size_t k = 0; k < face.size; ++k) {
        const Vec3 at = mesh.pointAt(face.corner(k)) - origin;
        points.emplace_back(glm::dot(at, right), glm::dot(at, up));
    }
    return points;
}

/// Turns left everywhere, once around in all.
bool isConvex(const std::vector<Vec2>& points) {
    std::vector<Vec2> edges;
    for (size_t i = 0; i < points.size(); ++i)
        if (const Vec2 edge = points[(i + 1) % points.size()] - points[i]; edge != Vec2(0))
            edges.push_back(glm::normalize(edge));
    double turned = 0;
    for (size_t i = 0; i < edges.size(); ++i) {
        const Vec2 &edge = edges[i], &next = edges[(i + 1) % edges.size()];
        const double sine = cross2(edge, next), cosine = glm::dot(edge, next);
        if (sine < -kStraightSine || (cosine < 0 && sine < kStraightSine)) return false; // or turns back
        turned += std::atan2(sine, cosine);
    }
    return turned < 3 * kPi; // 2 pi, or more for a star
}

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return turnOf(a, b, c) * turnOf(a, b, d) < 0 && turnOf(c, d, a) * turnOf(c, d, b) < 0;
}

/// Whether two edges cross, beyond touching. Compares those whose extents in x overlap.
bool crossesItself(const std::vector<Vec2>& points) {
    const auto end = [&](size_t edge) { return points[(edge + 1) % points.size()]; };
    const auto low = [&](size_t edge) { return std::min(points[edge].x, end(edge).x); };
    const auto high = [&](size_t edge) { return std::max(points[edge].x, end(edge).x); };
    std::vector<size_t> order(points.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return low(i) < low(j); });
    for (size_t i = 0; i < order.size(); ++i)
        for (size_t j = i + 1; j < order.size() && low(order[j]) <= high(order[i]); ++j)
            if (cross(points[order[i]], end(order[i]), points[order[j]], end(order[j]))) return true;
    return false;
}

/// The part of the outline that isn't cut off yet, as a ring.
class EarClipper {
  public:
    explicit EarClipper(const std::vector<Vec2>& points)
        : points_(points), next_(points.size()), previous_(points.size()) {
        for (size_t i = 0; i < points.size(); ++i) {
            next_[i] = (i + 1) % points.size();
            previous_[next_[i]] = i;
        }
        for (size_t i = 0; i < points.size(); ++i)
            if (turnAt(i) <= 0) blockers_.push_back(i);
    }

    std::vector<std::array<size_t, 3>> clip() {
        std::vector<std::array<size_t, 3>> triangles;
        size_t left = points_.size(), at = 0, passed = 0;
        Strictness strictness = Strictness::Closed;
        while (left > 3) {
            if (isEar(at, strictness)) {
                if (turnAt(at) > 0) triangles.push_back({previous_[at], at, next_[at]});
                at = remove(at);
                --left;
                passed = 0;
                strictness = Strictness::Closed;
            } else if (++passed > left) { // only where the outline touches itself
                if (strictness == Strictness::Any) break;
                strictness = strictness == Strictness::Closed ? Strictness::Open : Strictness::Any;
                passed = 0;
            } else {
                at = next_[at];
            }
        }
        if (turnAt(at) > 0) triangles.push_back({previous_[at], at, next_[at]});
        return triangles;
    }

  private:
    /// What must not be in an ear: other corners, on its border either; corners inside it; anything (then an
    /// ear only needs to have no negative area).
    enum class Strictness { Closed, Open, Any };

    double turnAt(size_t i) const { return turnOf(points_[previous_[i]], points_[i], points_[next_[i]]); }

    size_t remove(size_t i) {
        next_[previous_[i]] = next_[i];
        previous_[next_[i]] = previous_[i];
        std::erase_if(blockers_, [&](size_t j) {
            return j == i || ((j == previous_[i] || j == next_[i]) && turnAt(j) > 0);
        });
        return next_[next_[i]]; // not the next one: fans of slivers
    }

    bool isEar(size_t i, Strictness strictness) const {
        const Vec2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
        const double turn = turnAt(i);
        if (strictness == Strictness::Any) return turn >= 0 || a == c;
        if (!(turn > 0)) return a == b || b == c;
        // Only corners that don't turn left can be the first ones inside.
        return std::none_of(blockers_.begin(), blockers_.end(), [&](size_t j) {
            const Vec2& p = points_[j];
            if (p == a || p == b || p == c) return false;
            const double least = std::min({turnOf(a, b, p), turnOf(b, c, p), turnOf(c, a, p)});
            return strictness == Strictness::Closed ? least >= 0 : least > 0;
        });
    }

    const std::vector<Vec2>& points_;
    std::vector<size_t> next_, previous_;
    std::vector<size_t> blockers_; // corners left that don't turn left
};

} // namespace

Outline outlineOf(const ControlMesh& mesh, const MeshFace& face) {
    if (face.size == 3) return {};
    const Vec3 normal = bestNormal(mesh, face);
    if (normal == Vec3(0)) return {};
    std::vector<Vec2> points = flattened(mesh, face, normal);
    if (isConvex(points)) return {};
    const OutlineKind kind = crossesItself(points) ? OutlineKind::Crossing : OutlineKind::Concave;
    return {kind, std::move(points)};
}

std::vector<std::array<size_t, 3>> cutOutline(const std::vector<Vec2>& points) {
    assert(points.size() >= 3);
    return EarClipper(points).clip();
}

} // namespace plumbline
