#include "validate/metrics/shadow_kinds.h"

#include "validate/metrics/shadow_agreement.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace plumbline {
namespace {

ShadowKinds absentKinds(const std::string& reason) {
    const Figure none = Figure::absent(reason);
    const ShadowKinds::Part part{none, none, none, none};
    return {part, part, none};
}

std::string missingReason(const FramePair& pair, const std::string& name, const std::optional<Light>& light,
                          const std::optional<Camera>& camera) {
    if (const std::string missing = pair.missingChannel(shadowChannel(name)); !missing.empty())
        return missing;
    if (!light) return fmt::format("no frame's header says where the light is (light.{})", name);
    if (!camera) return "the camera is not known";
    std::vector<const char*> channels{"N.X", "N.Y", "N.Z"};
    if (light->kind == Light::Kind::Point) channels.insert(channels.end(), {"P.X", "P.Y", "P.Z"});
    for (const char* channel : channels)
        if (const std::string missing = pair.missingInReference(channel); !missing.empty()) return missing;
    return {};
}

/// On which side of its surface's shadow line the reference's pixels lie.
class LightSide {
  public:
    LightSide(const Frame& reference, const Light& light, const Camera& camera)
        : width_(static_cast<uint32_t>(reference.width())), light_(light), rays_(camera),
          normal_(planes(reference, {"N.X", "N.Y", "N.Z"})) {
        if (light.kind == Light::Kind::Point) position_ = planes(reference, {"P.X", "P.Y", "P.Z"});
    }

    /// nullopt where the reference has no normal, or no point, to tell by.
    std::optional<bool> attached(uint32_t pixel) const {
        const Vec3 normal = at(normal_, pixel);
        const Vec3 view = rays_.ray(pixel % width_ + 0.5, pixel / width_ + 0.5).direction;
        const double side = glm::dot(normal, view) > 0 ? -1 : 1;
        const Vec3 toLight = light_.kind == Light::Kind::Point
                                 ? sampleLight(light_, at(position_, pixel)).toLightWorld
                                 : light_.toLightWorld;
        const double cosine = side * glm::dot(normal, toLight);
        if (!std::isfinite(cosine) || normal == Vec3(0)) return std::nullopt;
        return cosine <= 0;
    }

  private:
    using Planes = std::array<std::span<const float>, 3>;
    static Planes planes(const Frame& frame, const std::array<const char*, 3>& names) {
        return {frame.channel(names[0]), frame.channel(names[1]), frame.channel(names[2])};
    }
    static Vec3 at(const Planes& planes, uint32_t pixel) {
        return {planes[0][pixel], planes[1][pixel], planes[2][pixel]};
    }

    uint32_t width_;
    const Light& light_;
    CameraRays rays_;
    Planes normal_, position_;
};

struct Counts {
    uint64_t domain = 0, falseShadow = 0, falseLit = 0;

    ShadowKinds::Part part(const char* none) const {
        return {static_cast<double>(domain), static_cast<double>(falseShadow), static_cast<double>(falseLit),
                Figure::ratio(domain - falseShadow - falseLit, domain, none)};
    }
};

} // namespace

ShadowKinds computeShadowKinds(const FramePair& pair, ObjectSelection selection, const std::string& name,
                               const std::optional<Light>& light, const std::optional<Camera>& camera) {
    if (const std::string reason = missingReason(pair, name, light, camera); !reason.empty())
        return absentKinds(reason);
    const LightSide side(pair.reference(), *light, *camera);
    Counts attached, cast;
    uint64_t noNormalPx = 0;
    forShadowPixels(pair, selection, name, [&](uint32_t pixel, bool dark, bool darkInTest) {
        const std::optional<bool> isAttached = side.attached(pixel);
        if (!isAttached) {
            ++noNormalPx;
            return;
        }
        Counts& counts = *isAttached ? attached : cast;
        ++counts.domain;
        counts.falseShadow += !dark && darkInTest;
        counts.falseLit += dark && !darkInTest;
    });
    return {attached.part("no pixel of the domain is turned away from the light"),
            cast.part("no pixel of the domain is turned towards the light"), static_cast<double>(noNormalPx)};
}

MetricValues valuesOf(const ShadowKinds& result) {
    MetricValues values;
    const auto add = [&](const std::string& kind, const ShadowKinds::Part& part) {
        values.insert(values.end(), {{kind + "_domain_px", wholeNumber(part.domainPx)},
                                     {kind + "_agreement", part.agreement},
                                     {kind + "_false_shadow_px", wholeNumber(part.falseShadowPx)},
                                     {kind + "_false_lit_px", wholeNumber(part.falseLitPx)}});
    };
    add("attached", result.attached);
    add("cast", result.cast);
    values.push_back({"no_normal_px", wholeNumber(result.noNormalPx)});
    return values;
}

} // namespace plumbline
