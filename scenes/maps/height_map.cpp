#include "scenes/maps/height_map.h"

#include "scenes/core/error.h"
#include "scenes/maps/bilinear.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

int wrapIndex(int i, int size, Wrap wrap) {
    if (wrap == Wrap::Clamp) return std::clamp(i, 0, size - 1);
    const int remainder = i % size;
    return remainder < 0 ? remainder + size : remainder;
}

bool canLookUp(double s, Wrap wrap) {
    return wrap == Wrap::Clamp ? !std::isnan(s) : std::isfinite(s);
}

/// Names the first value outside [0,1] and how many there are.
void checkDepths(const std::string& name, int width, const std::vector<float>& depths) {
    const auto isBad = [](float d) { return !(d >= 0.0f && d <= 1.0f); };
    const auto first = std::ranges::find_if(depths, isBad);
    if (first == depths.end()) return;
    const auto count = std::count_if(first, depths.end(), isBad);
    const auto index = first - depths.begin();
    throw InputError(
        name,
        fmt::format("{} of {} values are NaN or outside [0,1], the first is {} at column {}, row {} "
                    "from the bottom",
                    count, depths.size(), *first, index % width, index / width),
        "relief depths or heights in [0,1]");
}

} // namespace

HeightMap::HeightMap(std::string name, int width, int height, std::vector<float> depths, Wrap wrapS,
                     Wrap wrapT)
    : name_(std::move(name)), width_(width), height_(height), depths_(std::move(depths)), wrapS_(wrapS),
      wrapT_(wrapT) {
    if (width < 1 || height < 1 || depths_.size() != areaOf(width, height))
        throw InputError(name_,
                         fmt::format("{} values for a height map of {} x {}", depths_.size(), width, height),
                         "at least 1 x 1 texels and a value for each");
    checkDepths(name_, width_, depths_);
    const auto [least, most] = std::ranges::minmax_element(depths_);
    minDepth_ = *least;
    maxDepth_ = *most;
}

HeightMap HeightMap::constant(std::string name, float depth) {
    return HeightMap(std::move(name), 1, 1, {depth});
}

float HeightMap::texel(int i, int j) const {
    return rowOf(wrapIndex(j, height_, wrapT_))[wrapIndex(i, width_, wrapS_)];
}

HeightMap::Cell HeightMap::cell(int i, int j) const {
    const int column = wrapIndex(i, width_, wrapS_), row = wrapIndex(j, height_, wrapT_);
    const auto next = [](int index, int size, Wrap wrap, bool below) {
        if (below || index + 1 < size) return below ? index : index + 1;
        return wrap == Wrap::Repeat ? 0 : index;
    };
    // Left of a clamped map's first texel, both texels of the pair are that texel.
    const int right = next(column, width_, wrapS_, wrapS_ == Wrap::Clamp && i < 0);
    const int above = next(row, height_, wrapT_, wrapT_ == Wrap::Clamp && j < 0);
    const float *lower = rowOf(row), *upper = rowOf(above);
    return {lower[column], lower[right], upper[column], upper[right]};
}

double HeightMap::depth(const Vec2& st) const {
    return sample(st).depth;
}

HeightMap::Sample HeightMap::sample(const Vec2& st) const {
    if (!canLookUp(st.x, wrapS_) || !canLookUp(st.y, wrapT_)) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, Vec2(nan)};
    }
    const TexelPair s = texelPair(st.x, width_, wrapS_);
    const TexelPair t = texelPair(st.y, height_, wrapT_);
    const float *lower = rowOf(t.first), *upper = rowOf(t.second);
    const double d00 = lower[s.first], d10 = lower[s.second];
    const double d01 = upper[s.first], d11 = upper[s.second];
    const double lowerDepth = d00 + (d10 - d00) * s.weight;
    const double upperDepth = d01 + (d11 - d01) * s.weight;
    Sample result;
    result.depth = lowerDepth + (upperDepth - lowerDepth) * t.weight;
    const double slopeS = (d10 - d00) + ((d11 - d01) - (d10 - d00)) * t.weight; // per texel
    result.gradient = {slopeS * width_, (upperDepth - lowerDepth) * height_};
    return result;
}

} // namespace plumbline
