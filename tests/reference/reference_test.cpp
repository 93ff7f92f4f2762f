// Compares frames of the reference with results derived by hand.
#include "reference/reference.h"
#include "scenes/core/error.h"
#include "scenes/maps/generate_map.h"
#include "scenes/mesh/shapes/shapes.h"
#include "tests/reference/test_scenes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstring>

namespace plumbline {
namespace {

Frame renderReference(const Scene& scene, int rate) {
    ReferenceOptions options;
    options.rate = rate;
    return ReferenceScene(scene, options).render();
}

struct PixelReader {
    const Frame& frame;
    float operator()(const char* channel, int x, int y) const {
        return frame.channel(channel)[static_cast<size_t>(y * frame.width() + x)];
    }
};

// The plane is 5 below the camera; the square of side 2 covers the middle half of an image 4 units high: with
// 40 pixels of 0.1, the columns and rows 10 … 29.
TEST(Reference, PlaneAtConstantDepth_HasExactDepth) {
    const auto map = std::make_shared<HeightMap>(HeightMap::constant("half", 0.5f));
    const Frame frame = renderReference(squareScene(map, 0.25), 8);
    const PixelReader at{frame};
    int covered = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const bool inside = x >= 10 && x < 30 && y >= 10 && y < 30;
            ASSERT_EQ(at("A", x, y), inside ? 1.0f : 0.0f) << x << " " << y;
            covered += inside;
            if (!inside) {
                EXPECT_EQ(at("Z", x, y), kInfinityF);
                EXPECT_EQ(at("id", x, y), 0.0f);
                EXPECT_TRUE(std::isnan(at("shadow.sun", x, y)));
                continue;
            }
            EXPECT_FLOAT_EQ(at("Z", x, y), 5.125f); // 0.25 * 0.5 below the plane
            EXPECT_FLOAT_EQ(at("P.Z", x, y), -0.125f);
            EXPECT_NEAR(at("P.X", x, y), (x + 0.5) * 0.1 - 2, 1e-6);
            EXPECT_NEAR(at("P.Y", x, y), 2 - (y + 0.5) * 0.1, 1e-6); // row 0 is the top
            EXPECT_NEAR(at("st.S", x, y), ((x + 0.5) * 0.1 - 1) / 2, 1e-6);
            EXPECT_NEAR(at("st.T", x, y), (3 - (y + 0.5) * 0.1) / 2, 1e-6);
            EXPECT_EQ(at("N.Z", x, y), 1.0f);
            EXPECT_EQ(at("id", x, y), 1.0f);
            EXPECT_EQ(at("shadow.sun", x, y), 0.0f);
        }
    EXPECT_EQ(covered, 400);
}

// The square of PlaneAtConstantDepth_HasExactDepth from behind, 5 - 0.125 away. Its normal stays outward.
TEST(Reference, SquareFromBehind_ShowsBackSideUnlessCulled) {
    const auto map = std::make_shared<HeightMap>(HeightMap::constant("half", 0.5f));
    Scene scene = squareScene(map, 0.25);
    const Frame front = renderReference(scene, 8);
    scene.camera.positionWorld = {0, 0, -5};
    const Frame back = renderReference(scene, 8);
    const PixelReader inFront{front}, behind{back};
    EXPECT_EQ(inFront("facing", 20, 20), 1.0f);
    EXPECT_TRUE(std::isnan(behind("facing", 5, 20)));
    EXPECT_EQ(behind("facing", 20, 20), -1.0f);
    EXPECT_FLOAT_EQ(behind("Z", 20, 20), 4.875f);
    EXPECT_EQ(behind("N.Z", 20, 20), 1.0f);
    EXPECT_EQ(behind("shadow.sun", 20, 20), 1.0f);
    scene.objects[0].cull = Cull::Back;
    const Frame none = renderReference(scene, 8);
    for (const float covered : none.channel("A"))
        EXPECT_EQ(covered, 0.0f);
    scene.camera.positionWorld = {0, 0, 5};
    const Frame culled = renderReference(scene, 8);
    for (const std::string& name : front.channelNames())
        EXPECT_EQ(std::memcmp(culled.channel(name).data(), front.channel(name).data(),
                              front.pixelCount() * sizeof(float)),
                  0)
            << name;
}

// Two squares, the nearer seen from behind. It is transparent, and shadows the other one all the same.
TEST(Reference, CulledBackSide_CastsShadow) {
    Scene scene = squareScene(nullptr, 0);
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].name = "turned";
    scene.objects[1].translate = {0, 0, 1};
    scene.objects[1].rotateDegrees = {180, 0, 0};
    scene.objects[1].cull = Cull::Back;
    const Frame frame = renderReference(scene, 1);
    const PixelReader at{frame};
    EXPECT_EQ(at("id", 20, 20), 1.0f);
    EXPECT_FLOAT_EQ(at("Z", 20, 20), 5.0f);
    EXPECT_EQ(at("shadow.sun", 20, 20), 1.0f);
    EXPECT_EQ(at("uncertain", 20, 20), 0.0f);
}

// A ramp d = s over the whole square: texel centers of a 2-texel clamped map at s = 1/4 and 3/4; between them
// d = 2 s - 1/2. With depth 1 and x = 2 s - 1 the surface is z = -(x + 1/2) for |x| <= 1/2, 0 to the left and
// -1 to the right. Its normal on the slope is (1, 0, 1) / sqrt 2.
TEST(Reference, Ramp_HasSlopeAndNormal) {
    const auto map =
        std::make_shared<HeightMap>("ramp", 2, 1, std::vector<float>{0, 1}, Wrap::Clamp, Wrap::Clamp);
    const Frame frame = renderReference(squareScene(map, 1), 16);
    const PixelReader at{frame};
    for (int x = 10; x < 30; ++x) {
        const double worldX = (x + 0.5) * 0.1 - 2;
        const double expected = std::clamp(worldX + 0.5, 0.0, 1.0);
        EXPECT_NEAR(at("Z", x, 20), 5 + expected, 1e-5) << x;
        const bool slope = std::abs(worldX) < 0.5;
        EXPECT_NEAR(at("N.X", x, 20), slope ? std::sqrt(0.5) : 0, 1e-6) << x;
        EXPECT_NEAR(at("N.Z", x, 20), slope ? std::sqrt(0.5) : 1, 1e-6) << x;
    }
}

// The same ramp under a light from (-1, 0, 1), at a slightly lower elevation. The top (x < -1/2, z = 0) is
// lit. The slope, normal (1, 0, 1), just faces away from the light: attached shadow. A ray from the floor (x,
// -1) rises one per unit and must clear the edge of the top at (-1/2, 0): it passes the edge at height x -
// 1/2 > 0 for every x > 1/2, so the floor is lit. At depth 2 the floor is at -2 and the ray passes the edge
// at height x - 3/2 < 0 for every x < 1: it is in shadow.
TEST(Reference, Shadow_HasClosedFormBorder) {
    const auto map =
        std::make_shared<HeightMap>("ramp", 2, 1, std::vector<float>{0, 1}, Wrap::Clamp, Wrap::Clamp);
    Scene scene = squareScene(map, 1);
    scene.lights[0].toLightWorld = glm::normalize(Vec3(-1.001, 0, 1));
    const Frame frame = renderReference(scene, 16);
    const PixelReader at{frame};
    EXPECT_EQ(at("shadow.sun", 12, 20), 0.0f); // the top
    EXPECT_EQ(at("shadow.sun", 20, 20), 1.0f); // the slope just faces away
    EXPECT_EQ(at("shadow.sun", 28, 20), 0.0f); // the floor clears the edge by 0.3
    scene.objects[0].relief->depth = 2;
    const Frame deep = renderReference(scene, 16);
    EXPECT_EQ(PixelReader{deep}("shadow.sun", 28, 20), 1.0f);
    EXPECT_EQ(PixelReader{deep}("shadow.sun", 12, 20), 0.0f);
}

TEST(Reference, OccluderBehindPointLight_CastsNoShadow) {
    // A light at (0, 0, 1) between the camera and the plane. There is no occluder between it and the plane;
    // the one at z = 2 on the camera's side must not cast a shadow.
    Scene scene = squareScene(nullptr, 0);
    scene.lights[0].kind = Light::Kind::Point;
    scene.lights[0].positionWorld = {0, 0, 1};
    SceneObject roof = scene.objects[0];
    roof.name = "roof";
    roof.scale = 0.2;
    roof.translate = {0, 0, 2};
    scene.objects.push_back(roof);
    const Frame frame = renderReference(scene, 1);
    const PixelReader at{frame};
    EXPECT_EQ(at("id", 20, 20), 2.0f);         // the roof occludes the center
    EXPECT_EQ(at("shadow.sun", 20, 20), 1.0f); // and is lit from below: attached shadow above
    EXPECT_EQ(at("id", 12, 20), 1.0f);
    EXPECT_EQ(at("shadow.sun", 12, 20), 0.0f);
    // An occluder beyond the light must not cast a shadow either: the ray from (-0.75, 0, 0) to the light
    // would continue to (0.75, 0, 2), where the roof is now.
    scene.objects[1].translate = {0.75, 0, 2};
    const Frame beyond = renderReference(scene, 1);
    EXPECT_EQ(PixelReader{beyond}("id", 27, 20), 2.0f);
    EXPECT_EQ(PixelReader{beyond}("shadow.sun", 12, 20), 0.0f);
    scene.objects[1].translate = {0, 0, 2};
    // Now the light is above the roof: the plane's shadow is the roof (half side 0.2 at height 2) projected
    // from height 4: half side 0.4, so of the pixels visible beside the roof (|x| > 0.2), those with |x| <
    // 0.4 are in shadow.
    scene.lights[0].positionWorld = {0, 0, 4};
    const Frame above = renderReference(scene, 1);
    EXPECT_EQ(PixelReader{above}("shadow.sun", 20, 20), 0.0f);
    EXPECT_EQ(PixelReader{above}("shadow.sun", 23, 20), 1.0f); // x = 0.35
    EXPECT_EQ(PixelReader{above}("shadow.sun", 24, 20), 0.0f); // x = 0.45
}

TEST(Reference, PlainObjects_AreRendered) {
    Scene scene = squareScene(nullptr, 0);
    scene.objects[0].mesh.uvs.clear();
    scene.objects[0].mesh.faceUvs.clear();
    const Frame frame = renderReference(scene, 2);
    EXPECT_FLOAT_EQ(PixelReader{frame}("Z", 20, 20), 5.0f);
}

TEST(Reference, BackSide_IsSeenAndShadedForCamera) {
    Scene scene = squareScene(nullptr, 0);
    scene.camera.positionWorld = {0, 0, -5};
    scene.lights[0].toLightWorld = {0, 0, -1};
    const Frame frame = renderReference(scene, 1);
    EXPECT_EQ(PixelReader{frame}("A", 20, 20), 1.0f);
    EXPECT_EQ(PixelReader{frame}("N.Z", 20, 20), 1.0f);        // outward, not flipped toward the camera
    EXPECT_EQ(PixelReader{frame}("shadow.sun", 20, 20), 0.0f); // the visible side faces the light
}

// The ramp at rate 1 is one flat facet from (-1, ., 0) to (1, ., -1), normal (1, 0, 2); the true normal on
// its slope is (1, 0, 1). A camera toward (-1, 0, 0.8) sees the facet's outer side (-1 + 1.6 > 0), although
// the true normal faces away (-1 + 0.8 < 0). A light toward (1, 0, 0.2) is on the outer side of both, so the
// point is lit.
TEST(Reference, SideSeen_IsFacets) {
    const auto map =
        std::make_shared<HeightMap>("ramp", 2, 1, std::vector<float>{0, 1}, Wrap::Clamp, Wrap::Clamp);
    Scene scene = squareScene(map, 1);
    scene.camera.positionWorld = Vec3(-5, 0, 4);
    scene.camera.targetWorld = Vec3(0, 0, -0.5);
    scene.lights[0].toLightWorld = glm::normalize(Vec3(1, 0, 0.2));
    const Frame frame = renderReference(scene, 1);
    const PixelReader at{frame};
    EXPECT_NEAR(at("N.X", 20, 20), std::sqrt(0.5), 1e-6);
    EXPECT_EQ(at("shadow.sun", 20, 20), 0.0f);
}

TEST(Reference, LoopAndSubFaces_CloseSurface) {
    // An icosahedron (Loop) and a pentagonal prism (Catmull-Clark with n-gons), displaced, seen from inside:
    // every ray must hit, because a miss would mean a crack.
    SceneObject object;
    object.name = "icosahedron";
    object.mesh.name = "icosahedron";
    const double phi = (1 + std::sqrt(5.0)) / 2;
    object.mesh.points = {{-1, phi, 0}, {1, phi, 0}, {-1, -phi, 0}, {1, -phi, 0},
                          {0, -1, phi}, {0, 1, phi}, {0, -1, -phi}, {0, 1, -phi},
                          {phi, 0, -1}, {phi, 0, 1}, {-phi, 0, -1}, {-phi, 0, 1}};
    object.mesh.faceSizes.assign(20, 3);
    object.mesh.faceVertices = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int k = 0; k < 60; ++k)
        object.mesh.uvs.push_back(Vec2(0.37 * k, 0.61 * ((k * 7) % 60))); // torn at every edge
    for (int k = 0; k < 60; ++k)
        object.mesh.faceUvs.push_back(k);
    std::vector<float> depths;
    for (int k = 0; k < 64; ++k)
        depths.push_back(float((k * 37) % 64) / 63.0f);
    object.relief = Relief{std::make_shared<HeightMap>("noise", 8, 8, depths), 0.1, 0.0, Vec2(1), Vec2(0)};

    Scene scene;
    scene.camera.positionWorld = {0.05, -0.03, 0};
    scene.camera.targetWorld = {0.3, 0.2, 1};
    scene.camera.fovYDegrees = 150;
    scene.camera.width = scene.camera.height = 256;
    for (const Scheme scheme : {Scheme::Loop, Scheme::CatmullClark, Scheme::None})
        for (const int rate : {1, 2, 16, 64}) {
            object.scheme = scheme;
            scene.objects = {object};
            const Frame frame = renderReference(scene, rate);
            for (const float covered : frame.channel("A"))
                ASSERT_EQ(covered, 1.0f) << rate;
            for (const float n : frame.channel("N.X"))
                ASSERT_TRUE(std::isfinite(n));
        }
}

TEST(Reference, AnyThreadCount_GivesEqualBytes) {
    std::vector<float> depths;
    for (int k = 0; k < 64; ++k)
        depths.push_back(float((k * 37) % 64) / 63.0f);
    Scene scene = squareScene(std::make_shared<HeightMap>("noise", 8, 8, depths), 0.3, 3);
    scene.camera.width = scene.camera.height = 200;
    scene.lights[0].toLightWorld = glm::normalize(Vec3(1, 0.3, 0.5));
    std::vector<Frame> frames;
    for (const size_t threads : {1u, 2u, 8u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        frames.push_back(renderReference(scene, 32));
    }
    for (const Frame& frame : frames)
        for (const std::string& name : frame.channelNames())
            EXPECT_EQ(std::memcmp(frame.channel(name).data(), frames[0].channel(name).data(),
                                  frame.pixelCount() * sizeof(float)),
                      0)
                << name;
}

std::shared_ptr<const HeightMap> roughMap() {
    std::vector<float> depths;
    for (int k = 0; k < 1024; ++k)
        depths.push_back(float((k * 37) % 101) / 100.0f);
    return std::make_shared<HeightMap>("rough", 32, 32, depths);
}

TEST(Reference, Rates_RiseUntilAimIsMet) {
    uint64_t coarser = 0;
    for (const double aimPx : {0.5, 0.05}) {
        const Scene scene = squareScene(roughMap(), 0.2, 4);
        ReferenceOptions options;
        options.errorPx = aimPx;
        ReferenceScene reference(scene, options);
        reference.render();
        const Certificate& certificate = reference.stats().certificate;
        EXPECT_LE(certificate.pxP99, aimPx);
        EXPECT_GT(certificate.pxP99,
                  aimPx / 32); // and not far beyond it: doubling the rate gains a factor of 2 to 4
        EXPECT_EQ(certificate.limit, "");
        EXPECT_EQ(certificate.pxAim, aimPx);
        EXPECT_GT(reference.stats().microTriangles, coarser);
        coarser = reference.stats().microTriangles;
    }
}

// Plans only examine some of a face's grids. For these target errors, the first plan of a torus with bricks
// isn't fine enough, and the measurements of its run make the second one fine enough.
TEST(Reference, MissedAim_RunsAgainFiner) {
    Scene scene = squareScene(
        std::make_shared<HeightMap>(generateMap("bricks", 64, 3, Wrap::Repeat, Wrap::Repeat)), 0.1, 1);
    scene.objects[0].mesh = makeTorus(0.8, 0.4, 12, 6);
    scene.objects[0].scheme = Scheme::CatmullClark;
    scene.objects[0].relief->tile = {3.7, 2.3};
    for (const double aimPx : {0.4, 0.1, 0.05}) {
        ReferenceOptions options;
        options.errorPx = aimPx;
        ReferenceScene reference(scene, options);
        reference.render();
        EXPECT_LE(reference.stats().certificate.pxP99, aimPx) << *reference.stats().certificate.limit;
    }
}

TEST(Reference, MemoryBudget_LimitsRatesAndIsReported) {
    const Scene scene = squareScene(roughMap(), 0.2, 4);
    ReferenceOptions options;
    options.errorPx = 0.001;
    options.memoryBytes = uint64_t(1) << 20;
    ReferenceScene reference(scene, options);
    reference.render();
    EXPECT_GT(reference.stats().certificate.pxP99, options.errorPx);
    EXPECT_EQ(reference.stats().certificate.limit, "--memory 1 MB");
    EXPECT_LE(reference.stats().microTriangles * 20, options.memoryBytes);
    EXPECT_GT(reference.stats().objects[0].wantedRate, reference.stats().objects[0].rate);
    options.memoryBytes = 10;
    EXPECT_THROW(ReferenceScene(scene, options), MachineError);
}

TEST(Reference, FlatFaces_AreTwoTriangles) {
    const Scene plain = squareScene(nullptr, 0);
    EXPECT_EQ(ReferenceScene(plain, {}).stats().microTriangles, 2u);
    // A constant map displaces a flat face without bending it.
    const Scene constant = squareScene(std::make_shared<HeightMap>(HeightMap::constant("half", 0.5f)), 0.1);
    EXPECT_EQ(ReferenceScene(constant, {}).stats().microTriangles, 2u);
}

TEST(Reference, InvalidRates_AreRefused) {
    const Scene scene = squareScene(nullptr, 0);
    ReferenceOptions options;
    for (const int wrong : {3, -1, 2048, 100}) {
        options.rate = wrong;
        EXPECT_THROW(ReferenceScene(scene, options), InputError) << wrong;
    }
    options.rate = 1024;
    options.memoryBytes = uint64_t(1) << 20;
    EXPECT_THROW(ReferenceScene(scene, options), MachineError);
}

// A square of 16 x 16 faces, of which the middle 4 x 4 are in the image. Lit from above, the outer faces
// can't cast shadows into it. Under a light from the side, only the faces toward the light can.
TEST(Reference, UnseenFaces_AreCoarseUnlessCasting) {
    Scene scene = squareScene(roughMap(), 0.05, 16);
    scene.objects[0].mesh = squareMesh(8, 16);
    scene.camera.viewHeight = 2;
    const auto cellsAt = [&](int column, int row) {
        ReferenceScene reference(scene, {});
        return int(reference.microMeshes()[0].lattices[static_cast<size_t>(row * 16 + column)].columns);
    };
    EXPECT_GT(cellsAt(8, 8), 1);
    EXPECT_EQ(cellsAt(0, 8), 1);
    EXPECT_EQ(cellsAt(15, 8), 1);
    scene.lights[0].toLightWorld = glm::normalize(Vec3(1, 0, 0.1));
    EXPECT_EQ(cellsAt(0, 8), 1);
    EXPECT_GT(cellsAt(15, 8), 1);
    EXPECT_LT(cellsAt(15, 8), cellsAt(8, 8));
    EXPECT_EQ(cellsAt(15, 15), 1);
    scene.lights[0].kind = Light::Kind::Point; // on the other side of the image
    scene.lights[0].positionWorld = {-6, 0, 1};
    EXPECT_GT(cellsAt(0, 8), 1);
    EXPECT_EQ(cellsAt(15, 8), 1);
}

// The error of a cylinder without relief is proportional to the square of a segment's angle. With a relief
// whose creases lie on the lattice, the mixed derivative of its patches adds a term of the same order. So
// each doubling of the rate reduces the error to a quarter: 1/3.5 to 1/4.5, with float rounding still far
// below.
TEST(Reference, RisingRate_ErrorFallsQuadratically) {
    Scene scene = squareScene(roughMap(), 0.1, 1);
    scene.objects[0].mesh = makeCylinder(0.8, 1.6, 8, 2);
    scene.objects[0].scheme = Scheme::CatmullClark;
    scene.objects[0].relief->tile = {
        4, 1}; // 16 texels per face in both directions, half a texel per cell at rate 32
    for (const bool relief : {false, true}) {
        Scene one = scene;
        if (!relief) one.objects[0].relief.reset();
        double before = 0;
        for (const int rate : {32, 64, 128}) {
            ReferenceOptions options;
            options.rate = rate;
            ReferenceScene reference(one, options);
            reference.render();
            const double error = *reference.stats().certificate.worldP99;
            if (before > 0) {
                EXPECT_NEAR(before / error, 4, 0.5) << "relief " << relief << ", rate " << rate;
            }
            before = error;
        }
    }
}

/// The scene with all lengths scaled.
Scene scaled(Scene scene, double scale) {
    scene.camera.positionWorld *= scale;
    scene.camera.targetWorld *= scale;
    scene.camera.viewHeight *= scale;
    for (SceneObject& object : scene.objects) {
        for (Vec3& point : object.mesh.points)
            point *= scale;
        object.translate *= scale;
        if (object.relief) object.relief->depth *= scale;
        if (object.relief) object.relief->offset *= scale;
    }
    for (Light& light : scene.lights)
        light.positionWorld *= scale;
    return scene;
}

// Scaling by a power of two only changes the exponents of floats, so frames are bit-identical except for
// scaled depths. Scaling by a power of ten rounds coordinates differently, so a pixel exactly on an edge may
// change sides; such pixels are uncertain.
TEST(Reference, WorldScale_KeepsImage) {
    Scene scene = squareScene(roughMap(), 0.3, 3);
    scene.camera.projection = Camera::Projection::Perspective;
    scene.camera.positionWorld = {1.5, -2.5, 2};
    scene.camera.width = scene.camera.height = 120;
    scene.lights[0].toLightWorld = glm::normalize(Vec3(1, 0.3, 0.4));
    Light lamp;
    lamp.name = "lamp";
    lamp.kind = Light::Kind::Point;
    lamp.positionWorld = {-0.6, 0.2, 1.1};
    scene.lights.push_back(lamp);
    const Frame unit = renderReference(scene, 32);
    for (const double scale : {0x1p-13, 0x1p13, 1e-4, 1e4}) {
        const bool exact = scale == 0x1p-13 || scale == 0x1p13;
        const Frame other = renderReference(scaled(scene, scale), 32);
        const auto uncertain = unit.channel("uncertain");
        size_t differ = 0;
        for (size_t i = 0; i < unit.pixelCount(); ++i) {
            if (uncertain[i] != 0 && !exact) continue;
            ASSERT_EQ(unit.channel("A")[i], other.channel("A")[i]) << scale << ", pixel " << i;
            if (unit.channel("A")[i] == 0) continue;
            EXPECT_NEAR(other.channel("Z")[i] / scale / unit.channel("Z")[i], 1, 1e-5)
                << scale << ", pixel " << i;
            for (const char* light : {"sun", "lamp"})
                differ += unit.channel(shadowChannel(light))[i] != other.channel(shadowChannel(light))[i] &&
                          unit.channel(uncertainShadowChannel(light))[i] == 0;
        }
        EXPECT_EQ(differ, 0u) << scale;
        const auto count = [](const Frame& frame, const char* name) {
            return std::count(frame.channel(name).begin(), frame.channel(name).end(), 1.0f);
        };
        for (const char* name : {"uncertain", "uncertain.shadow.sun", "uncertain.shadow.lamp"})
            EXPECT_NEAR(double(count(other, name)), double(count(unit, name)),
                        0.01 * double(count(unit, name)) + 2)
                << scale << ", " << name;
    }
}

TEST(Reference, ReliefWithoutUvs_IsRefused) {
    Scene scene = squareScene(std::make_shared<HeightMap>(HeightMap::constant("half", 0.5f)), 0.1);
    scene.objects[0].mesh.faceUvs.clear();
    scene.objects[0].mesh.uvs.clear();
    EXPECT_THROW(renderReference(scene, 1), InputError);
}

} // namespace
} // namespace plumbline
