#include "scenes/mesh/merge_vertices.h"
#include "tests/scenes/mesh/mesh_checks.h"
#include "tests/scenes/mesh/test_meshes.h"

#include <gmock/gmock.h>
#include <random>

namespace plumbline {
namespace {

/// Each face with vertices of its own, moved by at most `noise` along each axis.
ControlMesh looseCube(double noise) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> between(-noise, noise);
    const ControlMesh cube = cubeMesh();
    ControlMesh mesh = cube;
    mesh.points.clear();
    for (size_t corner = 0; corner < cube.faceVertices.size(); ++corner) {
        mesh.points.push_back(cube.pointAt(corner) + Vec3(between(random), between(random), between(random)));
        mesh.faceVertices[corner] = static_cast<int>(corner);
        mesh.uvs.push_back(Vec2(double(corner), 0));
        mesh.faceUvs.push_back(static_cast<int>(corner));
    }
    return mesh;
}

TEST(EdgesOnEdges, OfLooseFaces_AreCounted) {
    EXPECT_EQ(countEdgesOnEdges(looseCube(0)), 24u);
    EXPECT_EQ(countEdgesOnEdges(looseCube(5e-7)), 24u); // as six digits round
    EXPECT_EQ(countEdgesOnEdges(looseCube(1e-3)), 0u);
    EXPECT_EQ(countEdgesOnEdges(cubeMesh()), 0u);
    EXPECT_EQ(countEdgesOnEdges(bumpyGrid(4)), 0u);
}

TEST(MergeVertices, LooseCube_IsClosed) {
    for (const double noise : {0.0, 5e-7}) {
        ControlMesh mesh = looseCube(noise);
        const std::vector<int> uvs = mesh.faceUvs;
        EXPECT_EQ(mergeVertices(mesh, samePlaceDistance(mesh)), 16u);
        checkControlMesh(mesh, Scheme::CatmullClark);
        EXPECT_EQ(mesh.points.size(), 8u);
        EXPECT_EQ(mesh.faceUvs, uvs); // stay those of the corners
        const Topology topology = topologyOf(mesh);
        EXPECT_TRUE(topology.consistent);
        EXPECT_EQ(topology.boundaryEdges, 0);
        EXPECT_EQ(topology.euler(), 2);
    }
}

TEST(MergeVertices, Distance_IsRespected) {
    ControlMesh mesh = looseCube(1e-3);
    EXPECT_EQ(mergeVertices(mesh, 1e-5), 0u);
    EXPECT_EQ(mergeVertices(mesh, 4e-3), 16u); // sqrt(3) times 2e-3
    mesh = looseCube(0);
    EXPECT_EQ(mergeVertices(mesh, 0), 16u); // equal places
}

TEST(MergeVertices, DistanceLargerThanEdges_DropsFaces) {
    ControlMesh mesh = cubeMesh();
    mesh.points.push_back({1, 1, 1.01});
    mesh.points.push_back({1, 0.99, 1.01});
    addFace(mesh, {7, 8, 9});
    addFace(mesh, {0, 7, 8, 1});
    EXPECT_EQ(mergeVertices(mesh, 0.1), 2u);
    EXPECT_EQ(mesh.faceCount(), 7);
    EXPECT_EQ(mesh.faceSizes.back(), 3); // 0 7 7 1
    EXPECT_THAT(mesh.warnings,
                testing::ElementsAre(testing::HasSubstr("once counts"), testing::HasSubstr("left out")));
}

TEST(MergeVertices, Tags_FollowTheirVertices) {
    ControlMesh mesh = looseCube(0);
    mesh.tags.creases = {{4, 5, 3},
                         {0, 4, 2}}; // corners 4 and 5 are the second face's, at the cube's 4 and 5
    mesh.tags.corners = {{5, 4}};
    const Vec3 from = mesh.points[4], to = mesh.points[5];
    mergeVertices(mesh, 1e-6);
    EXPECT_EQ(item(mesh.points, mesh.tags.creases[0].from), from);
    EXPECT_EQ(item(mesh.points, mesh.tags.creases[0].to), to);
    EXPECT_EQ(item(mesh.points, mesh.tags.corners[0].vertex), to);
}

} // namespace
} // namespace plumbline
