#include "validate/metrics/hit_faults.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace plumbline {
namespace {

/// Values of the channel `fault`, which may be added up.
enum Fault : unsigned { kNotFinite = 1, kTOutside = 2, kOffRay = 4 };

/// The faults at the pixels of a frame.
class PixelFaults {
  public:
    explicit PixelFaults(const Frame& frame) {
        for (const char* name : {"Z", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "st.S", "st.T"})
            if (frame.has(name)) finite_.push_back(frame.channel(name));
        if (frame.has("fault")) marks_ = frame.channel("fault");
    }

    bool hasMarks() const { return !marks_.empty(); }

    unsigned at(size_t pixel) const {
        // Any value may be in a file; what isn't one of ours marks nothing.
        const float mark = hasMarks() ? marks_[pixel] : 0;
        unsigned faults =
            mark >= 0 && mark <= (kNotFinite | kTOutside | kOffRay) ? static_cast<unsigned>(mark) : 0;
        for (const std::span<const float>& plane : finite_)
            if (!std::isfinite(plane[pixel])) faults |= kNotFinite;
        return faults;
    }

  private:
    std::vector<std::span<const float>> finite_;
    std::span<const float> marks_;
};

struct Counts {
    uint64_t notFinite = 0, tOutside = 0, offRay = 0;

    void add(unsigned faults) {
        notFinite += (faults & kNotFinite) != 0;
        tOutside += (faults & kTOutside) != 0;
        offRay += (faults & kOffRay) != 0;
    }
};

} // namespace

HitFaults computeHitFaults(const FramePair& pair, ObjectSelection selection) {
    const PixelFaults faults(pair.test());
    Counts counts;
    for (const size_t index : selection)
        for (const uint32_t pixel : pair.pixelsOf(index))
            if (pair.testIds()[pixel] == pair.objects()[index].id) counts.add(faults.at(pixel));
    HitFaults result;
    result.notFinitePx = counts.notFinite;
    const Figure none = Figure::absent("the test frame has no channel fault");
    result.tOutsidePx = faults.hasMarks() ? Figure(static_cast<double>(counts.tOutside)) : none;
    result.offRayPx = faults.hasMarks() ? Figure(static_cast<double>(counts.offRay)) : none;
    return result;
}

std::vector<std::string> faultSentences(const Frame& frame) {
    const PixelFaults faults(frame);
    const auto covered = frame.channel(frame.has("A") ? "A" : "id");
    Counts counts;
    for (size_t pixel = 0; pixel < frame.pixelCount(); ++pixel)
        if (covered[pixel] > 0) counts.add(faults.at(pixel));
    std::vector<std::string> sentences;
    if (counts.notFinite > 0)
        sentences.push_back(
            fmt::format("{} covered pixels have a position, depth, normal or st that isn't a number; "
                        "figures leave them out",
                        counts.notFinite));
    if (counts.tOutside > 0)
        sentences.push_back(
            fmt::format("{} covered pixels have a hit with t outside [0, 1], before the ray's entry "
                        "or beyond its end; figures take them as drawn",
                        counts.tOutside));
    if (counts.offRay > 0)
        sentences.push_back(
            fmt::format("{} covered pixels have a hit whose st isn't the ray's at its t; figures take "
                        "them as drawn",
                        counts.offRay));
    return sentences;
}

Metric hitFaultsMetric() {
    return makeMetric<HitFaults>({
        .group = "fault",
        .domain = kTestDomain,
        .rows = {{{.key = "not_finite_px",
                   .label = "not finite",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "pixels with a position, depth, normal, st or hit that isn't finite"},
                  &HitFaults::notFinitePx},
                 {{.key = "t_outside_px",
                   .label = "t outside",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "pixels with a hit of the view ray or a shadow ray outside the search interval",
                   .formula = "t < -2^-20 or t > 1 + 2^-20"},
                  &HitFaults::tOutsidePx},
                 {{.key = "off_ray_px",
                   .label = "off the ray",
                   .unit = Unit::PixelCount,
                   .goal = Goal::Zero,
                   .meaning = "pixels with a hit whose texture coordinates aren't those of the ray there",
                   .formula = "|st - st(t)| > 2^-20 (|st(0)| + |st(1) - st(0)|), along s or t"},
                  &HitFaults::offRayPx}},
        .compute = [](const MetricInput& input, ObjectSelection selection,
                      const std::string&) { return computeHitFaults(input.pair, selection); },
    });
}

} // namespace plumbline
