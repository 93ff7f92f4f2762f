#include "scenes/core/error.h"
#include "tests/validate/results/sample_results.h"
#include "validate/metrics/metric_registry.h"
#include "validate/results/requirement.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Requirement parsed(const std::string& text) {
    return parseRequirement(text, "--require");
}

std::string refusal(const std::string& text) {
    try {
        parsed(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

RequirementResult held(const std::string& text, const TechniqueOutcome& outcome) {
    const std::vector<Requirement> requirements{parsed(text)};
    const auto results = evaluateRequirements(requirements, outcome);
    EXPECT_EQ(results.size(), 1u);
    return results.at(0);
}

TEST(Requirement, FullText_IsRead) {
    const Requirement plain = parsed("silhouette.iou>=0.99");
    EXPECT_EQ(plain.text, "silhouette.iou >= 0.99");
    EXPECT_EQ(plain.key, "silhouette.iou");
    EXPECT_EQ(plain.comparison, ">=");
    EXPECT_EQ(plain.bound, 0.99);
    const Requirement full = parsed("  shadow.sun.agreement @ torus  <\t-1e-3 ");
    EXPECT_EQ(full.key, "shadow.agreement");
    EXPECT_EQ(full.light, "sun");
    EXPECT_EQ(full.object, "torus");
    EXPECT_EQ(full.comparison, "<");
    EXPECT_EQ(full.bound, -1e-3);
    EXPECT_EQ(parsed("silhouette.boundary_iou.2pct > 0").key, "silhouette.boundary_iou.2pct");
}

TEST(Requirement, MalformedText_IsRefused) {
    EXPECT_THAT(refusal("silhouette.iou"),
                AllOf(StartsWith("--require: "), HasSubstr("contains no comparison")));
    EXPECT_THAT(refusal(""), HasSubstr("contains no comparison"));
    EXPECT_THAT(refusal("silhouette.iou = 1"), HasSubstr("expected METRIC[@OBJECT] >= NUMBER"));
    EXPECT_THAT(refusal("silhouette.iou >= much"), HasSubstr("'much' is not a finite number"));
    EXPECT_THAT(refusal("silhouette.iou >= 0.9 0"), HasSubstr("'0.9 0'"));
    EXPECT_THAT(refusal("silhouette.iou >= nan"), HasSubstr("not a finite number"));
    EXPECT_THAT(refusal("silhouette.iou >= inf"), HasSubstr("not a finite number"));
    EXPECT_THAT(refusal("silhouette.iou >= "), HasSubstr("''"));
    EXPECT_THAT(refusal("silhouette.iou@ >= 1"), HasSubstr("no object follows '@'"));
    EXPECT_THAT(refusal(">= 1"), HasSubstr("no metric is called ''"));
    EXPECT_THAT(refusal("silhouette.oui >= 1"), HasSubstr("did you mean 'silhouette.iou'?"));
    EXPECT_THAT(refusal("shadow.agrement >= 1"), HasSubstr("did you mean 'shadow.agreement'?"));
    EXPECT_THAT(refusal("shadow.sun.agrement >= 1"), HasSubstr("did you mean 'shadow.sun.agreement'?"));
    EXPECT_THAT(refusal("shadow.sun >= 1"), HasSubstr("no metric is called 'shadow.sun'"));
    EXPECT_THAT(refusal("image.psnr_db@torus > 3"), HasSubstr("image.psnr_db is not computed per object"));
}

TEST(Requirement, Spacing_KeepsText) {
    EXPECT_EQ(parsed(" silhouette.iou @ torus>=0.9 ").text, "silhouette.iou@torus >= 0.9");
    EXPECT_EQ(parsed("shadow.sun.iou@torus > 0").text, "shadow.sun.iou@torus > 0");
}

TEST(Requirement, UnknownNames_AreRefused) {
    const std::vector<std::string> lights{"sun"}, objects{"torus", "floor"};
    EXPECT_NO_THROW(checkNames(parsed("shadow.sun.iou@torus > 0"), lights, objects));
    EXPECT_NO_THROW(checkNames(parsed("silhouette.iou > 0"), {}, {}));
    const auto message = [&](const std::string& text, std::span<const std::string> knownLights) {
        try {
            checkNames(parsed(text), knownLights, objects);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_THAT(message("shadow.sum.iou > 0", lights),
                AllOf(HasSubstr("no light is called 'sum'"), HasSubstr("did you mean 'sun'?")));
    EXPECT_THAT(message("shadow.sun.iou > 0", {}), HasSubstr("there is no light"));
    EXPECT_THAT(message("depth.mae@tours > 0", lights), HasSubstr("expected torus or floor"));
}

// sample_results.h: IoU 8/16, missing 4, shadow agreement 6/8; object 2 has no relief.
TEST(Requirement, Figure_IsComparedWithBound) {
    const TechniqueOutcome outcome = sampleResults().techniques[0];
    for (const auto& [text, passed] : {std::pair("silhouette.iou >= 0.5", true),
                                       {"silhouette.iou > 0.5", false},
                                       {"silhouette.iou <= 0.5", true},
                                       {"silhouette.iou < 0.5", false},
                                       {"silhouette.missing_px <= 4", true},
                                       {"silhouette.missing_px < 4", false},
                                       {"cost.ms_median <= 12.5", true},
                                       {"image.domain_px >= 48", true},
                                       {"silhouette.missing_px@object 1 <= 4", true}})
        EXPECT_EQ(held(text, outcome).passed, passed) << text;
    EXPECT_EQ(*held("silhouette.iou >= 0.5", outcome).value, 0.5);
    EXPECT_EQ(held("silhouette.iou@object 1 >= 0.5", outcome).key, "silhouette.iou@object 1");
}

TEST(Requirement, AbsentFigure_Fails) {
    const Results results = sampleResults();
    for (const char* text : {"depth.rmse_relief@object 2 <= 1", "depth.rmse_relief@object 2 >= 0"}) {
        const RequirementResult result = held(text, results.techniques[0]);
        EXPECT_FALSE(result.passed);
        EXPECT_THAT(result.value.reason(), HasSubstr("no relief"));
    }
    const RequirementResult failed = held("silhouette.missing_px <= 100", results.techniques[1]);
    EXPECT_FALSE(failed.passed);
    EXPECT_EQ(failed.value.reason(), "the technique failed");
    EXPECT_FALSE(held("silhouette.iou@nothing >= 0", results.techniques[0]).passed);
    EXPECT_FALSE(held("shadow.moon.domain_px >= 0", results.techniques[0]).passed);
    Frame unlit = sampleReference();
    unlit.remove("shadow.sun");
    TechniqueOutcome dark;
    dark.comparison = compareFrames(unlit, unlit, {}, std::nullopt);
    EXPECT_FALSE(
        held("shadow.false_lit_px <= 9", dark).passed); // counts of a missing channel are absent, not 0
}

TEST(Requirement, ShadowKey_CoversEveryLight) {
    TechniqueOutcome outcome = sampleResults().techniques[0];
    copyLight(outcome.comparison.pooled, "sun", "lamp");
    setFigure(outcome.comparison.pooled, "shadow.agreement", 1.0, "lamp");
    const std::vector<Requirement> requirements{parsed("shadow.agreement >= 0.9")};
    const auto results = evaluateRequirements(requirements, outcome);
    ASSERT_EQ(results.size(), 2u);
    EXPECT_EQ(results[0].key, "shadow.lamp.agreement");
    EXPECT_TRUE(results[0].passed);
    EXPECT_EQ(results[1].key, "shadow.sun.agreement");
    EXPECT_FALSE(results[1].passed);
    EXPECT_EQ(*held("shadow.sun.agreement >= 0.7", outcome).value, 0.75);
}

} // namespace
} // namespace plumbline
