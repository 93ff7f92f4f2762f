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
    if (std::string missing = pair.missingChannel(shadowChannel(name)); !missing.empty()) return missing;
    if (!light)
        return fmt::format("neither header contains the direction or position of the light (light.{})", name);
    if (!camera) return "the camera is not known";
    std::vector<const char*> channels{"N.X", "N.Y", "N.Z"};
    if (light->kind == Light::Kind::Point) channels.insert(channels.end(), {"P.X", "P.Y", "P.Z"});
    for (const char* channel : channels)
        if (std::string missing = pair.missingInReference(channel); !missing.empty()) return missing;
    return {};
}

/// Classifies the reference's pixels by whether their surface faces the light.
class LightSide {
  public:
    LightSide(const Frame& reference, const Light& light, const Camera& camera)
        : width_(lengthOf(reference.width())), light_(light), rays_(camera),
          normal_(planes(reference, {"N.X", "N.Y", "N.Z"})) {
        if (light.kind == Light::Kind::Point) position_ = planes(reference, {"P.X", "P.Y", "P.Z"});
    }

    /// nullopt where the reference has no normal or no position.
    std::optional<bool> attached(uint32_t pixel) const {
        const Vec3 normal = at(normal_, pixel);
        const Vec3 view = rays_.ray(pixelCenter(pixel, width_)).direction;
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

    size_t width_;
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
    return {attached.part("no pixel of the domain faces away from the light"),
            cast.part("no pixel of the domain faces the light"), static_cast<double>(noNormalPx)};
}

namespace {

using Rows = std::vector<FigureRow<ShadowKinds>>;

/// The rows of one of the parts. `where`: the condition on N·L.
void appendRows(Rows& rows, ShadowKinds::Part ShadowKinds::*part, const std::string& kind,
                const std::string& where, const std::string& meaningOfDomain) {
    const auto figure = [part](Figure ShadowKinds::Part::*member) {
        return [part, member](const ShadowKinds& result) { return result.*part.*member; };
    };
    rows.push_back({{.key = kind + "_domain_px",
                     .label = kind + " shadow compared",
                     .unit = Unit::PixelCount,
                     .meaning = meaningOfDomain,
                     .formula = where},
                    figure(&ShadowKinds::Part::domainPx)});
    rows.push_back({{.key = kind + "_agreement",
                     .label = kind + " shadow agreement",
                     .unit = Unit::Ratio,
                     .goal = Goal::One,
                     .meaning = "share of these pixels that are lit in both frames or in shadow in both",
                     .formula = "agreement over " + where},
                    figure(&ShadowKinds::Part::agreement)});
    rows.push_back({{.key = kind + "_false_shadow_px",
                     .label = kind + ", false shadow",
                     .unit = Unit::PixelCount,
                     .goal = Goal::Zero,
                     .meaning = "those of them that are lit in the reference and in shadow in the test",
                     .formula = "FP over " + where},
                    figure(&ShadowKinds::Part::falseShadowPx)});
    rows.push_back({{.key = kind + "_false_lit_px",
                     .label = kind + ", false lit",
                     .unit = Unit::PixelCount,
                     .goal = Goal::Zero,
                     .meaning = "those of them that are in shadow in the reference and lit in the test",
                     .formula = "FN over " + where},
                    figure(&ShadowKinds::Part::falseLitPx)});
}

} // namespace

Metric shadowKindsMetric() {
    Rows rows;
    appendRows(rows, &ShadowKinds::attached, "attached", "N·L <= 0",
               "pixels that face away from the light: dark in the true image");
    appendRows(rows, &ShadowKinds::cast, "cast", "N·L > 0",
               "pixels that face the light: every shadow there is cast");
    for (FigureRow<ShadowKinds>& row : rows)
        if (row.info.key == "cast_agreement") row.info.report = {"cast shadows", "", "{:.4f}", "shadow.ber"};
    rows.push_back(
        {{.key = "no_normal_px",
          .label = "without normal",
          .unit = Unit::PixelCount,
          .meaning = "pixels of the shadow domain where the reference has no normal: in neither part"},
         &ShadowKinds::noNormalPx});
    return makeMetric<ShadowKinds>({
        .group = "shadow",
        .domain =
            "shadow domain; N: the reference's normal turned toward the camera, L: direction to the light",
        .scope = Scope::ObjectsByLight,
        .rows = std::move(rows),
        .compute =
            [](const MetricInput& input, ObjectSelection selection, const std::string& light) {
                return computeShadowKinds(input.pair, selection, light, input.light(light), input.camera);
            },
    });
}

} // namespace plumbline
