#include "tests/validate/metrics/random_frames.h"
#include "validate/metrics/shadow_agreement.h"
#include "validate/metrics/shadow_kinds.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;

/// Looks along -z: paintPixel's normal (0, 0, 1) faces it.
Camera cameraOnZ(const Frame& frame) {
    Camera camera;
    camera.projection = Camera::Projection::Orthographic;
    camera.positionWorld = {0, 0, 10};
    camera.width = frame.width();
    camera.height = frame.height();
    return camera;
}

Light distantLight(const Vec3& toLight) {
    Light light;
    light.name = "sun";
    light.toLightWorld = toLight;
    return light;
}

ShadowKinds kindsOf(const Frame& reference, const Frame& test, const Light& light) {
    const FramePair pair(reference, test, {});
    return computeShadowKinds(pair, allOf(pair), "sun", light, cameraOnZ(reference));
}

struct Facet {
    float normalX; // with N.Z = 1: the light along +x lights its front side if this is positive
    float shadow, testShadow;
};

// The light comes along +x. Reference normals (n, 0, 1): N.L has the sign of n.
//     n = -1 -1 -1 0    attached: 4 pixels; the test is lit in one of them: agreement 3/4
//     n = 1 1 1 1 1     facing the light: 2 of them dark; the test agrees on 3, with one false shadow and one
//     false
//                       lit pixel: 3/5
// The test's normals are opposite and must not be used.
TEST(ShadowKinds, NinePixels_EqualHandComputed) {
    const std::vector<Facet> facets{{-1, 1, 1}, {-1, 1, 1}, {-1, 1, 0}, {0, 1, 1}, {1, 1, 1},
                                    {1, 1, 0},  {1, 0, 1},  {1, 0, 0},  {1, 0, 0}};
    Frame reference = emptyFrame(9, 1);
    paintRectangle(reference, 0, 0, 9, 1);
    Frame test = reference;
    for (int x = 0; x < 9; ++x) {
        const Facet& facet = facets[static_cast<size_t>(x)];
        set(reference, "N.X", x, 0, facet.normalX);
        set(test, "N.X", x, 0, -facet.normalX);
        set(reference, "shadow.sun", x, 0, facet.shadow);
        set(test, "shadow.sun", x, 0, facet.testShadow);
    }
    const ShadowKinds result = kindsOf(reference, test, distantLight({1, 0, 0}));
    EXPECT_EQ(*result.attached.domainPx, 4);
    EXPECT_EQ(*result.attached.falseLitPx, 1);
    EXPECT_EQ(*result.attached.falseShadowPx, 0);
    EXPECT_EQ(*result.attached.agreement, 0.75);
    EXPECT_EQ(*result.cast.domainPx, 5);
    EXPECT_EQ(*result.cast.falseLitPx, 1);
    EXPECT_EQ(*result.cast.falseShadowPx, 1);
    EXPECT_EQ(*result.cast.agreement, 0.6);
    EXPECT_EQ(*result.noNormalPx, 0);
}

// A normal that points away from the camera is flipped: (1, 0, -1) becomes (-1, 0, 1), which faces away from
// a light along +x.
TEST(ShadowKinds, BackSide_UsesNormalTowardCamera) {
    Frame frame = emptyFrame(1, 1);
    paintPixel(frame, 0, 0, 1, 2);
    set(frame, "N.X", 0, 0, 1);
    set(frame, "N.Z", 0, 0, -1);
    EXPECT_EQ(*kindsOf(frame, frame, distantLight({1, 0, 0})).attached.domainPx, 1);
    EXPECT_EQ(*kindsOf(frame, frame, distantLight({-1, 0, 0})).cast.domainPx, 1);
}

// Points at x = -2 and 2 of a plane with the normal (1, 0, 1); a light at the origin is in the directions (1,
// 0, 0) and (-1, 0, 0).
TEST(ShadowKinds, PointLight_IsSeenFromPoint) {
    Frame frame = emptyFrame(2, 1);
    paintRectangle(frame, 0, 0, 2, 1);
    for (int x = 0; x < 2; ++x) {
        set(frame, "N.X", x, 0, 1);
        set(frame, "P.X", x, 0, x == 0 ? -2.0f : 2.0f);
        set(frame, "P.Z", x, 0, 0);
    }
    Light light;
    light.kind = Light::Kind::Point;
    light.positionWorld = {0, 0, 0};
    const ShadowKinds result = kindsOf(frame, frame, light);
    EXPECT_EQ(*result.cast.domainPx, 1);
    EXPECT_EQ(*result.attached.domainPx, 1);
    Frame far = frame;
    set(far, "P.X", 1, 0, -2.0f);
    EXPECT_EQ(*kindsOf(far, frame, light).cast.domainPx, 2);
}

TEST(ShadowKinds, PixelsWithoutNormal_AreCountedSeparately) {
    Frame frame = emptyFrame(3, 1);
    paintRectangle(frame, 0, 0, 3, 1);
    set(frame, "N.X", 0, 0, kNanF);
    set(frame, "N.Z", 1, 0, 0); // (0, 0, 0)
    const ShadowKinds result = kindsOf(frame, frame, distantLight({0, 0, 1}));
    EXPECT_EQ(*result.noNormalPx, 2);
    EXPECT_EQ(*result.cast.domainPx, 1);
    EXPECT_EQ(*result.attached.domainPx, 0);
    EXPECT_THAT(result.attached.agreement.reason(), HasSubstr("faces away from the light"));
}

TEST(ShadowKinds, NoLights_IsAbsentWithReason) {
    Frame frame = emptyFrame(1, 1);
    paintPixel(frame, 0, 0, 1, 2);
    const FramePair pair(frame, frame, {});
    const Light light = distantLight({0, 0, 1});
    const Camera camera = cameraOnZ(frame);
    const auto reason = [&](const FramePair& frames, const std::string& name,
                            const std::optional<Light>& given, const std::optional<Camera>& view) {
        const ShadowKinds result = computeShadowKinds(frames, allOf(frames), name, given, view);
        EXPECT_FALSE(result.attached.domainPx);
        return result.cast.agreement.reason();
    };
    EXPECT_THAT(reason(pair, "sun", std::nullopt, camera), HasSubstr("position of the light (light.sun)"));
    EXPECT_THAT(reason(pair, "sun", light, std::nullopt), HasSubstr("camera is not known"));
    EXPECT_THAT(reason(pair, "moon", light, camera), HasSubstr("neither frame has a channel shadow.moon"));
    Frame bare(1, 1);
    bare.add("id")[0] = 1;
    bare.add("shadow.sun")[0] = 0;
    EXPECT_THAT(reason(FramePair(bare, frame, {}), "sun", light, camera), HasSubstr("no channel N.X"));
    const FramePair testIsBare(frame, bare, {}); // its normals aren't needed
    EXPECT_EQ(*computeShadowKinds(testIsBare, allOf(testIsBare), "sun", light, camera).cast.agreement, 1);
    for (const char* axis : {"N.X", "N.Y", "N.Z"})
        bare.add(axis)[0] = 1;
    Light lamp = light;
    lamp.kind = Light::Kind::Point;
    EXPECT_THAT(reason(FramePair(bare, frame, {}), "sun", lamp, camera), HasSubstr("no channel P.X"));
}

RC_GTEST_PROP(ShadowKindsProperty, Parts_SumToDomain, ()) {
    const Frame a = randomFrame(), b = randomFrame();
    const FramePair pair(a, b, threeObjects());
    const ShadowAgreement whole = computeShadowAgreement(pair, allOf(pair), "sun");
    const ShadowKinds parts =
        computeShadowKinds(pair, allOf(pair), "sun", distantLight({1, 2, 1}), cameraOnZ(a));
    RC_ASSERT(*parts.attached.domainPx + *parts.cast.domainPx + *parts.noNormalPx ==
              static_cast<double>(whole.domainPx));
    RC_ASSERT(*parts.attached.falseLitPx + *parts.cast.falseLitPx <= static_cast<double>(whole.falseLitPx));
    // Brute force: N.Z is 1 or NaN, the camera looks along -z. The light direction isn't normalized, so that
    // sums are exact.
    uint64_t attached = 0;
    for (size_t i = 0; i < a.pixelCount(); ++i) {
        const float id = a.channel("id")[i];
        if (id == 0 || id != b.channel("id")[i]) continue;
        if (!std::isfinite(a.channel("shadow.sun")[i]) || !std::isfinite(b.channel("shadow.sun")[i]))
            continue;
        attached += a.channel("N.X")[i] + 2 * a.channel("N.Y")[i] + a.channel("N.Z")[i] <= 0;
    }
    RC_ASSERT(*parts.attached.domainPx == static_cast<double>(attached));
}

} // namespace
} // namespace plumbline
