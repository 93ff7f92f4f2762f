#include "validate/metrics/image_error.h"

#include "scenes/core/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace plumbline {
namespace {

constexpr std::array<const char*, 3> kColors{"R", "G", "B"};

using Planes = std::array<std::span<const float>, 3>; // one per color

Planes planesOf(const Frame& frame) {
    return {frame.channel("R"), frame.channel("G"), frame.channel("B")};
}

ImageError absentImageError(const std::string& reason) {
    ImageError result;
    result.psnrDb = result.rmse = result.badpix2Codes = Figure::absent(reason);
    return result;
}

/// srgbCode by table lookup, because it evaluates a power. It increases monotonically with the color, so the
/// first color of each code defines it.
class SrgbCodes {
  public:
    SrgbCodes() {
        for (size_t code = 1; code < begins_.size(); ++code) {
            float below = begins_[code - 1], from = 1; // the code begins after `below` and by `from`
            while (std::nextafter(below, from) < from) {
                const float middle = below + (from - below) / 2;
                (srgbCode(middle) >= code ? from : below) = middle;
            }
            begins_[code] = from;
        }
        for (size_t cell = 0; cell < codeAt_.size(); ++cell)
            codeAt_[cell] = srgbCode(static_cast<double>(cell) / kCells);
    }
    /// `value`: finite.
    int of(float value) const {
        const float clamped = std::clamp(value, 0.0f, 1.0f);
        size_t code = codeAt_[static_cast<size_t>(clamped * kCells)];
        while (code + 1 < begins_.size() && clamped >= begins_[code + 1])
            ++code;
        return static_cast<int>(code);
    }

  private:
    static constexpr int kCells = 4096;        // a code spans at least 1/3295, so one or two steps remain
    std::array<float, 256> begins_{};          // linear
    std::array<uint8_t, kCells + 1> codeAt_{}; // at the lower end of each cell
};

/// Absolute difference of the two frames' codes at a pixel, per channel; nullopt if a color isn't finite.
std::optional<std::array<int, 3>> codeDifferences(const SrgbCodes& codes, const Planes& reference,
                                                  const Planes& test, size_t pixel) {
    std::array<int, 3> differences{};
    for (size_t c = 0; c < 3; ++c) {
        const float a = reference[c][pixel], b = test[c][pixel];
        if (!std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
        if (a != b) differences[c] = std::abs(codes.of(b) - codes.of(a));
    }
    return differences;
}

} // namespace

ImageError computeImageError(const FramePair& pair) {
    if (const std::string missing = pair.missingChannel(kColors); !missing.empty())
        return absentImageError(missing);
    const Planes reference = planesOf(pair.reference()), test = planesOf(pair.test());

    static const SrgbCodes srgbCodes;
    const uint64_t pixelCount = pair.reference().pixelCount();
    uint64_t domainPx = 0, bad2CodesPx = 0, sumSquares = 0;
    for (size_t pixel = 0; pixel < pixelCount; ++pixel) {
        const auto differences = codeDifferences(srgbCodes, reference, test, pixel);
        if (!differences) continue;
        ++domainPx;
        bad2CodesPx += *std::max_element(differences->begin(), differences->end()) > 2;
        for (const int codes : *differences)
            sumSquares += static_cast<uint64_t>(codes * codes);
    }

    ImageError result = absentImageError("no pixel has a finite color in both frames");
    result.domainPx = domainPx;
    result.invalidPx = pixelCount - domainPx;
    if (domainPx == 0) return result;
    const double rmse =
        std::sqrt(static_cast<double>(sumSquares) / (3 * static_cast<double>(domainPx))) / 255;
    result.rmse = rmse;
    result.psnrDb =
        sumSquares > 0 ? Figure(20 * std::log10(1 / rmse)) : Figure::absent("the images are equal");
    result.bad2CodesPx = bad2CodesPx;
    result.badpix2Codes = static_cast<double>(bad2CodesPx) / static_cast<double>(domainPx);
    return result;
}

Metric imageErrorMetric() {
    return makeMetric<ImageError>({
        .group = "image",
        .domain = "all pixels of the image, background included, with finite colors in both",
        .scope = Scope::Image,
        .channels = {kColors.begin(), kColors.end()},
        .figuresName = "image figures",
        .rows = {{{.key = "domain_px",
                   .label = "image compared",
                   .unit = Unit::PixelCount,
                   .meaning = "pixels compared"},
                  &ImageError::domainPx},
                 {{.key = "psnr_db",
                   .label = "PSNR",
                   .unit = Unit::Decibels,
                   .goal = Goal::Highest,
                   .meaning = "peak signal-to-noise ratio of the sRGB images; absent if they are equal",
                   .formula = "20 log10(1 / rmse)"},
                  &ImageError::psnrDb},
                 {{.key = "rmse",
                   .label = "image RMSE",
                   .unit = Unit::Ratio,
                   .goal = Goal::Zero,
                   .meaning = "root of the mean squared difference of sRGB codes / 255",
                   .formula = "√(mean ((c_T - c_R) / 255)²) over pixels and channels"},
                  &ImageError::rmse},
                 {{.key = "badpix_2codes",
                   .label = "bad pixels, > 2 codes",
                   .unit = Unit::Ratio,
                   .goal = Goal::Zero,
                   .meaning =
                       "share of the pixels of which a channel differs by more than 2 sRGB codes of 255",
                   .formula = "mean [ max over channels |c_T - c_R| > 2 ]"},
                  &ImageError::badpix2Codes},
                 {{.key = "badpix_2codes_px",
                   .label = "bad pixels, > 2 codes",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "numerator of badpix_2codes"},
                  &ImageError::bad2CodesPx},
                 {{.key = "invalid_px",
                   .label = "without color",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "pixels without a finite color in both frames: not in the domain"},
                  &ImageError::invalidPx}},
        .compute = [](const MetricInput& input, ObjectSelection,
                      const std::string&) { return computeImageError(input.pair); },
    });
}

} // namespace plumbline
