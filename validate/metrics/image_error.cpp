#include "validate/metrics/image_error.h"

#include "validate/report/pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace plumbline {
namespace {

constexpr std::array kColors{"R", "G", "B"};

using Planes = std::array<std::span<const float>, 3>; // one a colour

Planes planesOf(const Frame& frame) {
    return {frame.channel("R"), frame.channel("G"), frame.channel("B")};
}

ImageError absentImageError(const std::string& reason) {
    ImageError result;
    result.psnrDb = result.rmse = result.badpix2Codes = Figure::absent(reason);
    return result;
}

/// srgbCode by look-up, for it takes a power: it never falls as the colour grows, so where each code begins
/// says all.
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
    static constexpr int kCells = 4096;        // a code spans at least 1/3295: a step or two remain
    std::array<float, 256> begins_{};          // linear
    std::array<uint8_t, kCells + 1> codeAt_{}; // where each cell begins
};

/// Codes between the two frames' colours at a pixel, per channel; nullopt if one isn't finite.
std::optional<std::array<int, 3>> codesApart(const SrgbCodes& codes, const Planes& reference,
                                             const Planes& test, size_t pixel) {
    std::array<int, 3> apart{};
    for (size_t c = 0; c < 3; ++c) {
        const float a = reference[c][pixel], b = test[c][pixel];
        if (!std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
        if (a != b) apart[c] = std::abs(codes.of(b) - codes.of(a));
    }
    return apart;
}

} // namespace

ImageError computeImageError(const FramePair& pair) {
    for (const char* color : kColors)
        if (const std::string missing = pair.missingChannel(color); !missing.empty())
            return absentImageError(missing);
    const Planes reference = planesOf(pair.reference()), test = planesOf(pair.test());

    static const SrgbCodes srgbCodes;
    const uint64_t pixelCount = pair.reference().pixelCount();
    uint64_t domainPx = 0, bad2CodesPx = 0, sumSquares = 0;
    for (size_t pixel = 0; pixel < pixelCount; ++pixel) {
        const auto apart = codesApart(srgbCodes, reference, test, pixel);
        if (!apart) continue;
        ++domainPx;
        bad2CodesPx += *std::max_element(apart->begin(), apart->end()) > 2;
        for (const int codes : *apart)
            sumSquares += static_cast<uint64_t>(codes * codes);
    }

    ImageError result = absentImageError("no pixel has a finite colour in both frames");
    result.domainPx = domainPx;
    result.invalidPx = pixelCount - domainPx;
    if (domainPx == 0) return result;
    const double rmse =
        std::sqrt(static_cast<double>(sumSquares) / (3 * static_cast<double>(domainPx))) / 255;
    result.rmse = rmse;
    result.psnrDb =
        sumSquares > 0 ? Figure(20 * std::log10(1 / rmse)) : Figure::absent("the pictures are equal");
    result.bad2CodesPx = bad2CodesPx;
    result.badpix2Codes = static_cast<double>(bad2CodesPx) / static_cast<double>(domainPx);
    return result;
}

MetricValues valuesOf(const ImageError& result) {
    return {{"domain_px", result.domainPx},
            {"psnr_db", result.psnrDb},
            {"rmse", result.rmse},
            {"badpix_2codes", result.badpix2Codes},
            {"badpix_2codes_px", result.bad2CodesPx},
            {"invalid_px", result.invalidPx}};
}

} // namespace plumbline
