// Faces with different rates: there are no cracks between them, and the error bounds are valid.
#include "reference/tessellate/tessellate.h"
#include "scenes/mesh/obj_file.h"
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/scene_file/scene_file.h"
#include "scenes/scene_file/scene_library.h"
#include "scenes/surface/displaced_surface.h"
#include "tests/reference/tessellate/micro_mesh_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

namespace plumbline {
namespace {

/// Random powers of two from 1 to 16, different along u and v if the face allows it.
Rates randomRates(const BaseSurface& surface, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Vec2i> faces(static_cast<size_t>(surface.mesh().faceCount()));
    for (Vec2i& rate : faces)
        rate = Vec2i(1 << (random() % 5), 1 << (random() % 5));
    for (const BaseSurface::Patch& patch : surface.patches()) {
        Vec2i& rate = faces[static_cast<size_t>(patch.face)];
        if (patch.triangular || patch.subFace) rate = Vec2i(std::max(rate.x, 2));
    }
    return ratesFromFaces(surface, faces);
}

/// Segments of boundary edges, which are the only open edges of a mesh without cracks.
int rimSegments(const BaseSurface& surface, const Rates& rates) {
    std::vector<int> uses(static_cast<size_t>(surface.edgeCount()), 0);
    for (const BaseSurface::Patch& patch : surface.patches())
        if (patch.corner == 0)
            for (const int edge : surface.faceEdges(patch.face))
                ++uses[static_cast<size_t>(edge)];
    int segments = 0;
    for (size_t edge = 0; edge < uses.size(); ++edge)
        if (uses[edge] == 1) segments += rates.edges[edge];
    return segments;
}

void expectNoCracks(const SceneObject& object, unsigned seed) {
    const std::unique_ptr<BaseSurface> surface = makeBaseSurface(object);
    const Rates rates = randomRates(*surface, seed);
    const MicroMesh mesh = tessellate(*surface, object.relief ? &*object.relief : nullptr, rates, false);
    // An open edge counts twice, once in each direction.
    EXPECT_EQ(unmatchedEdges(trianglesWithArea(mesh)), 2 * rimSegments(*surface, rates))
        << object.name << ", seed " << seed;
}

TEST(Rates, LibraryScenes_HaveNoCracks) {
    for (const LibraryScene& entry : libraryScenes())
        for (const SceneObject& object : readScene(entry.file).objects)
            for (const unsigned seed : {1u, 2u}) {
                SCOPED_TRACE(entry.name);
                expectNoCracks(object, seed);
            }
}

TEST(Rates, Spot_HasNoCracks) {
    const std::filesystem::path file = std::filesystem::path(PLUMBLINE_SHARED_DATA) / "spot_control_mesh.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
    SceneObject object;
    object.name = "spot";
    object.mesh = readObj(file);
    std::vector<float> depths;
    for (int k = 0; k < 64; ++k)
        depths.push_back(float((k * 37) % 64) / 63.0f);
    object.relief = Relief{std::make_shared<HeightMap>("noise", 8, 8, depths), 0.05, 0.0, Vec2(3), Vec2(0)};
    for (const unsigned seed : {1u, 2u, 3u})
        expectNoCracks(object, seed);
}

/// The largest distance between the surface and the micro-triangles at equal (u, v), over random points of
/// random cells, as a fraction of the grid's error bound. Excludes torn cells.
double worstShareOfBound(const SceneObject& object, const Rates& rates, const BaseSurface& surface,
                         unsigned seed) {
    const Relief* relief = object.relief ? &*object.relief : nullptr;
    const MicroMesh mesh = tessellate(surface, relief, rates, false);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    BaseSurface::Evaluator evaluator(surface);
    double worst = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const MicroGrid& grid = mesh.grids[random() % mesh.grids.size()];
        const PatchLattice& lattice = mesh.lattices[grid.patch];
        const int column = static_cast<int>(random() % (grid.columns - 1u)),
                  row = static_cast<int>(random() % (grid.rows - 1u));
        const bool upper = random() % 2;
        double beta = unit(random), gamma = unit(random);
        if (beta + gamma > 1) beta = 1 - beta, gamma = 1 - gamma;
        const auto vertex = [&](int c, int r) {
            return Vec3(mesh.positionsWorld[grid.firstVertex +
                                            static_cast<size_t>((row + r) * grid.columns + column + c)]);
        };
        const auto uvAt = [&](int c, int r) {
            return latticeUv(lattice, grid.column0 + column + c, grid.row0 + row + r);
        };
        const Vec3 a = upper ? vertex(1, 1) : vertex(0, 0), b = upper ? vertex(0, 1) : vertex(1, 0),
                   c = upper ? vertex(1, 0) : vertex(0, 1);
        const Vec2 uvA = upper ? uvAt(1, 1) : uvAt(0, 0), uvB = upper ? uvAt(0, 1) : uvAt(1, 0),
                   uvC = upper ? uvAt(1, 0) : uvAt(0, 1);
        if (a == b || b == c || c == a) continue;
        const Vec2 uv = uvA + beta * (uvB - uvA) + gamma * (uvC - uvA);
        evaluator.setPatch(static_cast<int>(grid.patch));
        const auto surfaceAt = [&](const Vec2& at) {
            return displace(evaluator.sample(at.x, at.y), relief).position;
        };
        // Where faces displace a vertex differently the surface is torn, and the bound includes the wall that
        // closes it.
        const double torn = std::max({glm::length(surfaceAt(uvA) - a), glm::length(surfaceAt(uvB) - b),
                                      glm::length(surfaceAt(uvC) - c)});
        if (torn > 1e-5) continue; // floats of coordinates up to 8
        const Vec3 onSurface = surfaceAt(uv);
        const Vec3 onTriangle = a + beta * (b - a) + gamma * (c - a);
        worst = std::max(worst, glm::length(onSurface - onTriangle) / double(grid.errorWorld));
    }
    return worst;
}

TEST(Rates, LibraryScenes_StayWithinErrorBound) {
    for (const LibraryScene& entry : libraryScenes())
        for (const SceneObject& object : readScene(entry.file).objects) {
            const std::unique_ptr<BaseSurface> surface = makeBaseSurface(object);
            SCOPED_TRACE(entry.name + ", " + object.name);
            for (const int rate : {1, 4, 32})
                EXPECT_LE(worstShareOfBound(object, uniformRates(*surface, rate), *surface, 7), 1.0)
                    << "rate " << rate;
            EXPECT_LE(worstShareOfBound(object, randomRates(*surface, 8), *surface, 8), 1.0)
                << "random rates";
        }
}

// Along an axis k is constant, so its terms of the bound are 0. The other terms must be sufficient, also for
// bases steep relative to the axis.
TEST(Rates, AlongAxis_StaysWithinErrorBound) {
    std::vector<float> depths;
    for (int k = 0; k < 64; ++k)
        depths.push_back(float((k * 37) % 64) / 63.0f);
    for (const ControlMesh& mesh :
         {makeQuadric(-0.8, 0.3, 1, 2), makeSphere(1, 2), makeTorus(1, 0.4, 8, 6)}) {
        SceneObject object;
        object.name = mesh.name;
        object.mesh = mesh;
        object.rotateDegrees = {20, 30, 40};
        object.relief =
            Relief{std::make_shared<HeightMap>("noise", 8, 8, depths), 0.2, 0.05, Vec2(1.5), Vec2(0)};
        object.relief->axisWorld = object.axisWorld();
        const std::unique_ptr<BaseSurface> surface = makeBaseSurface(object);
        SCOPED_TRACE(object.name);
        for (const int rate : {1, 4, 32})
            EXPECT_LE(worstShareOfBound(object, uniformRates(*surface, rate), *surface, 7), 1.0)
                << "rate " << rate;
        EXPECT_LE(worstShareOfBound(object, randomRates(*surface, 8), *surface, 8), 1.0) << "random rates";
    }
}

} // namespace
} // namespace plumbline
