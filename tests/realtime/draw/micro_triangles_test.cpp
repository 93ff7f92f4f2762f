// The control technique on small hand-made micro-meshes.
#include "tests/realtime/gl_fixture.h"

#include <cmath>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

/// One grid over [-1, 1]^2 in the plane y = 0 with the given heights, row by row along -z; normal up, st =
/// (column, row).
MicroMesh gridMesh(int columns, int rows, const std::vector<float>& heights) {
    MicroMesh mesh;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const float x = -1 + 2 * static_cast<float>(column) / static_cast<float>(columns - 1);
            const float z = 1 - 2 * static_cast<float>(row) / static_cast<float>(rows - 1);
            mesh.positionsWorld.emplace_back(x, heights[static_cast<size_t>(row * columns + column)], z);
            mesh.normalsWorld.emplace_back(0, 1, 0);
            mesh.st.emplace_back(column, row);
        }
    mesh.grids.push_back({0, 0, static_cast<uint16_t>(columns), static_cast<uint16_t>(rows), 0, 0, 0, false});
    return mesh;
}

Frame drawMicro(const Scene& scene, const std::vector<MicroMesh>& meshes) {
    RealtimeRenderer renderer(scene, {GlBackend::Auto, -1, 0}, testContext());
    return renderer.render(resolveTechnique("micro_triangles"), &meshes).frame;
}

Scene squareScene(const Vec3& cameraPosition) {
    return sceneOf(squareObject(2, nullptr, 0), orthographicCamera(cameraPosition, {0, 0, -1}, 4, 64));
}

TEST(MicroTriangles, Diagonal_JoinsSecondAndThirdCorner) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // Corner d (column 1, row 1) is raised by 1. Triangle a b c stays in y = 0, and d c b rises linearly from
    // the diagonal: y = (x - z) / 2 where x > z. The other diagonal would raise the center to 1/2.
    const Scene scene = squareScene({0, 5, 0});
    const Frame frame = drawMicro(scene, {gridMesh(2, 2, {0, 0, 0, 1})});
    EXPECT_EQ(coveredPixels(frame), 32u * 32u);
    for (size_t i = 0; i < frame.pixelCount(); ++i) {
        if (frame.channel("A")[i] == 0) continue;
        const Vec3 point = vectorAt(frame, "P", i);
        ASSERT_NEAR(point.y, std::max(0.0, (point.x - point.z) / 2), 1e-5);
        ASSERT_NEAR(frame.channel("Z")[i], 5 - point.y, 1e-5);
        ASSERT_EQ(frame.channel("id")[i], 1);
    }
    // Oriented as in the image: pixel (16, 16) is 1/16 inside the square's upper left corner.
    EXPECT_NEAR(stAt(frame, pixelAt(frame, 16, 16)).x, 1.0 / 64, 1e-5);
    EXPECT_NEAR(stAt(frame, pixelAt(frame, 16, 16)).y, 63.0 / 64, 1e-5);
}

TEST(MicroTriangles, BothSides_AreSeenAndShadowedPerSide) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    for (const double side : {1.0, -1.0}) {
        Scene scene = squareScene({0, 5 * side, 0});
        scene.lights = {directionalLight("above", {0, 1, 0})};
        const Frame frame = drawMicro(scene, {gridMesh(2, 2, {0, 0, 0, 0})});
        EXPECT_EQ(coveredPixels(frame), 32u * 32u);
        const size_t pixel = pixelAt(frame, 32, 32);
        EXPECT_EQ(vectorAt(frame, "N", pixel), Vec3(0, 1, 0)); // not flipped
        EXPECT_EQ(frame.channel("shadow.above")[pixel], side > 0 ? 0 : 1);
        EXPECT_NEAR(frame.channel("R")[pixel], 0.8 * (kAmbient + (side > 0 ? 1 : 0)), 1e-6);
    }
}

TEST(MicroTriangles, ManyGrids_CoverWithoutGapsOrOverlaps) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    // More vertices than fit in one chunk, in adjacent grids of three sizes: every pixel is covered once,
    // without gaps.
    MicroMesh mesh;
    const int strips = 1200;
    for (int strip = 0; strip < strips; ++strip) {
        const int columns = std::vector<int>{17, 9, 5}[static_cast<size_t>(strip % 3)], rows = 17;
        mesh.grids.push_back({static_cast<uint32_t>(mesh.positionsWorld.size()), 0,
                              static_cast<uint16_t>(columns), static_cast<uint16_t>(rows), 0, 0, 0, false});
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                const float along = (static_cast<float>(strip) +
                                     static_cast<float>(column) / static_cast<float>(columns - 1)) /
                                    strips;
                mesh.positionsWorld.emplace_back(-1 + 2 * along, 0, 1 - 2 * static_cast<float>(row) / 16);
                mesh.normalsWorld.emplace_back(0, 1, 0);
                mesh.st.emplace_back(along, 0);
            }
    }
    ASSERT_GT(mesh.positionsWorld.size(), size_t(1) << 17);
    const Scene scene = squareScene({0, 5, 0});
    const Frame frame = drawMicro(scene, {mesh});
    EXPECT_EQ(coveredPixels(frame), 32u * 32u);
    // Two runs give equal results although grids of equal size are drawn together.
    const Frame again = drawMicro(scene, {mesh});
    for (size_t i = 0; i < frame.pixelCount(); ++i)
        if (frame.channel("A")[i] > 0) {
            ASSERT_EQ(frame.channel("st.S")[i], again.channel("st.S")[i]);
        }
}

TEST(MicroTriangles, Frame_HasNoLookUps) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const Frame frame = drawMicro(squareScene({0, 5, 0}), {gridMesh(2, 2, {0, 0, 0, 0})});
    EXPECT_FALSE(frame.has("cost.fetches"));
    EXPECT_TRUE(frame.has("shadow.sun"));
    EXPECT_EQ(frame.metadata.at("base"), "limit");
}

TEST(MicroTriangles, NoMeshesOrAttributes_IsInputError) {
    PLUMBLINE_NEEDS_GL(GlBackend::Auto);
    const Scene scene = squareScene({0, 5, 0});
    RealtimeRenderer renderer(scene, {}, testContext());
    const Technique technique = resolveTechnique("micro_triangles");
    EXPECT_THROW(renderer.render(technique, nullptr), InputError);
    std::vector<MicroMesh> meshes{gridMesh(2, 2, {0, 0, 0, 0})};
    meshes[0].st.clear();
    EXPECT_THROW(renderer.render(technique, &meshes), InputError);
    meshes.clear();
    EXPECT_THROW(renderer.render(technique, &meshes), InputError);
}

} // namespace
} // namespace plumbline
