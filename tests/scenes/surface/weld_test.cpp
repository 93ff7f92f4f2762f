#include "scenes/surface/proxy_mesh.h"
#include "scenes/surface/weld.h"
#include "tests/scenes/mesh/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace plumbline {
namespace {

const Vec3 kUp(0, 0, 1), kOut(1, 0, 0);

TEST(WeldedSides, GroupsThatAgree_CountOnce) {
    const auto sides =
        weldedSides({{kUp, 0}, {kOut, -0.5}, {kUp, -1}, {kOut, -0.5}, {kUp, -1}, {kUp, -1}}, 1);
    ASSERT_EQ(sides.size(), 3u);
    double heights = 0;
    for (const Displacement& side : sides)
        heights += side.height;
    EXPECT_DOUBLE_EQ(heights, -1.5);
}

TEST(WeldedSides, WithinOneCode_IsOneSide) {
    EXPECT_EQ(weldedSides({{kUp, 0}, {kUp, 0.9 / 256}, {kUp, -1}}, 1).size(), 2u);
    EXPECT_EQ(weldedSides({{kUp, 0}, {kUp, 1.1 / 256}, {kUp, -1}}, 1).size(), 3u);
    EXPECT_EQ(weldedSides({{kUp, 1}, {glm::normalize(kUp + kOut * 0.003), 1}, {kOut, 1}}, 1).size(), 2u);
}

TEST(WeldedSides, AllAgree_AreReturnedAsTheyAre) {
    const auto sides = weldedSides({{kUp, 0.25}, {kUp, 0.25 + 1e-9}, {kUp, 0.25}}, 1);
    ASSERT_EQ(sides.size(), 3u);
    EXPECT_EQ(sides[1].height, 0.25 + 1e-9);
}

TEST(WeldedSides, OrderOfFaces_DoesNotMatter) {
    std::mt19937 random(1);
    std::vector<Displacement> faces;
    for (int k = 0; k < 40; ++k) {
        const double angle = 0.5 * (k % 7);
        faces.push_back({Vec3(std::cos(angle), std::sin(angle), 0), 0.01 * (k % 3)});
    }
    const size_t count = weldedSides(faces, 0.1).size();
    EXPECT_EQ(count, 21u);
    for (int run = 0; run < 20; ++run) {
        std::shuffle(faces.begin(), faces.end(), random);
        EXPECT_EQ(weldedSides(faces, 0.1).size(), count);
    }
}

// At a corner of the cap, one face is above and two are below the crease; along its edges one and one. Below,
// the two agree: their direction (horizontal, outward) counts once.
TEST(ProxyMesh, CornersOfCreasedCap_ArePushedOutLikeItsEdges) {
    SceneObject object;
    object.name = "cube";
    object.mesh = cubeMesh();
    const int cap[] = {4, 5, 7, 6};
    for (int k = 0; k < 4; ++k)
        object.mesh.tags.creases.push_back({cap[k], cap[(k + 1) % 4], kInfinitelySharp});
    object.mesh.uvs.assign(1, Vec2(0));
    object.mesh.faceUvs.assign(24, 0);
    object.proxyRate = 4;
    const auto pushed = [&](double offset) {
        object.relief =
            Relief{std::make_shared<HeightMap>(HeightMap::constant("top", 0)), std::abs(offset), offset};
        return buildProxyMesh(object);
    };
    const ProxyMesh base = pushed(0), out = pushed(0.3), in = pushed(-0.3);
    int checked = 0;
    for (size_t i = 0; i < base.vertices.size(); ++i) {
        const Vec3 at = base.vertices[i].position, by = out.vertices[i].position - at;
        if (at.z < 1 - 1e-9 || std::abs(by.z - 0.3) < 1e-9) continue; // below the cap, or inside it
        EXPECT_NEAR(by.z, 0.3 * std::sqrt(0.5), 0.3 * 0.05); // the sides' normals are nearly horizontal
        EXPECT_NEAR(glm::length(by + (in.vertices[i].position - at)), 0, 1e-12);
        ++checked;
    }
    EXPECT_EQ(checked, 2 * 16 + 4); // 16 places on the crease, from above and below; two below at its corners
}

} // namespace
} // namespace plumbline
