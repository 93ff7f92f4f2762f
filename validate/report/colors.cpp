#include "validate/report/colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

// Blue like kExtra and orange like kMissing, because a surface that is too near resembles an extra one. No
// map of d3-scale-chromatic goes from blue to orange. Luminance decreases evenly from the middle to both
// ends, so equal errors of either sign look equally strong.
constexpr std::array<Rgb, 5> kBlueOrange{
    {{5, 76, 135}, {100, 170, 215}, {247, 247, 247}, {240, 165, 80}, {150, 65, 0}}};

// ColorBrewer's YlOrBr of nine classes (Harrower and Brewer 2003), schemeYlOrBr[9] of d3-scale-chromatic.
constexpr std::array<Rgb, 9> kYlOrBr{{{255, 255, 229},
                                      {255, 247, 188},
                                      {254, 227, 145},
                                      {254, 196, 79},
                                      {254, 153, 41},
                                      {236, 112, 20},
                                      {204, 76, 2},
                                      {153, 52, 4},
                                      {102, 37, 6}}};

// Doesn't end at black, unlike Grays of d3-scale-chromatic, because the farthest pixel would look like
// kNothing.
constexpr std::array<Rgb, 2> kGrays{{{240, 240, 240}, {48, 48, 48}}};

// The green is the palest, so that either sign differs from 0 by lightness alone.
constexpr std::array<Rgb, 3> kBlueGreenRed{{{0, 72, 168}, {160, 218, 170}, {196, 56, 16}}};

Rgb mix(const Rgb& a, const Rgb& b, double t) {
    Rgb result;
    for (size_t i = 0; i < 3; ++i)
        result[i] = static_cast<uint8_t>(std::lround((1 - t) * double(a[i]) + t * double(b[i])));
    return result;
}

} // namespace

constinit const ColorMap colormap::kDiverging{"diverging", -1, kBlueOrange};
constinit const ColorMap colormap::kSequential{"sequential", 0, kYlOrBr};
constinit const ColorMap colormap::kGray{"gray", 0, kGrays};
constinit const ColorMap colormap::kCurvature{"curvature", -1, kBlueGreenRed};

std::vector<std::pair<std::string, Rgb>> palette::all() {
    return {{"nothing", kNothing},
            {"agree", kAgree},
            {"missing", kMissing},
            {"extra", kExtra},
            {"other", kOther},
            {"dark", kBothDark},
            {"invalid", kInvalid},
            {"unshared", kUnshared},
            {"uncertain_agrees", kUncertainAgrees},
            {"uncertain_differs", kUncertainDiffers}};
}

std::vector<ColorMap> colormap::all() {
    return {kDiverging, kSequential, kGray, kCurvature};
}

Rgb colorAt(const ColorMap& map, double x) {
    const double inside = std::clamp(x, map.low, 1.0);
    // From the middle stop of a diverging map to either end, so that x and -x are equally far from the
    // middle.
    const size_t first = map.low < 0 ? map.stops.size() / 2 : 0, last = map.stops.size() - 1 - first;
    const double at = std::abs(inside) * static_cast<double>(last);
    const size_t below = std::min(static_cast<size_t>(at), last - 1);
    const auto stop = [&](size_t i) { return map.stops[inside < 0 ? first - i : first + i]; };
    return mix(stop(below), stop(below + 1), at - static_cast<double>(below));
}

std::string cssColor(const Rgb& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

} // namespace plumbline
