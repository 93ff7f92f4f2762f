// Scenes drafted for unknown meshes: framing, lighting, and the written scene files.
#include "scenes/draft/scene_text.h"
#include "scenes/mesh/obj_file.h"
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/displaced_surface.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/scenes/scene_file/scene_file_fixture.h"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <ostream>

namespace plumbline {
namespace {

using testing::HasSubstr;

HeightMap halfDeep(int width = 64, int height = 64, Wrap wrapS = Wrap::Repeat) {
    std::vector<float> depths(static_cast<size_t>(width) * static_cast<size_t>(height), 0.5f);
    depths[0] = 0;
    depths[1] = 1;
    return HeightMap("half", width, height, std::move(depths), wrapS, Wrap::Repeat);
}

/// Applies `move` to every point.
template <class Move>
ControlMesh moved(ControlMesh mesh, const Move& move) {
    for (Vec3& point : mesh.points)
        point = move(point);
    return mesh;
}

std::string objText(const ControlMesh& mesh) {
    std::string text;
    for (const Vec3& p : mesh.points)
        text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const Vec2& uv : mesh.uvs)
        text += fmt::format("vt {} {}\n", uv.x, uv.y);
    size_t corner = 0;
    for (const int size : mesh.faceSizes) {
        text += "f";
        for (const size_t end = corner + static_cast<size_t>(size); corner < end; ++corner)
            text += fmt::format(" {}/{}", mesh.faceVertices[corner] + 1, mesh.faceUvs[corner] + 1);
        text += "\n";
    }
    return text;
}

struct Shape {
    const char* name;
    ControlMesh mesh;
};

void PrintTo(const Shape& shape, std::ostream* stream) {
    *stream << shape.name;
}

std::vector<Shape> shapes() {
    const ControlMesh torus = makeTorus(1, 0.4, 16, 8), plane = makePlane(2, 2, 3, 3);
    return {{"torus", torus},
            {"sphere", makeSphere(1, 4)},
            {"box", makeBox({1, 1, 1}, 2)},
            {"teapot", makeTeapot(4)},
            {"plane", plane},
            {"column", makeCylinder(0.5, 4, 8, 4)},
            {"plane_upside_down", moved(plane, [](const Vec3& p) { return Vec3(p.x, -p.y, -p.z); })},
            {"plane_turned_away", moved(plane, [](const Vec3& p) { return Vec3(p.x, p.z, -p.y - 1); })},
            {"tiny", moved(torus, [](const Vec3& p) { return p * 1e-6; })},
            {"huge", moved(torus, [](const Vec3& p) { return p * 1e6; })},
            {"far_away", moved(torus, [](const Vec3& p) { return p + Vec3(5000, -1e4, 300); })}};
}

DraftWishes withScheme(Scheme scheme) {
    DraftWishes wishes;
    wishes.scheme = scheme;
    return wishes;
}

DraftWishes withTile(const Vec2& tile) {
    DraftWishes wishes;
    wishes.tile = tile;
    return wishes;
}

class Drafts : public SceneFile {
  protected:
    Scene draftAndRead(const ControlMesh& mesh, const DraftWishes& wishes = {}) {
        writeFile(folder_ / "my mesh.obj", objText(mesh));
        const SceneDraft draft = draftScene(readObj(folder_ / "my mesh.obj"), halfDeep(), wishes);
        return read(sceneText(draft, "my mesh.obj", "maps/stone.png", halfDeep(), true));
    }
};

class DraftsOfShapes : public Drafts, public testing::WithParamInterface<Shape> {};
INSTANTIATE_TEST_SUITE_P(All, DraftsOfShapes, testing::ValuesIn(shapes()),
                         [](const auto& shape) { return shape.param.name; });

/// Samples of the displaced surface of the scene's object, 8 x 8 per patch, for a relief of constant depth
/// `d`.
std::vector<DisplacedSample> surfaceAt(const SceneObject& object, float d) {
    const std::unique_ptr<BaseSurface> surface = makeBaseSurface(object);
    Relief relief = *object.relief;
    relief.map = std::make_shared<const HeightMap>(HeightMap::constant("d", d));
    BaseSurface::Evaluator evaluator(*surface);
    std::vector<DisplacedSample> samples;
    for (int patch = 0; patch < static_cast<int>(surface->patches().size()); ++patch) {
        evaluator.setPatch(patch);
        for (int i = 0; i < 64; ++i)
            samples.push_back(displace(evaluator.sample((i % 8) / 7.0, (i / 8) / 7.0), &relief));
    }
    return samples;
}

TEST_P(DraftsOfShapes, EveryShape_IsFramedAndLit) {
    const Scene scene = draftAndRead(GetParam().mesh);
    Bounds seen; // as fractions of the image
    double lit = 0, facing = 0;
    for (const float d : {0.0f, 1.0f})
        for (const DisplacedSample& sample : surfaceAt(scene.objects[0], d)) {
            const Vec3 pixel = pixelFromWorld(scene.camera, sample.position);
            ASSERT_GT(pixel.z, 0);
            seen.add({pixel.x / scene.camera.width, pixel.y / scene.camera.height, 0});
            const Vec3 toCamera = CameraRays(scene.camera).towardCamera(sample.position);
            if (glm::dot(sample.normal, toCamera) <= 0) continue;
            facing += glm::dot(sample.normal, toCamera);
            lit += std::max(0.0, glm::dot(sample.normal, scene.lights[0].toLightWorld));
        }
    // The margin is 7 %; positions are rounded by up to a quarter of a pixel, and curves bulge between the
    // samples.
    EXPECT_GT(std::min(seen.low.x, seen.low.y), 0.065);
    EXPECT_LT(std::max(seen.high.x, seen.high.y), 0.935);
    // The camera is as near as possible, so both margins are reached along one axis.
    const double slackX = std::max(seen.low.x - 0.07, 0.93 - seen.high.x),
                 slackY = std::max(seen.low.y - 0.07, 0.93 - seen.high.y);
    EXPECT_LT(std::min(slackX, slackY), 0.01);
    EXPECT_GT(facing, 0);
    EXPECT_GT(lit, 0.2 * facing);
    EXPECT_EQ(scene.objects[0].relief->tile, glm::round(scene.objects[0].relief->tile));
    EXPECT_GT(scene.objects[0].relief->depth, 0);
}

TEST_F(Drafts, OpenSurface_IsSeenFromItsFront) {
    for (const auto& [name, mesh] : shapes()) {
        SCOPED_TRACE(name);
        const Vec3 camera = draftScene(mesh, halfDeep(), {}).camera.positionWorld;
        if (name == std::string("plane") || name == std::string("torus")) {
            EXPECT_GT(camera.y, 0);
        }
        if (name == std::string("plane_upside_down")) {
            EXPECT_LT(camera.y, 0);
        }
        if (name == std::string("plane_turned_away")) {
            EXPECT_LT(camera.z, -1);
        }
    }
}

TEST_F(Drafts, TallMesh_GetsTallImage) {
    const Camera column = draftScene(makeCylinder(0.5, 4, 8, 4), halfDeep(), {}).camera;
    EXPECT_EQ(Vec2i(column.width, column.height), Vec2i(600, 800));
    const Camera torus = draftScene(makeTorus(1, 0.4, 16, 8), halfDeep(), {}).camera;
    EXPECT_EQ(Vec2i(torus.width, torus.height), Vec2i(800, 600));
}

// A plane of 2 x 2 with uvs over the unit square: a unit of u is 2. Its diagonal is 2.83, and a third of it,
// 0.943, is the side of a square map, which fits 2.12 times into 2. A map of 256 x 64 texels is twice as wide
// and half as high: 1.06 and 4.24.
TEST_F(Drafts, Tile_MakesTexelsSquare) {
    const ControlMesh plane = makePlane(2, 2, 1, 1);
    EXPECT_EQ(draftScene(plane, halfDeep(), {}).tile, Vec2(2, 2));
    EXPECT_EQ(draftScene(plane, halfDeep(256, 64), {}).tile, Vec2(1, 4));
    EXPECT_EQ(draftScene(plane, halfDeep(256, 64, Wrap::Clamp), {}).tile, Vec2(1, 4));
    EXPECT_EQ(draftScene(plane, halfDeep(16, 64, Wrap::Clamp), {}).tile, Vec2(1, 1));
    // A map with more texels than the image has pixels isn't repeated.
    EXPECT_EQ(draftScene(plane, halfDeep(2048, 2048), {}).tile, Vec2(1, 1));
    ControlMesh repeating = plane;
    for (Vec2& uv : repeating.uvs)
        uv *= 4.0;
    EXPECT_EQ(draftScene(repeating, halfDeep(), {}).tile, Vec2(1, 1)); // the author's repetition is kept
}

TEST_F(Drafts, Depth_IsBelowTightRadius) {
    // 4 % of half the diagonal of a cube of 2: 0.04 * 1.732 = 0.069, far less than half its radius of
    // curvature.
    EXPECT_EQ(draftScene(makeSphere(1, 4), halfDeep(), {}).depth, 0.069);
    // A thin ring: 4 % would be 0.059, half of its tube's radius is 0.025 (with 12 segments, the radius of
    // curvature varies between 0.047 and 0.05).
    EXPECT_NEAR(draftScene(makeTorus(1, 0.05, 64, 12), halfDeep(), {}).depth, 0.024, 0.0011);
}

TEST_F(Drafts, Scheme_FollowsFaces) {
    ControlMesh quads = makePlane(2, 2, 2, 2), triangles = makePlane(2, 2, 1, 1);
    triangles.faceSizes = {3, 3};
    triangles.faceVertices = {triangles.faceVertices[0], triangles.faceVertices[1],
                              triangles.faceVertices[2], triangles.faceVertices[0],
                              triangles.faceVertices[2], triangles.faceVertices[3]};
    triangles.faceUvs = {triangles.faceUvs[0], triangles.faceUvs[1], triangles.faceUvs[2],
                         triangles.faceUvs[0], triangles.faceUvs[2], triangles.faceUvs[3]};
    EXPECT_EQ(draftScene(quads, halfDeep(), {}).scheme, Scheme::CatmullClark);
    EXPECT_EQ(draftScene(triangles, halfDeep(), {}).scheme, Scheme::Loop);
    EXPECT_EQ(draftScene(makePlane(2, 2, 142, 142), halfDeep(), {}).scheme, Scheme::None); // 20164 faces
    EXPECT_EQ(draftScene(quads, halfDeep(), withScheme(Scheme::None)).scheme, Scheme::None);
    EXPECT_THROW(draftScene(quads, halfDeep(), withScheme(Scheme::Loop)), InputError);
}

TEST_F(Drafts, ProxyRate_GivesAboutFiveHundredPolygons) {
    EXPECT_EQ(draftScene(makeBox({1, 1, 1}, 1), halfDeep(), {}).proxyRate, 10); // 6 * 10 * 10
    EXPECT_EQ(draftScene(makeTorus(1, 0.4, 16, 8), halfDeep(), {}).proxyRate, 2);
    EXPECT_EQ(draftScene(makePlane(2, 2, 1, 1), halfDeep(), {}).proxyRate, 1); // flat
}

TEST_F(Drafts, LooseFaces_AreMerged) {
    ControlMesh loose = makeBox({1, 1, 1}, 1);
    const ControlMesh box = loose;
    loose.points.clear();
    for (size_t corner = 0; corner < box.faceVertices.size(); ++corner) {
        loose.points.push_back(box.pointAt(corner));
        loose.faceVertices[corner] = static_cast<int>(corner);
    }
    EXPECT_FALSE(draftScene(box, halfDeep(), {}).merge);
    EXPECT_TRUE(draftScene(loose, halfDeep(), {}).merge);
    const Scene scene = draftAndRead(loose);
    EXPECT_EQ(scene.objects[0].mesh.points.size(), 8u);
    for (const std::string& warning : scene.warnings)
        EXPECT_THAT(warning, testing::Not(HasSubstr("boundary edges")));
}

TEST_F(Drafts, GivenOptions_OverrideDraft) {
    const Scene scene = draftAndRead(makeTorus(1, 0.4, 16, 8),
                                     {.scheme = Scheme::None, .depth = 0.123, .tile = Vec2(-2.5, 0.25)});
    EXPECT_EQ(scene.objects[0].scheme, Scheme::None);
    EXPECT_EQ(scene.objects[0].relief->depth, 0.123);
    EXPECT_EQ(scene.objects[0].relief->tile, Vec2(-2.5, 0.25));
}

TEST_F(Drafts, DegenerateMesh_IsRefused) {
    const auto refused = [](const ControlMesh& mesh, const DraftWishes& wishes = {}) {
        return inputErrorOf([&] { draftScene(mesh, halfDeep(), wishes); });
    };
    ControlMesh plane = makePlane(2, 2, 1, 1);
    EXPECT_THAT(refused(moved(plane, [](const Vec3& p) { return p * 1e-10; })), HasSubstr("scale it"));
    EXPECT_THAT(refused(moved(plane, [](const Vec3& p) { return p * 1e8; })), HasSubstr("scale it"));
    plane.uvs.assign(plane.uvs.size(), Vec2(0.5));
    EXPECT_THAT(refused(plane), HasSubstr("no area"));
    EXPECT_EQ(draftScene(plane, halfDeep(), withTile(Vec2(3))).tile, Vec2(3));
    plane.faceUvs.clear();
    EXPECT_THAT(refused(plane, withTile(Vec2(3))), HasSubstr("has no uvs"));
}

TEST_F(Drafts, OddFileNames_SurviveToml) {
    const HeightMap map = halfDeep();
    const SceneDraft draft = draftScene(makePlane(2, 2, 1, 1), map, {});
    for (const std::string name :
         {"a \"quoted\" one", "back\\slash", "two\nlines", "#]=[", "tab\tdel\x7f bell\a",
          "caf\xc3\xa9 \xf0\x9f\x90\x84", "'''", "", "<script>"}) {
        SCOPED_TRACE(name);
        writeFile(folder_ / (name + ".obj"), kQuad);
        const Scene scene = read(sceneText(draft, name + ".obj", "maps/stone.png", map, true));
        EXPECT_EQ(scene.objects[0].mesh.name, (folder_ / (name + ".obj")).string());
    }
    for (const std::string name : {"\xff.obj", "cut \xc3", "\xed\xa0\x80"})
        EXPECT_THAT(inputErrorOf([&] { sceneText(draft, name, "m.png", map, true); }), HasSubstr("UTF-8"));
}

} // namespace
} // namespace plumbline
