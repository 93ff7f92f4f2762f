#include "failing_pixels.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline::report {
namespace {

constexpr double kReliefShare = 0.05; // as badpix_5pct

/// By id: how far the depth may be off, world units; negative where nobody knows the relief's depth.
std::vector<double> tolerances(const FramePair& pair) {
    std::vector<double> byId;
    for (const ObjectInfo& object : pair.objects()) {
        byId.resize(std::max(byId.size(), static_cast<size_t>(object.id) + 1), -1);
        if (object.reliefDepth && *object.reliefDepth > 0)
            byId[static_cast<size_t>(object.id)] = kReliefShare * *object.reliefDepth;
    }
    return byId;
}

} // namespace

std::string FailingPixels::meaning() {
    return fmt::format(
        "another object than the reference shows, or none; or a depth off by more than {:.0f} % of the "
        "relief depth, or no finite one; or another shadow of any light. Pixels at which the reference "
        "can't tell which object is seen don't count.",
        100 * kReliefShare);
}

void FailingPixels::add(const FramePair& pair, const Comparison& comparison) {
    const size_t pixels = pair.referenceIds().size();
    counts_.resize(pixels);
    ++techniques_;
    const std::vector<double> tolerance = tolerances(pair);
    const bool depthKnown = !comparison.referenceDepth.empty() && !comparison.testDepth.empty();
    std::vector<std::pair<std::span<const float>, std::span<const float>>> shadows;
    for (const std::string& light : pair.reference().lightNames())
        if (pair.missingChannel(shadowChannel(light)).empty())
            shadows.emplace_back(pair.reference().channel(shadowChannel(light)),
                                 pair.test().channel(shadowChannel(light)));

    const auto fails = [&](uint32_t pixel) {
        const int id = pair.referenceIds()[pixel];
        if (id != pair.testIds()[pixel]) return true;
        if (id == 0) return false;
        const double allowed = tolerance[static_cast<size_t>(id)];
        if (depthKnown && allowed >= 0 && std::isfinite(comparison.referenceDepth[pixel]) &&
            !(std::abs(double(comparison.testDepth[pixel]) - double(comparison.referenceDepth[pixel])) <=
              allowed))
            return true;
        for (const auto& [inReference, inTest] : shadows)
            if ((inReference[pixel] >= 0.5f) != (inTest[pixel] >= 0.5f)) return true;
        return false;
    };
    for (uint32_t pixel = 0; pixel < pixels; ++pixel)
        if (!pair.isUncertain(pixel) && fails(pixel)) ++counts_[pixel];
}

} // namespace plumbline::report
