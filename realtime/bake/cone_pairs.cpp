#include "realtime/bake/cone_pairs.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

// From four half-diagonals on, a texel is small relative to the offset: the closed form of phi is within 4 %
// of the offset's length.
constexpr double kFarHalfDiagonals = 4;

// Compensates for rounding up of a length: far above 2^-52 and far below a float's last bit.
constexpr double kRoundedDown = 1 - 1e-12;

/// Largest g b over g in `slopes`, b in [k - 1, k + 1]. It is convex in g, so its maximum is at an end.
double largestProduct(const Vec2& slopes, int k) {
    return std::max(slopes.x * k + std::abs(slopes.x), slopes.y * k + std::abs(slopes.y));
}

int signOf(int k) {
    return (k > 0) - (k < 0);
}

} // namespace

CellSlopes cellSlopes(const HeightMap::Cell& c) {
    const double below = c.d10 - c.d00, above = c.d11 - c.d01, left = c.d01 - c.d00, right = c.d11 - c.d10;
    return {{std::min(below, above), std::max(below, above)},
            {std::min(left, right), std::max(left, right)},
            std::min(std::min(c.d00, c.d10), std::min(c.d01, c.d11))};
}

bool exitPossible(const CellSlopes& cell, int ks, int kt, double rayStart) {
    return largestProduct(cell.s, ks) + largestProduct(cell.t, kt) > rayStart * cell.least;
}

ConePairs::ConePairs(const HeightMap& map, ConeSlice slice, ConeRule rule)
    : map_(map), slice_(slice), rule_(rule), perWidth_(1.0 / map.width()), perHeight_(1.0 / map.height()) {
    if (slice == ConeSlice::Texels) return;
    halfDiagonalSquared_ = 0.25 * (perWidth_ * perWidth_ + perHeight_ * perHeight_);
    closedFormFrom_ = kFarHalfDiagonals * kFarHalfDiagonals * halfDiagonalSquared_;
    const double radius = std::sqrt(closedFormFrom_);
    nearColumns_ = static_cast<int>(radius / perWidth_) + 2;
    const int rows = static_cast<int>(radius / perHeight_) + 2;
    for (int kt = 0; kt < rows; ++kt)
        for (int ks = 0; ks < nearColumns_; ++ks) {
            const double distance = computeNearDistance(ks, kt);
            nearSquared_.push_back(distance * distance);
        }
}

double ConePairs::nearDistanceSquared(int ks, int kt) const {
    if (slice_ == ConeSlice::Texels) return 0; // k = 0
    return nearSquared_[static_cast<size_t>(std::abs(kt)) * static_cast<size_t>(nearColumns_) +
                        static_cast<size_t>(std::abs(ks))];
}

/// phi(k) for k_s, k_t >= 0; other offsets follow by symmetry.
double ConePairs::computeNearDistance(int ks, int kt) const {
    if (ks == 0 && kt == 0) return 0;
    const auto st = [&](double s, double t) { return Vec2(s * perWidth_, t * perHeight_); };
    const Vec2 offset = st(ks, kt);
    double least = glm::length(offset);
    for (int qt = std::max(kt - 1, 0); qt <= kt; ++qt)
        for (int qs = std::max(ks - 1, 0); qs <= ks; ++qs) {
            if (qs == 0 && qt == 0) continue; // touches the origin
            const bool far = offsetSquared(qs + 1, qt + 1) >= closedFormFrom_;
            // A near square spans a wide angle. The bisector of its outermost directions loses least, a
            // factor of cos 45 degrees at worst.
            const Vec2 direction = far ? st(qs + 0.5, qt + 0.5)
                                       : glm::normalize(st(qs + 1, qt)) + glm::normalize(st(qs, qt + 1));
            least = std::min(least, glm::dot(offset, glm::normalize(direction)));
        }
    return least * kRoundedDown;
}

bool ConePairs::insideSector(const Vec2i& offset, int sector) const {
    const int along = sector / 2, across = 1 - along;
    const Vec2 size(perWidth_, perHeight_);
    const int nearest = (sector % 2 == 0 ? offset[along] : -offset[along]) - spread();
    return nearest * size[along] >= (std::abs(offset[across]) + spread()) * size[across];
}

bool ConePairs::counts(int column, int row, int ks, int kt, int sector) const {
    if (!meetsSector({ks, kt}, {ks, kt}, sector)) return false;
    if (!rule_.relaxed) return true;
    const int i = column + ks, j = row + kt;
    if (slice_ == ConeSlice::Texels) {
        const double depth = map_.texel(i, j);
        const double outward = std::abs(ks) * (map_.texel(i + signOf(ks), j) - depth) +
                               std::abs(kt) * (map_.texel(i, j + signOf(kt)) - depth);
        return outward > rule_.rayStart * depth;
    }
    for (int dj = -1; dj <= 0; ++dj)
        for (int di = -1; di <= 0; ++di)
            if (exitPossible(cellSlopes(map_.cell(i + di, j + dj)), ks, kt, rule_.rayStart)) return true;
    return false;
}

} // namespace plumbline
