#include "reference/certify/edge_pieces.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plumbline {

namespace {

// Pixels. An edge is judged by its middle, so its pieces must be short.
constexpr double kPiecePixels = 0.5;
// ... or short against the distance at which they matter.
constexpr double kPieceOfReach = 0.25;
// Pixels beside an edge at which "beside" is looked at: above what a float ray tells apart (2^-24 of 1e4
// pixels), below the pieces.
constexpr double kBeside = 0x1p-7;
// An edge is cut off nearer to the viewer than that fraction of its farther end's distance: rounding of its
// points.
constexpr double kNear = 0x1p-48;

/// A part of a segment; fractions of its length in world space.
struct Part {
    double from = 0, to = 1;
    bool empty() const { return from > to; }
    /// Leaves only the part where a function linear in world space, with these values at the ends, isn't
    /// negative.
    void keepPositive(double atStart, double atEnd) {
        if (atStart < 0 && atEnd < 0)
            to = -1;
        else if (atStart < 0)
            from = std::max(from, atStart / (atStart - atEnd));
        else if (atEnd < 0)
            to = std::min(to, atStart / (atStart - atEnd));
    }
};

/// The part of a segment that is in front of the viewer, and in the picture or at most `margin` pixels beside
/// it. `a`, `b`: its ends in homogeneous pixel coordinates.
Part partNearPicture(const Vec3& a, const Vec3& b, const Vec2& pictureSize, double margin) {
    Part part;
    const double near = kNear * std::max(std::abs(a.z), std::abs(b.z));
    part.keepPositive(a.z - near, b.z - near);
    for (int axis = 0; axis < 2; ++axis) {
        part.keepPositive(a[axis] + margin * a.z, b[axis] + margin * b.z);
        const double end = pictureSize[axis] + margin;
        part.keepPositive(end * a.z - a[axis], end * b.z - b[axis]);
    }
    return part;
}

/// At least the largest number of pixels per world unit along a segment; infinite if a part is behind the
/// viewer.
double maxPixelsPerWorld(const Screen& screen, const ContourEdge& edge, double wA, double wB) {
    const double nearest = std::min(wA, wB);
    if (!(nearest > 0)) return kInfinity;
    // In perspective it is the distance to the viewer, convex along the segment, divided by the squared
    // depth.
    const auto timesSquaredDepth = [&](const Vec3& world, double w) {
        return screen.pixelsPerWorld(screen.project(world)) * w * w;
    };
    return std::max(timesSquaredDepth(edge.a, wA), timesSquaredDepth(edge.b, wB)) / (nearest * nearest);
}

} // namespace

Vec3 EdgePiece::nearest(const Vec2& pixel) const {
    const Vec2 along(b - a), from = pixel - Vec2(a);
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(from, along) / square, 0.0, 1.0) : 0;
    return a + t * (b - a);
}

Vec3 EdgePiece::justInside() const {
    const Vec2 centroid = (Vec2(a) + Vec2(b) + Vec2(third)) / 3.0, off = centroid - Vec2(middle());
    const double length = glm::length(off);
    return middle() + (length > 0 ? Vec3(off * std::min(kBeside / length, 0.5), 0) : Vec3(0));
}

Vec3 EdgePiece::outside(double ofReach) const {
    const Vec2 along(b - a);
    const Vec2 across(-along.y, along.x);
    const double length = glm::length(across);
    if (!(length > 0)) return middle();
    const double side = glm::dot(Vec2(third) - Vec2(a), across) > 0 ? -1 : 1;
    return middle() + Vec3(across * (side * (kBeside + ofReach * reach) / length), 0);
}

void forEachPiece(const Screen& screen, const ContourEdge& edge, const Vec2& pictureSize,
                  const std::function<void(const EdgePiece&)>& visit) {
    assert(edge.errorWorld >= 0);
    const double largestReach = glm::length(pictureSize);
    const auto reachOf = [&](double pixelsPerWorld) {
        return edge.errorWorld > 0 ? std::min(edge.errorWorld * pixelsPerWorld, largestReach) : 0;
    };
    const Vec3 a = screen.projectHomogeneous(edge.a), b = screen.projectHomogeneous(edge.b);
    const double margin = reachOf(maxPixelsPerWorld(screen, edge, a.z, b.z));
    const Part part = partNearPicture(a, b, pictureSize, margin);
    if (part.empty()) return;
    const Vec3 startWorld = glm::mix(edge.a, edge.b, part.from), endWorld = glm::mix(edge.a, edge.b, part.to);
    const Vec3 start = screen.project(startWorld), end = screen.project(endWorld);
    if (!screen.inFront(start) || !screen.inFront(end)) return;
    Vec3 third = screen.project(edge.third);
    if (!screen.inFront(third)) third = 0.5 * (start + end);
    const auto reach = [&](const Vec3& from, const Vec3& to) {
        return reachOf(std::max(screen.pixelsPerWorld(from), screen.pixelsPerWorld(to)));
    };
    const double pieces =
        glm::length(Vec2(end - start)) / std::max(kPiecePixels, kPieceOfReach * reach(start, end));
    const int count = pieces > 1 ? static_cast<int>(std::ceil(pieces)) : 1;
    const double wStart = glm::mix(a.z, b.z, part.from), wEnd = glm::mix(a.z, b.z, part.to);
    Vec3 from = start;
    for (int i = 1; i <= count; ++i) {
        // Equal steps on the screen, where a perspective viewer sees the near part of the edge longer.
        const double onScreen = double(i) / count;
        const double inWorld = onScreen * wStart / glm::mix(wEnd, wStart, onScreen);
        const Vec3 to = i == count ? end : screen.project(glm::mix(startWorld, endWorld, inWorld));
        visit({from, to, third, reach(from, to), edge.errorWorld});
        from = to;
    }
}

} // namespace plumbline
