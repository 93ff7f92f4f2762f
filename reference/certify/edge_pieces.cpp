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
// Nearer to the viewer than that, as a fraction of the other end's depth, an edge is cut off.
constexpr double kNear = 1e-6;

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

void forEachPiece(const Screen& screen, const ContourEdge& edge, double largestReach,
                  const std::function<void(const EdgePiece&)>& visit) {
    assert(edge.errorWorld >= 0 && largestReach >= 0);
    Vec3 aWorld = edge.a, bWorld = edge.b;
    Vec3 a = screen.project(aWorld), b = screen.project(bWorld);
    if (!screen.inFront(a) && !screen.inFront(b)) return;
    if (!screen.inFront(a) || !screen.inFront(b)) { // cut at a plane just in front of the viewer
        const bool behindA = !screen.inFront(a);
        const double front = behindA ? b.z : a.z, behind = behindA ? a.z : b.z;
        const Vec3 cut = glm::mix(behindA ? bWorld : aWorld, behindA ? aWorld : bWorld,
                                  front * (1 - kNear) / (front - behind));
        (behindA ? aWorld : bWorld) = cut;
        (behindA ? a : b) = screen.project(cut);
        if (!screen.inFront(a) || !screen.inFront(b)) return;
    }
    Vec3 third = screen.project(edge.third);
    if (!screen.inFront(third)) third = 0.5 * (a + b);
    const double length = glm::length(Vec2(b - a));
    const double pixels = std::max(screen.pixelsPerWorld(a), screen.pixelsPerWorld(b));
    const double reach = std::min(edge.errorWorld * pixels, largestReach);
    const double piece = std::max(kPiecePixels, kPieceOfReach * reach);
    const int count = static_cast<int>(std::clamp(std::ceil(length / piece), 1.0, 4096.0));
    Vec3 from = a;
    for (int i = 1; i <= count; ++i) {
        const Vec3 to = count == 1 ? b : screen.project(glm::mix(aWorld, bWorld, double(i) / count));
        visit({from, to, third,
               std::min(edge.errorWorld * std::max(screen.pixelsPerWorld(from), screen.pixelsPerWorld(to)),
                        largestReach),
               edge.errorWorld});
        from = to;
    }
}

} // namespace plumbline
