#include "validate/report/failing_pixels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::report {
namespace {

constexpr double kReliefShare = 0.05; // as badpix_5pct

/// By id: the largest depth error that doesn't count as failing, in world units; negative if the relief depth
/// is unknown.
std::vector<double> tolerances(const FramePair& pair) {
    std::vector<double> byId;
    for (const ObjectInfo& object : pair.objects()) {
        byId.resize(std::max(byId.size(), static_cast<size_t>(object.id) + 1), -1);
        if (object.reliefDepth && *object.reliefDepth > 0)
            byId[static_cast<size_t>(object.id)] = kReliefShare * *object.reliefDepth;
    }
    return byId;
}

/// One light's shadow in both frames.
struct ShadowPlanes {
    std::span<const float> reference, test, uncertain; // the last is empty if the reference has none

    ShadowPlanes(const FramePair& pair, const std::string& light)
        : reference(pair.reference().channel(shadowChannel(light))),
          test(pair.test().channel(shadowChannel(light))) {
        if (const std::string channel = uncertainShadowChannel(light); pair.reference().has(channel))
            uncertain = pair.reference().channel(channel);
    }
    /// False where the reference is uncertain or has no value.
    bool differAt(uint32_t pixel) const {
        if (!std::isfinite(reference[pixel]) || (!uncertain.empty() && saysUncertain(uncertain[pixel])))
            return false;
        return !std::isfinite(test[pixel]) || isShadow(test[pixel]) != isShadow(reference[pixel]);
    }
};

} // namespace

std::string FailingPixels::meaning() {
    return fmt::format(
        "another object than in the reference, or none; a depth error above {:.0f} % of the relief depth, or "
        "a depth that isn't finite; a different shadow value for any light, or none. Pixels where the "
        "reference is uncertain and controls aren't counted.",
        100 * kReliefShare);
}

void FailingPixels::add(const FramePair& pair, const Comparison& comparison) {
    const size_t pixels = pair.referenceIds().size();
    counts_.resize(pixels);
    ++techniques_;
    const std::vector<double> tolerance = tolerances(pair);
    const bool depthKnown = !comparison.referenceDepth.empty() && !comparison.testDepth.empty();
    std::vector<ShadowPlanes> shadows;
    for (const std::string& light : pair.reference().lightNames())
        if (pair.missingChannel(shadowChannel(light)).empty()) shadows.emplace_back(pair, light);

    const auto fails = [&](uint32_t pixel) {
        const int id = pair.referenceIds()[pixel];
        if (id != pair.testIds()[pixel]) return true;
        if (id == 0) return false;
        const double allowed = tolerance[static_cast<size_t>(id)];
        if (depthKnown && allowed >= 0 && std::isfinite(comparison.referenceDepth[pixel]) &&
            !(std::abs(double(comparison.testDepth[pixel]) - double(comparison.referenceDepth[pixel])) <=
              allowed))
            return true;
        return std::any_of(shadows.begin(), shadows.end(),
                           [&](const ShadowPlanes& each) { return each.differAt(pixel); });
    };
    for (uint32_t pixel = 0; pixel < pixels; ++pixel)
        if (!pair.isUncertain(pixel) && fails(pixel)) ++counts_[pixel];
}

} // namespace plumbline::report
