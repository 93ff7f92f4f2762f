// Checks that the recomputed hit lies on the expected plane, also if the given cell is a neighbor.
#include "reference/trace/resolve_hit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline {
namespace {

/// One grid of 5 x 4 vertices over x = column, y = row, z = column / 2 - row / 4: every micro-triangle lies
/// in one plane.
MicroMesh tiltedGrid() {
    MicroMesh mesh;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 5; ++column)
            mesh.positionsWorld.push_back(Vec3f(column, row, 0.5f * column - 0.25f * row));
    mesh.lattices = {{64, 64, {64, 64, 64, 64}, false}};
    mesh.grids.push_back({0, 0, 5, 4, 32, 16, 0, false});
    return mesh;
}

TEST(ResolveHit, Hit_HasLatticePlaceAndDistance) {
    const MicroMesh mesh = tiltedGrid();
    for (const double x : {0.1, 0.9, 1.25, 3.99})
        for (const double y : {0.05, 1.5, 2.97}) {
            const Ray ray{{x, y, 10}, {0, 0, -1}};
            const ResolvedHit hit = resolveHit(mesh, mesh.grids[0], float(x / 4), float(y / 3), 0, ray);
            EXPECT_NEAR(hit.distance, 10 - (0.5 * x - 0.25 * y), 1e-14);
            EXPECT_NEAR(64 * hit.uv.x, 32 + x, 1e-14);
            EXPECT_NEAR(64 * hit.uv.y, 16 + y, 1e-14);
            EXPECT_LT(glm::length(hit.facetNormal - glm::normalize(Vec3(-0.5, 0.25, 1))), 1e-15);
        }
}

TEST(ResolveHit, NeighborCell_IsCorrected) {
    const MicroMesh mesh = tiltedGrid();
    const Ray ray{{2.0000001, 1.4, 10},
                  {0, 0, -1}}; // in cell (2, 1), but given as (1, 1), as may happen for float u at a border
    const ResolvedHit hit = resolveHit(mesh, mesh.grids[0], 1.9999f / 4, 1.4f / 3, 9, ray);
    EXPECT_NEAR(64 * hit.uv.x, 34.0000001, 1e-12);
    EXPECT_NEAR(64 * hit.uv.y, 17.4, 1e-12);
}

TEST(ResolveHit, TwoSheets_KeepsEmbreesHit) {
    // A grid folded back over itself: columns 0 1 2 lie at x = 0, 1, 0.2 and z = 0, 0, 1. A ray down at x =
    // 0.5 hits the upper sheet (cell 1) first. Embree returns the border between both; its distance
    // determines the sheet.
    MicroMesh mesh;
    for (const float y : {0.0f, 1.0f})
        for (const Vec2f& xz : {Vec2f(0, 0), Vec2f(1, 0), Vec2f(0.2f, 1)})
            mesh.positionsWorld.push_back({xz.x, y, xz.y});
    mesh.lattices = {{2, 1, {2, 1, 2, 1}, false}};
    mesh.grids.push_back({0, 0, 3, 2, 0, 0, 0, false});
    const Ray ray{{0.5, 0.25, 5}, {0, 0, -1}};
    const double upperZ = (1 - 0.5) / 0.8;
    // The given (u, v) is in the lower triangle's far half, which the ray misses.
    const ResolvedHit upper = resolveHit(mesh, mesh.grids[0], 0.49f, 0.9f, float(5 - upperZ), ray);
    EXPECT_NEAR(upper.distance, 5 - upperZ, 1e-7); // 0.2f isn't 0.2
    const ResolvedHit lower = resolveHit(mesh, mesh.grids[0], 0.49f, 0.9f, 5, ray);
    EXPECT_NEAR(lower.distance, 5, 1e-14);
}

TEST(ResolveHit, RoundingMiss_IsPreferredToFarHit) {
    // A sheet at z = 0 from x = 0.2 to 1, folded back under itself down to z = -1 at x = 0. A ray down at x =
    // 0.2 - 1e-9 misses the upper sheet by less than Embree's rounding error, and Embree reports a hit; in
    // double it hits the lower one at z = -0.8.
    MicroMesh mesh;
    for (const float y : {0.0f, 1.0f})
        for (const Vec2f& xz : {Vec2f(0.2f, 0), Vec2f(1, 0), Vec2f(0, -1)})
            mesh.positionsWorld.push_back({xz.x, y, xz.y});
    mesh.lattices = {{2, 1, {2, 1, 2, 1}, false}};
    mesh.grids.push_back({0, 0, 3, 2, 0, 0, 0, false});
    const Ray ray{{double(0.2f) - 1e-9, 0.25, 5}, {0, 0, -1}};
    const ResolvedHit hit = resolveHit(mesh, mesh.grids[0], 0, 0.25f, 5, ray);
    EXPECT_EQ(hit.distance, 5);
    EXPECT_EQ(hit.uv.x, 0);
    EXPECT_EQ(hit.facetNormal.z, 1);
}

TEST(ResolveHit, GrazedEdge_StaysOnMesh) {
    const MicroMesh mesh = tiltedGrid();
    const Ray ray{{4 + 1e-9, 2, 10}, {0, 0, -1}}; // just past the last column
    const ResolvedHit hit = resolveHit(mesh, mesh.grids[0], 1, 2.0f / 3, 9, ray);
    EXPECT_EQ(64 * hit.uv.x, 36);
    EXPECT_NEAR(64 * hit.uv.y, 18, 1e-8);
    EXPECT_NEAR(hit.distance, 10 - 1.5, 1e-8);
}

} // namespace
} // namespace plumbline
