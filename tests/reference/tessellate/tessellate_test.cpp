// Properties of micro-meshes: closed, complete, welded, and on the true surface.
#include "reference/tessellate/lattice.h"
#include "reference/tessellate/tessellate.h"
#include "scenes/surface/displaced_surface.h"
#include "tests/reference/tessellate/micro_mesh_checks.h"
#include "tests/reference/test_scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace plumbline {
namespace {

ControlMesh octahedron() {
    ControlMesh mesh;
    mesh.name = "octahedron";
    mesh.points = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.faceSizes.assign(8, 3);
    for (int k = 0; k < 4; ++k) {
        for (const int v : {k, (k + 1) % 4, 4})
            mesh.faceVertices.push_back(v);
        for (const int v : {(k + 1) % 4, k, 5})
            mesh.faceVertices.push_back(v);
    }
    for (int k = 0; k < 24; ++k) { // torn at every edge
        mesh.uvs.push_back(Vec2(0.37 * k, 0.61 * ((k * 7) % 24)));
        mesh.faceUvs.push_back(k);
    }
    return mesh;
}

Relief noiseRelief(double depth) {
    std::vector<float> depths;
    for (int k = 0; k < 64; ++k)
        depths.push_back(float((k * 37) % 64) / 63.0f);
    return {std::make_shared<HeightMap>("noise", 8, 8, depths), depth, 0.0, Vec2(1), Vec2(0)};
}

TEST(Tessellate, ClosedShells_StayClosed) {
    const Relief relief = noiseRelief(0.05);
    for (const Scheme scheme : {Scheme::Loop, Scheme::CatmullClark, Scheme::None}) {
        const BaseSurface surface(octahedron(), scheme);
        for (const int rate : {1, 2, 4, 16, 32, 64}) {
            if (scheme == Scheme::CatmullClark && rate < 2) continue; // triangles are divided into sub-faces
            SCOPED_TRACE(testing::Message() << "scheme " << int(scheme) << ", rate " << rate);
            const MicroMesh mesh = tessellate(surface, &relief, uniformRates(surface, rate), false);
            const std::vector<Triangle> triangles = trianglesWithArea(mesh);
            // Catmull-Clark: 3 sub-faces with 2 (rate/2)^2 on each of 8 triangles; otherwise rate^2.
            const int expected =
                scheme == Scheme::CatmullClark ? 8 * 3 * 2 * (rate / 2) * (rate / 2) : 8 * rate * rate;
            EXPECT_EQ(triangles.size(), size_t(expected));
            const MicroMeshSize size = microMeshSize(surface, uniformRates(surface, rate));
            EXPECT_EQ(size.microTriangles, size_t(expected));
            EXPECT_EQ(size.vertices, mesh.positionsWorld.size());
            EXPECT_EQ(size.grids, mesh.grids.size());
            EXPECT_EQ(unmatchedEdges(triangles), 0);
            EXPECT_GT(signedVolume(triangles), 0);
        }
    }
    // Without relief the polygons' micro-triangles enclose the octahedron: 8 pyramids of 1/6.
    const BaseSurface polygons(octahedron(), Scheme::None);
    EXPECT_NEAR(
        signedVolume(trianglesWithArea(tessellate(polygons, nullptr, uniformRates(polygons, 32), false))),
        8.0 / 6,
        1e-5); // float
}

TEST(Tessellate, InteriorVertices_LieOnSurface) {
    const Relief relief = noiseRelief(0.05);
    for (const Scheme scheme : {Scheme::Loop, Scheme::CatmullClark}) {
        const BaseSurface surface(octahedron(), scheme);
        const MicroMesh mesh = tessellate(surface, &relief, uniformRates(surface, 32), true);
        BaseSurface::Evaluator evaluator(surface);
        int checked = 0;
        for (const MicroGrid& grid : mesh.grids) {
            const BaseSurface::Patch& patch = surface.patches()[grid.patch];
            const uint32_t cells = mesh.lattices[grid.patch].columns;
            evaluator.setPatch(static_cast<int>(grid.patch));
            for (uint32_t row = grid.row0; row < grid.row0 + grid.rows; ++row)
                for (uint32_t column = grid.column0; column < grid.column0 + grid.columns; ++column) {
                    const bool inside =
                        row > 0 && column > 0 &&
                        (patch.triangular ? row + column < cells : row < cells && column < cells);
                    if (!inside) continue;
                    const DisplacedSample expected =
                        displace(evaluator.sample(double(column) / cells, double(row) / cells), &relief);
                    const size_t index =
                        grid.firstVertex + (row - grid.row0) * grid.columns + (column - grid.column0);
                    ASSERT_EQ(mesh.positionsWorld[index],
                              Vec3f(expected.position)); // the same sums in the same order
                    ASSERT_EQ(mesh.normalsWorld[index], Vec3f(expected.normal));
                    ASSERT_EQ(mesh.st[index], Vec2f(expected.st));
                    ++checked;
                }
        }
        EXPECT_GE(checked,
                  8 * 31 * 30 / 2); // Loop: the lattice points inside 8 triangles; borders of grids twice
    }
}

/// Two unit squares side by side in the plane z = 0, sharing the edge x = 0. Along it s = 1/4 and t = y on
/// the left, s = 3/4 and t = 1 - y on the right: the two sample different texels, in opposite directions.
ControlMesh tornPair() {
    ControlMesh mesh;
    mesh.name = "pair";
    mesh.points = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {1, 0, 0}, {1, 1, 0}};
    mesh.faceSizes = {4, 4};
    mesh.faceVertices = {0, 1, 2, 3, 1, 4, 5, 2};
    mesh.uvs = {{0.25, 0}, {0.25, 1}, {0.75, 0}, {0.75, 1}};
    mesh.faceUvs = {0, 0, 1, 1, 3, 3, 2, 2};
    return mesh;
}

// The left column of the map is d = t, so the left face has the depth y; the right face has the right
// column's depth at 1 - y. Welded, the edge is at the mean of both.
TEST(Tessellate, WeldedTears_MeetAtMean) {
    const BaseSurface surface(tornPair(), Scheme::None);
    // Texel centers in t: 1/8, 3/8, 5/8, 7/8.
    const std::vector<float> depths{0.125f, 1, 0.375f, 0.5f, 0.625f, 0.5f, 0.875f, 0};
    const Relief relief{std::make_shared<HeightMap>("halves", 2, 4, depths, Wrap::Clamp, Wrap::Clamp), 1, 0.0,
                        Vec2(1), Vec2(0)};
    const MicroMesh micro = tessellate(surface, &relief, uniformRates(surface, 8), false);
    int checked = 0;
    for (const Vec3f& p : micro.positionsWorld) {
        if (p.x != 0 || p.y < 0.125f || p.y > 0.875f) continue;
        const double left = p.y, right = relief.map->depth(Vec2(0.75, 1 - p.y));
        EXPECT_NEAR(p.z, -(left + right) / 2, 1e-7) << p.y;
        ++checked;
    }
    EXPECT_EQ(checked, 2 * 7);
    EXPECT_EQ(unmatchedEdges(trianglesWithArea(micro)),
              2 * 6 * 8); // only the pair's boundary, in both directions
}

/// A sheet in the plane z = 0 torn along x = 0: a pentagon on the left, whose uvs are all in the map's left
/// texel, and two squares on the right, in the right one.
ControlMesh pentagonBesideSquares() {
    ControlMesh mesh;
    mesh.name = "sheet";
    mesh.points = {{-1, -1, 0}, {0, -1, 0}, {0, 0, 0}, {0, 1, 0},
                   {-1, 1, 0},  {1, -1, 0}, {1, 0, 0}, {1, 1, 0}};
    mesh.faceSizes = {5, 4, 4};
    mesh.faceVertices = {0, 1, 2, 3, 4, 1, 5, 6, 2, 2, 6, 7, 3};
    mesh.uvs = {{0.25, 0}, {0.75, 0}};
    mesh.faceUvs = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
    return mesh;
}

// Left of the seam d = 1, right of it 0: -0.4 and 0. The vertex in the seam's middle has one face on the left
// and two on the right, everything else on the seam one on either side.
TEST(Tessellate, WeldedSeam_IsAtMeanOfSidesNotOfFaces) {
    const BaseSurface surface(pentagonBesideSquares(), Scheme::None);
    const Relief relief{
        std::make_shared<HeightMap>("step", 2, 1, std::vector<float>{1, 0}, Wrap::Clamp, Wrap::Clamp), 0.4,
        0.0, Vec2(1), Vec2(0)};
    const MicroMesh micro = tessellate(surface, &relief, uniformRates(surface, 8), false);
    int checked = 0;
    for (const Vec3f& p : micro.positionsWorld) {
        if (p.x != 0) continue;
        EXPECT_NEAR(p.z, -0.2, 1e-7) << p.y;
        ++checked;
    }
    EXPECT_EQ(checked, 2 * 9 + (5 + 9 + 5)); // of two squares and three of the sub-faces of the pentagon
}

// A flat sheet with rounded corners. Of a corner's face, only the two sides on the boundary bow much; which
// of its patch's sides they are depends on the corner.
TEST(Tessellate, BowOfAnySide_IsInErrorBound) {
    ControlMesh mesh = squareMesh(2, 3);
    mesh.tags.boundaryCornersRound = true;
    const BaseSurface surface(mesh, Scheme::CatmullClark);
    for (const int rate : {1, 2, 4, 16}) {
        const MicroMesh micro = tessellate(surface, nullptr, uniformRates(surface, rate), false);
        ASSERT_EQ(micro.grids.size(), 9u);
        BaseSurface::Evaluator evaluator(surface);
        for (const MicroGrid& grid : micro.grids) {
            evaluator.setPatch(static_cast<int>(grid.patch));
            const auto at = [&](const Vec2& uv) { return evaluator.point(uv.x, uv.y).position; };
            double bow = 0;
            for (int i = 0; i < rate; ++i)
                for (const double side : {0.0, 1.0})
                    for (const bool alongU : {true, false}) {
                        const auto place = [&](double step) {
                            return alongU ? Vec2(step / rate, side) : Vec2(side, step / rate);
                        };
                        const Vec3 chord = 0.5 * (at(place(i)) + at(place(i + 1)));
                        bow = std::max(bow, glm::length(at(place(i + 0.5)) - chord));
                    }
            EXPECT_GE(grid.errorWorld, bow) << "rate " << rate << ", patch " << grid.patch;
        }
    }
}

// The normal of one vertex is reversed, so that directions jump in the middle of the square, along a curve
// that grids measured at a few of their cells may miss: the surface just beside it is 0.6 from the
// micro-triangles.
TEST(Tessellate, JumpOfDirection_IsInErrorBound) {
    ControlMesh mesh = squareMesh(2, 1);
    mesh.normals = {{0, 0, 1}, {0, 0, -1}};
    mesh.faceNormals = {1, 0, 0, 0};
    const BaseSurface surface(mesh, Scheme::None);
    const Relief relief{std::make_shared<HeightMap>(HeightMap::constant("top", 0)), 0.3, 0.3};
    for (const int rate : {8, 16, 64}) {
        const MicroMesh micro = tessellate(surface, &relief, uniformRates(surface, rate), false);
        int jumps = 0;
        for (const MicroGrid& grid : micro.grids) {
            float low = 1, high = -1;
            for (int row = 0; row < grid.rows; ++row)
                for (int column = 0; column < grid.columns; ++column) {
                    low = std::min(low, micro.positionsWorld[grid.vertex(column, row)].z);
                    high = std::max(high, micro.positionsWorld[grid.vertex(column, row)].z);
                }
            const bool jump = low < 0 && high > 0;
            jumps += jump;
            EXPECT_EQ(grid.errorWorld >= 0.6f, jump) << "rate " << rate << ", " << grid.errorWorld;
        }
        EXPECT_GT(jumps, 0);
    }
}

// With open seams, each face keeps its own displacement along the shared edge, so the edge exists twice, but
// only where the two differ. At y = 1/2 the depth is 1/2 on both sides.
TEST(Tessellate, OpenTears_Gape) {
    const BaseSurface surface(tornPair(), Scheme::None);
    const std::vector<float> depths{0.125f, 0.5f, 0.375f, 0.5f, 0.625f, 0.5f, 0.875f, 0.5f};
    Relief relief{std::make_shared<HeightMap>("halves", 2, 4, depths, Wrap::Clamp, Wrap::Clamp), 1, 0.0,
                  Vec2(1), Vec2(0)};
    relief.seams = Seams::Open;
    const MicroMesh micro = tessellate(surface, &relief, uniformRates(surface, 8), false);
    int checked = 0;
    for (const MicroGrid& grid : micro.grids)
        for (uint32_t i = grid.firstVertex; i < grid.firstVertex + uint32_t(grid.columns) * grid.rows; ++i) {
            const Vec3f& p = micro.positionsWorld[i];
            if (p.x != 0 || p.y < 0.125f || p.y > 0.875f) continue;
            EXPECT_NEAR(p.z, grid.patch == 0 ? -p.y : -0.5f, 1e-6) << "patch " << grid.patch << ", y " << p.y;
            ++checked;
        }
    EXPECT_EQ(checked, 2 * 7);
    // The boundary, and 8 segments on both sides of the shared edge.
    EXPECT_EQ(unmatchedEdges(trianglesWithArea(micro)), 2 * (6 * 8 + 2 * 8));
    relief.map = std::make_shared<HeightMap>(HeightMap::constant("same", 0.5f)); // both faces agree
    EXPECT_EQ(
        unmatchedEdges(trianglesWithArea(tessellate(surface, &relief, uniformRates(surface, 8), false))),
        2 * 6 * 8);
}

} // namespace
} // namespace plumbline
