#include "validate/report/pictures.h"

#include "scenes/core/srgb.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

/// A picture whose pixel i has the color colorOf(i).
template <class ColorOf>
Picture paint(const Frame& frame, ColorOf&& colorOf) {
    Picture picture{frame.width(), frame.height(), {}};
    picture.rgb.reserve(frame.pixelCount() * 3);
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel) {
        const Rgb color = colorOf(pixel);
        picture.rgb.insert(picture.rgb.end(), color.begin(), color.end());
    }
    return picture;
}

/// Color of a pixel that doesn't show the same object in both frames.
Rgb unsharedColor(int inReference, int inTest) {
    return inReference == 0 && inTest == 0 ? palette::kNothing : palette::kUnshared;
}

} // namespace

Picture colorPicture(const Frame& frame) {
    if (!frame.has("R") || !frame.has("G") || !frame.has("B")) {
        const auto coverage = frame.channel(frame.has("id") ? "id" : "A");
        return paint(frame,
                     [&](size_t i) { return coverage[i] >= 0.5f ? palette::kAgree : palette::kNothing; });
    }
    const auto r = frame.channel("R"), g = frame.channel("G"), b = frame.channel("B");
    return paint(frame, [&](size_t i) {
        if (!std::isfinite(r[i]) || !std::isfinite(g[i]) || !std::isfinite(b[i])) return palette::kInvalid;
        return Rgb{srgbCode(r[i]), srgbCode(g[i]), srgbCode(b[i])};
    });
}

Picture silhouettePicture(const FramePair& pair) {
    return paint(pair.reference(), [&](size_t i) {
        const int inReference = pair.referenceIds()[i], inTest = pair.testIds()[i];
        if (inReference == inTest) return inReference == 0 ? palette::kNothing : palette::kAgree;
        if (inTest == 0) return palette::kMissing;
        return inReference == 0 ? palette::kExtra : palette::kOther;
    });
}

Picture depthErrorPicture(const FramePair& pair, std::span<const float> referenceDepth,
                          std::span<const float> testDepth, double range) {
    return paint(pair.reference(), [&](size_t i) {
        const int inReference = pair.referenceIds()[i], inTest = pair.testIds()[i];
        if (inReference == 0 || inReference != inTest) return unsharedColor(inReference, inTest);
        const double error = double(testDepth[i]) - double(referenceDepth[i]);
        return std::isfinite(error) ? colorAt(colormap::kDiverging, error / range) : palette::kInvalid;
    });
}

Picture iterationsPicture(const Frame& test, double largest) {
    const auto iterations = test.channel("cost.iterations"), id = test.channel("id");
    return paint(test, [&](size_t i) {
        if (!(id[i] > 0)) return palette::kNothing;
        return std::isfinite(iterations[i]) ? colorAt(colormap::kSequential, iterations[i] / largest)
                                            : palette::kInvalid;
    });
}

double curvatureRange(const Frame& test, const std::string& channel) {
    const auto id = test.channel("id"), curvature = test.channel(channel);
    std::vector<float> sizes;
    for (size_t i = 0; i < test.pixelCount(); ++i)
        if (id[i] > 0 && std::isfinite(curvature[i])) sizes.push_back(std::abs(curvature[i]));
    if (sizes.empty()) return 0;
    const auto rank = sizes.begin() + static_cast<std::ptrdiff_t>((sizes.size() - 1) * 9 / 10);
    std::nth_element(sizes.begin(), rank, sizes.end());
    return double(*rank);
}

Picture curvaturePicture(const Frame& test, const std::string& channel, double range) {
    const auto id = test.channel("id"), curvature = test.channel(channel);
    return paint(test, [&](size_t i) {
        if (!(id[i] > 0)) return palette::kNothing;
        return std::isfinite(curvature[i]) ? colorAt(colormap::kCurvature, curvature[i] / range)
                                           : palette::kInvalid;
    });
}

Picture shadowPicture(const FramePair& pair, const std::string& light) {
    const auto reference = pair.reference().channel(shadowChannel(light));
    const auto test = pair.test().channel(shadowChannel(light));
    return paint(pair.reference(), [&](size_t i) {
        const int inReference = pair.referenceIds()[i], inTest = pair.testIds()[i];
        if (inReference == 0 || inReference != inTest) return unsharedColor(inReference, inTest);
        if (!std::isfinite(reference[i]) || !std::isfinite(test[i])) return palette::kInvalid;
        const bool dark = isShadow(reference[i]), darkInTest = isShadow(test[i]);
        if (dark == darkInTest) return dark ? palette::kBothDark : palette::kAgree;
        return dark ? palette::kMissing : palette::kExtra;
    });
}

} // namespace plumbline
