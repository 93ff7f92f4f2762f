#include "reference/certify/uncertain.h"

#include "reference/certify/edge_pieces.h"
#include "reference/trace/embree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace plumbline {

namespace {

// A contour counts as hidden when both sides of it are nearer by that many of its errors.
constexpr double kHiddenErrors = 8;

/// Set by many threads; all write the same value.
void mark(float& uncertain) {
    std::atomic_ref<float>(uncertain).store(1, std::memory_order_relaxed);
}
bool isMarked(float& uncertain) {
    return std::atomic_ref<float>(uncertain).load(std::memory_order_relaxed) != 0;
}

class CoverageMarker {
  public:
    CoverageMarker(const Camera& camera, const EmbreeScene& embree, std::span<const float> ids,
                   std::span<float> uncertain, std::span<float> otherSheet)
        : embree_(embree), ids_(ids), uncertain_(uncertain), otherSheet_(otherSheet), rays_(camera),
          width_(camera.width), height_(camera.height) {}

    void consider(const EdgePiece& piece) const {
        const auto firstCenter = [&](double a, double b) {
            return std::max(std::ceil(std::min(a, b) - piece.reach - 0.5), 0.0);
        };
        const auto lastCenter = [&](double a, double b, int size) {
            return std::min(std::floor(std::max(a, b) + piece.reach - 0.5), size - 1.0);
        };
        const int x0 = static_cast<int>(firstCenter(piece.a.x, piece.b.x)),
                  x1 = static_cast<int>(lastCenter(piece.a.x, piece.b.x, width_));
        const int y0 = static_cast<int>(firstCenter(piece.a.y, piece.b.y)),
                  y1 = static_cast<int>(lastCenter(piece.a.y, piece.b.y, height_));
        std::optional<Sides> sides;
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const size_t pixel = indexIn(width_, x, y);
                const Vec2 center(x + 0.5, y + 0.5);
                if (glm::length(Vec2(piece.nearest(center)) - center) > piece.reach ||
                    (isMarked(uncertain_[pixel]) && isMarked(otherSheet_[pixel])))
                    continue;
                if (!sides) sides = sidesOf(piece);
                const int id = static_cast<int>(ids_[pixel]);
                if (sides->inside != id || sides->outside != id) mark(uncertain_[pixel]);
                if (sides->visible) mark(otherSheet_[pixel]);
            }
    }

  private:
    struct Sides {
        int inside, outside; // ids seen beside the contour
        bool visible;        // nothing hides it
    };

    Sides sidesOf(const EdgePiece& piece) const {
        double insideDepth = kInfinity, outsideDepth = kInfinity;
        Sides sides{look(piece.justInside(), insideDepth), look(piece.justOutside(), outsideDepth), false};
        // Hidden: on both sides something is nearer than the contour by more than both's errors explain.
        sides.visible =
            std::max(insideDepth, outsideDepth) >= piece.middle().z - kHiddenErrors * piece.errorWorld;
        return sides;
    }

    /// Id and planar depth of what is seen at a pixel.
    int look(const Vec3& pixel, double& depth) const {
        const Ray ray = rays_.ray(pixel.x, pixel.y);
        const auto hit = embree_.intersectSeen(ray.origin, ray.direction);
        if (!hit) return 0;
        depth = rays_.planarDepth(ray.at(hit->distance));
        return static_cast<int>(hit->object) + 1;
    }

    const EmbreeScene& embree_;
    std::span<const float> ids_;
    std::span<float> uncertain_, otherSheet_;
    CameraRays rays_;
    int width_, height_;
};

/// Shadow points on a light's screen, in square bins of one pixel.
class PointBins {
  public:
    struct Point {
        Vec3 at;      // projected
        double shift; // of its ray, pixels
        uint32_t pixel;
        bool shadow;
    };

    /// Points outside [0, columns) x [0, rows) are left out.
    PointBins(const Screen& screen, const std::vector<ShadowPoint>& points, int columns, int rows)
        : columns_(columns), rows_(rows) {
        for (const ShadowPoint& point : points) {
            const Vec3 at = screen.project(point.positionWorld);
            if (screen.inFront(at) && at.x >= 0 && at.y >= 0 && at.x < columns && at.y < rows)
                points_.push_back(
                    {at, point.shiftWorld * screen.pixelsPerWorld(at), point.pixel, point.shadow});
        }
        tbb::parallel_sort(points_.begin(), points_.end(), [&](const Point& a, const Point& b) {
            const size_t i = binOf(a), j = binOf(b);
            return i != j ? i < j : a.pixel < b.pixel;
        });
        for (const Point& point : points_)
            largestShift_ = std::max(largestShift_, point.shift);
        first_.assign(areaOf(columns, rows) + 1, points_.size());
        for (size_t i = points_.size(); i-- > 0;)
            first_[binOf(points_[i])] = i;
        for (size_t bin = first_.size() - 1; bin-- > 0;)
            first_[bin] = std::min(first_[bin], first_[bin + 1]);
    }

    bool empty() const { return points_.empty(); }
    double largestShift() const { return largestShift_; }

    /// Calls visit for the points in a rectangle of pixels, and some around it.
    template <typename Visit>
    void forEachNear(const Vec2& low, const Vec2& high, Visit visit) const {
        const int x0 = static_cast<int>(std::clamp(low.x, 0.0, double(columns_)));
        const int x1 = static_cast<int>(std::clamp(high.x, -1.0, columns_ - 1.0));
        const int y0 = static_cast<int>(std::clamp(low.y, 0.0, double(rows_)));
        const int y1 = static_cast<int>(std::clamp(high.y, -1.0, rows_ - 1.0));
        if (x0 > x1 || high.x < 0 || high.y < 0) return;
        for (int y = y0; y <= y1; ++y)
            for (size_t i = first_[indexIn(columns_, x0, y)]; i < first_[indexIn(columns_, x1, y) + 1]; ++i)
                visit(points_[i]);
    }

  private:
    size_t binOf(const Point& point) const {
        return indexIn(columns_, static_cast<int>(point.at.x), static_cast<int>(point.at.y));
    }

    int columns_, rows_;
    std::vector<Point> points_;
    std::vector<size_t> first_; // per bin, and the end
    double largestShift_ = 0;
};

/// One screen of one light.
class ShadowMarker {
  public:
    ShadowMarker(const Light& light, const Screen& screen, const PointBins& bins, const EmbreeScene& embree,
                 std::span<float> uncertain)
        : light_(light), screen_(screen), bins_(bins), embree_(embree), uncertain_(uncertain) {}

    void consider(const EdgePiece& piece) const {
        const double farthest = piece.reach + bins_.largestShift();
        const Vec2 low = glm::min(Vec2(piece.a), Vec2(piece.b)) - farthest;
        const Vec2 high = glm::max(Vec2(piece.a), Vec2(piece.b)) + farthest;
        bool known = false, open = false;
        bins_.forEachNear(low, high, [&](const PointBins::Point& point) {
            const Vec3 nearest = piece.nearest(Vec2(point.at));
            if (glm::length(Vec2(nearest) - Vec2(point.at)) > piece.reach + point.shift ||
                isMarked(uncertain_[point.pixel]))
                return;
            if (nearest.z > point.at.z + piece.errorWorld) return; // the contour is behind the point
            // In the light: the micro-triangle may come between. In shadow: light may come past its edge, if
            // nothing else stops it.
            if (!point.shadow) return mark(uncertain_[point.pixel]);
            if (!known) {
                open = isOpenBeyond(piece);
                known = true;
            }
            if (open) mark(uncertain_[point.pixel]);
        });
    }

  private:
    /// Whether light comes past an edge, or would if the ones just behind it moved too, as they may.
    bool isOpenBeyond(const EdgePiece& piece) const {
        for (const double share : {0.0, 0.5, 1.0, 2.0})
            if (isOpen(piece.outside(share))) return true;
        return false;
    }

    /// Whether the light reaches a place on its screen, at the depth of a contour.
    bool isOpen(const Vec3& beside) const {
        const Vec3 place = screen_.unproject(beside);
        const LightSample sample = sampleLight(light_, place);
        return !embree_.occluded(place, sample.toLightWorld, static_cast<float>(sample.distance));
    }

    const Light& light_;
    const Screen& screen_;
    const PointBins& bins_;
    const EmbreeScene& embree_;
    std::span<float> uncertain_;
};

template <typename Marker>
void considerAll(const std::vector<ContourFinder>& contours, const Screen& screen, const Vec2& pictureSize,
                 const Marker& marker) {
    for (const ContourFinder& finder : contours)
        finder.forEach(screen.viewpoint(), [&](const ContourEdge& edge) {
            const FlushDenormals flush;
            forEachPiece(screen, edge, pictureSize, [&](const EdgePiece& piece) { marker.consider(piece); });
        });
}

} // namespace

void markUncertainCoverage(const Camera& camera, const std::vector<ContourFinder>& contours,
                           const EmbreeScene& embree, std::span<const float> ids, std::span<float> uncertain,
                           std::span<float> otherSheet) {
    const CoverageMarker marker(camera, embree, ids, uncertain, otherSheet);
    considerAll(contours, Screen::ofCamera(camera), Vec2(camera.width, camera.height), marker);
}

void markUncertainShadow(const Light& light, const std::vector<ContourFinder>& contours,
                         const EmbreeScene& embree, const std::vector<ShadowPoint>& points,
                         std::span<float> uncertain) {
    if (points.empty()) return;
    // About one point a bin.
    const int side = static_cast<int>(std::clamp(std::sqrt(static_cast<double>(points.size())), 1.0, 4096.0));
    const auto markOn = [&](const Screen& screen, int columns, int rows) {
        const PointBins bins(screen, points, columns, rows);
        if (bins.empty()) return;
        const ShadowMarker marker(light, screen, bins, embree, uncertain);
        considerAll(contours, screen, Vec2(columns, rows), marker);
    };
    if (light.kind == Light::Kind::Point) {
        for (int face = 0; face < 6; ++face)
            markOn(Screen::ofCubeFace(light.positionWorld, face, side), side, side);
        return;
    }
    const Screen unit = Screen::ofDistantLight(light.toLightWorld, points[0].positionWorld, 1);
    Vec2 low(kInfinity), high(-kInfinity);
    for (const ShadowPoint& point : points) {
        const Vec2 at(unit.project(point.positionWorld));
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const Vec2 size = glm::max(high - low, Vec2(1e-30));
    const double pixelWorld = std::max({size.x / side, size.y / side, std::sqrt(size.x * size.y) / side});
    const Vec3 corner = unit.unproject({low.x, low.y, 0});
    const int columns = static_cast<int>(size.x / pixelWorld) + 2,
              rows = static_cast<int>(size.y / pixelWorld) + 2;
    markOn(Screen::ofDistantLight(light.toLightWorld, corner, pixelWorld), columns, rows);
}

} // namespace plumbline
