#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/displaced_surface.h"
#include "scenes/surface/seams.h"
#include "tests/scenes/mesh/test_meshes.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// d increases from 0 to 1 over the map's width and returns in its last texel; all rows are equal.
std::shared_ptr<const HeightMap> rampMap(Wrap wrap = Wrap::Repeat, int size = 16) {
    std::vector<float> depths;
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i)
            depths.push_back(float(i) / float(size - 1));
    return std::make_shared<HeightMap>("ramp", size, size, depths, wrap, wrap);
}

Relief rampRelief() {
    Relief relief;
    relief.map = rampMap();
    relief.depth = 0.1;
    return relief;
}

TornEdges tornOf(const ControlMesh& mesh, Scheme scheme, const Relief& relief) {
    return countTornEdges(BaseSurface(mesh, scheme), relief);
}

/// Two adjacent squares along x with separate uvs: the left one's u is in [0, 0.5], the right one's starts at
/// 0.5 + jump.
ControlMesh twoSquares(const Vec2& jump) {
    ControlMesh mesh = bumpyGrid(2);
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, -1}, {1, 0, -1}, {2, 0, -1}};
    mesh.faceSizes = {4, 4};
    mesh.faceVertices = {0, 1, 4, 3, 1, 2, 5, 4};
    mesh.uvs = {{0, 0},
                {0.5, 0},
                {0.5, 1},
                {0, 1},
                Vec2(0.5, 0) + jump,
                Vec2(1, 0) + jump,
                Vec2(1, 1) + jump,
                Vec2(0.5, 1) + jump};
    mesh.faceUvs = {0, 1, 2, 3, 4, 5, 6, 7};
    return mesh;
}

TEST(Seams, JumpByWholeTiles_TearsNothing) {
    const Relief relief = rampRelief();
    EXPECT_EQ(tornOf(twoSquares({0, 0}), Scheme::None, relief).byMap, 0);
    EXPECT_EQ(tornOf(twoSquares({3, -2}), Scheme::None, relief).byMap, 0);
    EXPECT_EQ(tornOf(twoSquares({1e-7, 0}), Scheme::None, relief).byMap, 0); // single precision
    EXPECT_EQ(tornOf(twoSquares({0.25, 0}), Scheme::None, relief).byMap, 1);
    EXPECT_EQ(tornOf(twoSquares({0, 0.25}), Scheme::None, relief).byMap,
              0);          // all rows of the map are equal
    Relief tiled = relief; // 0.25 * 4 is an integer, 0.25 * 3 isn't
    tiled.tile = {4, 1};
    EXPECT_EQ(tornOf(twoSquares({0.25, 0}), Scheme::None, tiled).byMap, 0);
    tiled.tile = {-3, 1};
    EXPECT_EQ(tornOf(twoSquares({0.25, 0}), Scheme::None, tiled).byMap, 1);
    Relief clamped = relief; // a clamped map isn't periodic: depths differ at u = 0.5 and 3.5
    clamped.map = rampMap(Wrap::Clamp);
    EXPECT_EQ(tornOf(twoSquares({3, 0}), Scheme::None, clamped).byMap, 1);
    EXPECT_EQ(tornOf(twoSquares({0, 3}), Scheme::None, clamped).byMap, 0);
}

TEST(Seams, DifferenceBelowOneCode_TearsNothing) {
    // The ramp rises by 1/15 in a sixteenth of the map: 16/15 per unit of u. 1/256 of the depth is du =
    // 0.00366.
    const Relief relief = rampRelief();
    EXPECT_EQ(tornOf(twoSquares({0.0035, 0}), Scheme::None, relief).byMap, 0);
    EXPECT_EQ(tornOf(twoSquares({0.0038, 0}), Scheme::None, relief).byMap, 1);
    Relief flat = relief;
    flat.depth = 0;
    EXPECT_EQ(tornOf(twoSquares({0.25, 0}), Scheme::None, flat).byMap, 0);
}

TEST(Seams, OneDifferentTexel_IsFound) {
    // 512 rows, all 0 except one at half the map's height in its right half; the edge is along t. The sides
    // at u = 0.25 and 0.75 differ over two of 512 texels, which 32 sample points would miss.
    constexpr int kSize = 512;
    std::vector<float> depths(size_t(kSize) * kSize, 0.0f);
    for (int i = kSize / 2; i < kSize; ++i)
        depths[size_t(301) * kSize + size_t(i)] = 1;
    Relief relief = rampRelief();
    relief.map = std::make_shared<HeightMap>("line", kSize, kSize, depths);
    relief.uvOffset = {-0.25, 0};
    EXPECT_EQ(tornOf(twoSquares({0.5, 0}), Scheme::None, relief).byMap, 1);
    EXPECT_EQ(tornOf(twoSquares({0.125, 0}), Scheme::None, relief).byMap, 0);
}

TEST(Seams, ReversedUvs_AreComparedAtSamePlace) {
    // The right square's v runs downwards: if the map varies with t, the sides only agree at the edge's
    // midpoint.
    ControlMesh mesh = twoSquares({0, 0});
    std::swap(mesh.uvs[4], mesh.uvs[7]);
    Relief relief = rampRelief();
    EXPECT_EQ(tornOf(mesh, Scheme::None, relief).byMap, 0); // all rows are equal
    std::vector<float> depths;
    for (int j = 0; j < 16; ++j)
        depths.push_back(float(j) / 15);
    relief.map = std::make_shared<HeightMap>("rows", 1, 16, depths);
    EXPECT_EQ(tornOf(mesh, Scheme::None, relief).byMap, 1);
}

TEST(Seams, BuiltInShapes_CloseAsDocumented) {
    Relief relief = rampRelief();
    relief.tile = {8, 3};
    const TornEdges torus = tornOf(makeTorus(1, 0.4, 16, 8), Scheme::CatmullClark, relief);
    EXPECT_EQ(torus.byMap, 0);
    EXPECT_EQ(torus.byNormals, 0);
    relief.tile = {7.25, 3}; // a quarter of a tile remains where u wraps around: 8 edges around the tube
    EXPECT_EQ(tornOf(makeTorus(1, 0.4, 16, 8), Scheme::CatmullClark, relief).byMap, 8);
}

TEST(Seams, SharpEdges_TearByNormals) {
    Relief relief;
    relief.map = std::make_shared<HeightMap>(HeightMap::constant("constant", 0.5f));
    relief.depth = 0.1;
    const ControlMesh box = makeBox(Vec3(2), 1); // with normals of its faces
    TornEdges torn = tornOf(box, Scheme::None, relief);
    EXPECT_EQ(torn.byMap, 0);
    EXPECT_EQ(torn.byNormals, 12);
    relief.offset = 0.05; // offset - depth * d = 0: no displacement
    EXPECT_EQ(tornOf(box, Scheme::None, relief).byNormals, 0);
    relief.offset = 0;
    relief.axisWorld = Vec3(0, 0, 1);
    EXPECT_EQ(tornOf(box, Scheme::None, relief).byNormals, 0); // one direction for all faces
    relief.axisWorld.reset();
    EXPECT_EQ(tornOf(box, Scheme::CatmullClark, relief).byNormals, 0); // smooth
    ControlMesh creased = box;
    for (const int to : {1, 2}) // edges of the first face, by its corners
        creased.tags.creases.push_back({box.faceVertices[size_t(to)], box.faceVertices[size_t(to) + 1], 3.0});
    EXPECT_EQ(tornOf(creased, Scheme::CatmullClark, relief).byNormals, 0); // semi-sharp: smooth in the limit
    for (SubdivisionTags::Crease& crease : creased.tags.creases)
        crease.sharpness = kInfinitelySharp;
    EXPECT_EQ(tornOf(creased, Scheme::CatmullClark, relief).byNormals, 2);
}

TEST(Seams, NgonAndTriangleEdges_AreComparedInFull) {
    // A pentagonal prism without normals has one angle-weighted normal per vertex. Face normals tear all 15
    // edges.
    ControlMesh mesh = prismMesh(5);
    mesh.uvs = {Vec2(0.3, 0.4)};
    mesh.faceUvs.assign(mesh.faceVertices.size(), 0);
    Relief relief = rampRelief();
    EXPECT_EQ(tornOf(mesh, Scheme::None, relief).byNormals, 0);
    for (const auto& [from, to] : {std::pair{5, 6}, {6, 7}, {7, 8}, {8, 9}, {9, 5}})
        mesh.tags.creases.push_back({from, to, kInfinitelySharp});
    EXPECT_EQ(tornOf(mesh, Scheme::CatmullClark, relief).byNormals, 5);
    ControlMesh triangles = triangulated(mesh);
    triangles.tags = mesh.tags;
    triangles.uvs = mesh.uvs;
    triangles.faceUvs.assign(triangles.faceVertices.size(), 0);
    EXPECT_EQ(tornOf(triangles, Scheme::Loop, relief).byNormals, 5);
}

TEST(Seams, Warning_NamesTreatment) {
    SceneObject object;
    object.name = "squares";
    object.mesh = twoSquares({0.25, 0});
    object.scheme = Scheme::None;
    EXPECT_THAT(surfaceWarnings(object, *makeBaseSurface(object)), IsEmpty()); // no relief
    object.relief = rampRelief();
    EXPECT_THAT(surfaceWarnings(object, *makeBaseSurface(object)),
                ElementsAre("squares: 1 edge where texture coordinates tear the surface; welded at the mean "
                            "displacement (seams = \"weld\")"));
    object.relief->seams = Seams::Open;
    object.mesh = makeBox(Vec3(2), 1);
    object.relief->map = std::make_shared<HeightMap>(HeightMap::constant("constant", 0.5f));
    EXPECT_THAT(
        surfaceWarnings(object, *makeBaseSurface(object)),
        ElementsAre("squares: 12 edges where normals tear the surface; left open (seams = \"open\")"));
}

} // namespace
} // namespace plumbline
