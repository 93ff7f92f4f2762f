#include "tests/reference/exact/exact_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {

namespace {

constexpr int kDirections = 16;
constexpr double kNarrowestBandPx = 1.0 / 1024, kWidestBandPx = 8;
constexpr size_t kLinesKept = 5;
constexpr int kMaxBands =
    500; // maximum number of pixels whose band is computed, because it is slow for entirely wrong frames

/// Visits points around a point, at the radius and at half of it, until `visit` returns true.
template <typename Visit>
bool anyAround(const Vec2& place, double radiusPx, Visit visit) {
    for (const double radius : {radiusPx, radiusPx / 2})
        for (int k = 0; k < kDirections; ++k) {
            const double angle = 2 * kPi * k / kDirections;
            if (visit(place + radius * Vec2(std::cos(angle), std::sin(angle)))) return true;
        }
    return false;
}

/// The smallest power of two, in pixels, for which `holds` returns true.
template <typename Holds>
double smallestBand(Holds holds) {
    for (double radius = kNarrowestBandPx; radius <= kWidestBandPx; radius *= 2)
        if (holds(radius)) return radius;
    return kInfinity;
}

/// Difference of two depths; 0 for two misses.
double depthGap(double a, double b) {
    return a == b ? 0 : std::abs(a - b);
}

} // namespace

ExactPicture::ExactPicture(const Scene& scene)
    : scene_(scene), rays_(scene.camera), tracer_(flatRelief(scene.objects.at(0))) {}

double ExactPicture::depthAt(const Vec2& place) const {
    const auto hit = tracer_.trace(rays_.ray(place.x, place.y));
    return hit ? rays_.planarDepth(hit->position) : kInfinity;
}

std::vector<bool> ExactPicture::shadowsAt(const Vec2& place) const {
    std::vector<bool> shadows;
    const Ray ray = rays_.ray(place.x, place.y);
    if (const auto hit = tracer_.trace(ray))
        for (const Light& light : scene_.lights)
            shadows.push_back(tracer_.shadowed(*hit, -ray.direction, sampleLight(light, hit->position)));
    return shadows;
}

bool ExactPicture::coverageCouldFlip(const Vec2& place, double radiusPx) const {
    const bool covered = std::isfinite(depthAt(place));
    return anyAround(place, radiusPx,
                     [&](const Vec2& other) { return std::isfinite(depthAt(other)) != covered; });
}

bool ExactPicture::shadowCouldFlip(const Vec2& place, size_t light, double radiusPx) const {
    const std::vector<bool> here = shadowsAt(place);
    return anyAround(place, radiusPx, [&](const Vec2& other) {
        const std::vector<bool> there = shadowsAt(other);
        return there.empty() != here.empty() || (!here.empty() && there[light] != here[light]);
    });
}

/// Bisects the segment from a to b, keeping the half over which the depth changes more. The change tends to 0
/// for a slope, to 1e-7 of its value after 45 bisections for the square root at a fold, and is constant for a
/// jump.
bool ExactPicture::depthJumpsBetween(Vec2 a, Vec2 b, double atLeast) const {
    double depthA = depthAt(a), depthB = depthAt(b);
    for (int halving = 0; halving < 45 && depthGap(depthA, depthB) > atLeast; ++halving) {
        const Vec2 middle = 0.5 * (a + b);
        const double depth = depthAt(middle);
        if (depthGap(depthA, depth) > depthGap(depth, depthB)) {
            b = middle;
            depthB = depth;
        } else {
            a = middle;
            depthA = depth;
        }
    }
    return depthGap(depthA, depthB) > atLeast;
}

bool ExactPicture::depthCouldJumpTo(const Vec2& place, double radiusPx, double depth) const {
    const double here = depthAt(place);
    return anyAround(place, radiusPx, [&](const Vec2& other) {
        const double there = depthAt(other);
        if (there == kInfinity) return false;
        // The surface on the other side continues behind this one or ends in front of it; twice the distance
        // to it is sufficient.
        const double reach = 2 * depthGap(here, there) + kSameDepth * here;
        return std::abs(depth - here) <= reach && depthJumpsBetween(place, other, kSameDepth * here);
    });
}

namespace {

class FrameComparer {
  public:
    FrameComparer(const Scene& scene, const Frame& frame, double jumpRadiusPx)
        : scene_(scene), frame_(frame), picture_(scene), jumpRadiusPx_(jumpRadiusPx) {}

    Comparison compare() {
        for (int y = 0; y < frame_.height(); ++y)
            for (int x = 0; x < frame_.width(); ++x)
                comparePixel(x, y);
        return result_;
    }

  private:
    void comparePixel(int x, int y) {
        const size_t pixel = static_cast<size_t>(y * frame_.width() + x);
        const Vec2 place(x + 0.5, y + 0.5);
        const double exact = picture_.depthAt(place);
        const bool covered = frame_.channel("A")[pixel] == 1;
        ++result_.pixels;
        result_.covered += std::isfinite(exact);
        if (flag("uncertain", pixel)) {
            ++result_.uncertain;
        } else if (covered != std::isfinite(exact)) {
            ++result_.coverageWrong;
            widen(result_.coverageBandPx,
                  [&](double radius) { return picture_.coverageCouldFlip(place, radius); });
            note(x, y, covered ? "covered, exactly it isn't" : "not covered, exactly it is");
        } else if (covered && compareDepth(x, y, exact)) {
            compareShadows(x, y);
        }
    }

    /// Returns false if the frame shows another part of the surface, whose shadow isn't comparable.
    bool compareDepth(int x, int y, double exact) {
        const Vec2 place(x + 0.5, y + 0.5);
        const double depth = frame_.channel("Z")[static_cast<size_t>(y * frame_.width() + x)];
        const double error = std::abs(depth - exact) / exact;
        ++result_.depthCompared;
        if (error <= kSameDepth) {
            result_.worstDepth = std::max(result_.worstDepth, error);
            return true;
        }
        if (picture_.depthCouldJumpTo(place, jumpRadiusPx_, depth)) {
            ++result_.depthJumped;
            widen(result_.depthBandPx,
                  [&](double radius) { return picture_.depthCouldJumpTo(place, radius, depth); });
        } else {
            ++result_.depthWrong;
            note(x, y, fmt::format("depth {:.9g}, exactly {:.9g}", depth, exact));
        }
        return false;
    }

    void compareShadows(int x, int y) {
        const size_t pixel = static_cast<size_t>(y * frame_.width() + x);
        const Vec2 place(x + 0.5, y + 0.5);
        const std::vector<bool> exact = picture_.shadowsAt(place);
        for (size_t i = 0; i < exact.size(); ++i) {
            const std::string& light = scene_.lights[i].name;
            if (flag(uncertainShadowChannel(light), pixel)) {
                ++result_.shadowUncertain;
                continue;
            }
            ++result_.shadowCompared;
            if (frame_.channel(shadowChannel(light))[pixel] == (exact[i] ? 1 : 0)) continue;
            ++result_.shadowWrong;
            widen(result_.shadowBandPx,
                  [&](double radius) { return picture_.shadowCouldFlip(place, i, radius); });
            note(x, y,
                 fmt::format("{} from {}", exact[i] ? "lit, exactly in shadow" : "in shadow, exactly lit",
                             light));
        }
    }

    bool flag(const std::string& channel, size_t pixel) const {
        return frame_.has(channel) && frame_.channel(channel)[pixel] == 1;
    }

    template <typename Holds>
    void widen(double& band, Holds holds) {
        if (band < kWidestBandPx && bandsLeft_-- > 0) band = std::max(band, smallestBand(holds));
    }

    void note(int x, int y, const std::string& what) {
        if (result_.firstWrong.size() < kLinesKept)
            result_.firstWrong.push_back(fmt::format("pixel {} {}: {}", x, y, what));
    }

    const Scene& scene_;
    const Frame& frame_;
    ExactPicture picture_;
    double jumpRadiusPx_;
    int bandsLeft_ = kMaxBands;
    Comparison result_;
};

} // namespace

std::string Comparison::summary() const {
    return fmt::format("{} pixels, {} covered, {} uncertain; coverage wrong {} (band {} px); depth of {}: "
                       "wrong {}, jumped {} (band {} "
                       "px), else within {:.1e}; shadow of {}, {} uncertain, wrong {} (band {} px)",
                       pixels, covered, uncertain, coverageWrong, coverageBandPx, depthCompared, depthWrong,
                       depthJumped, depthBandPx, worstDepth, shadowCompared, shadowUncertain, shadowWrong,
                       shadowBandPx);
}

Comparison compareWithExact(const Scene& scene, const Frame& frame, double jumpRadiusPx) {
    return FrameComparer(scene, frame, jumpRadiusPx).compare();
}

} // namespace plumbline
