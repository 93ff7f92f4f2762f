// Creases, seams and warnings in scene files.
#include "scenes/surface/displaced_surface.h"
#include "tests/files.h"
#include "tests/scenes/scene_file/scene_file_fixture.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::HasSubstr;

/// The whole scene with creases for its torus of 72 vertices.
std::string withCreases(const std::string& creases) {
    return with("color = [0.8, 0.75, 0.7]\n", "creases = " + creases + "\n");
}

TEST_F(SceneFile, Creases_AreRead) {
    const SubdivisionTags tags =
        read(withCreases("[{ edges = [1, 2, 3], sharpness = 2.5 }, { vertex = 72, sharpness = 10 },\n"
                         "  { edges = [3, 2], sharpness = 4 }]")) // the last one applies
            .objects[1]
            .mesh.tags;
    ASSERT_EQ(tags.creases.size(), 2u);
    EXPECT_EQ(std::minmax(tags.creases[0].from, tags.creases[0].to), std::minmax(0, 1)); // 1-based to 0-based
    EXPECT_EQ(tags.creases[0].sharpness, 2.5);
    EXPECT_EQ(std::minmax(tags.creases[1].from, tags.creases[1].to), std::minmax(1, 2));
    EXPECT_EQ(tags.creases[1].sharpness, 4);
    ASSERT_EQ(tags.corners.size(), 1u);
    EXPECT_EQ(tags.corners[0].vertex, 71);
    EXPECT_EQ(tags.corners[0].sharpness, 10);
    EXPECT_TRUE(read(withCreases("[]")).objects[1].mesh.tags.creases.empty());
}

TEST_F(SceneFile, SceneCreases_AddToMeshs) {
    writeFile(folder_ / "quad.obj",
              std::string(kQuad) + "t crease 4/3/0 0 1 2 3 1 2 3\nt corner 1/1/0 0 1\n");
    const SubdivisionTags tags =
        read(with("scheme = \"none\"", "creases = [{ edges = [3, 2], sharpness = 7 }, { vertex = 1, "
                                       "sharpness = 8 }, { vertex = 2, sharpness = 9 }]"))
            .objects[0]
            .mesh.tags;
    ASSERT_EQ(tags.creases.size(), 3u);
    EXPECT_EQ(tags.creases[0].sharpness, 1);
    EXPECT_EQ(tags.creases[1].sharpness, 7);
    EXPECT_EQ(tags.creases[2].sharpness, 3);
    ASSERT_EQ(tags.corners.size(), 2u);
    EXPECT_EQ(tags.corners[0].sharpness, 8);
    EXPECT_EQ(tags.corners[1].sharpness, 9);
}

TEST_F(SceneFile, FaultyCreases_NameTheirLine) {
    const std::pair<const char*, const char*> cases[] = {
        {"3", "scene.toml:45: object.creases: is 3; expected tables [[object.creases]]"},
        {"[1]", "object.creases: holds 1"},
        {"[{ edges = [1, 2] }]", "object.creases.sharpness: is missing"},
        {"[{ sharpness = 2 }]",
         "object.creases: has neither edges nor vertex; expected edges = [vertex, vertex, …] or vertex"},
        {"[{ edges = [1, 2], vertex = 3, sharpness = 2 }]", "has both edges and vertex"},
        {"[{ edges = [1, 2], sharpness = -1 }]",
         "object.creases.sharpness: is -1; expected a number from 0 to"},
        {"[{ edges = [1, 2], sharpness = nan }]", "object.creases.sharpness: is nan"},
        {"[\n{ edges = [1], sharpness = 2 }]",
         "scene.toml:46: object.creases.edges: has 1 vertices; expected two"},
        {"[{ edges = [0, 1], sharpness = 2 }]",
         "object.creases.edges: is 0; expected a whole number from 1 to 72"},
        {"[{ edges = [1, 73], sharpness = 2 }]", "object.creases.edges: is 73"},
        {"[{ edges = [1, 2, 4], sharpness = 2 }]", "object.creases.edges: no face has an edge from vertex 2 "
                                                   "to 4; expected vertices that are neighbors"},
        {"[{ edges = 1, sharpness = 2 }]", "object.creases.edges: is 1; expected an array of whole numbers"},
        {"[{ vertex = 73, sharpness = 2 }]",
         "object.creases.vertex: is 73; expected a whole number from 1 to 72"},
        {"[{ vertex = 3, sharpnes = 2 }]", "object.creases.sharpness: is missing"},
        {"[{ vertex = 3, sharpness = 2, color = 1 }]", "object.creases.color: unknown field"},
    };
    for (const auto& [creases, message] : cases)
        EXPECT_THAT(messageFor(withCreases(creases)), HasSubstr(message)) << creases;
    EXPECT_THAT(messageFor(with("scheme = \"none\"", "scheme = \"none\"\ncreases = []")),
                HasSubstr("scene.toml:34: object.creases: has no meaning under scheme \"none\""));
}

TEST_F(SceneFile, Seams_DefaultToWeld) {
    EXPECT_EQ(read(kWholeScene).objects[0].relief->seams, Seams::Weld);
    EXPECT_EQ(read(with("depth = 0.08", "depth = 0.08, seams = \"weld\"")).objects[0].relief->seams,
              Seams::Weld);
    EXPECT_EQ(read(with("depth = 0.08", "depth = 0.08, seams = \"open\"")).objects[0].relief->seams,
              Seams::Open);
}

TEST_F(SceneFile, MeshWarnings_NameObject) {
    EXPECT_TRUE(read(kWholeScene).warnings.empty());
    writeFile(folder_ / "quad.obj", std::string(kQuad) + "v 9 9 9\nt facevaryingpropagatecorners 1/0/0 1\n");
    const std::vector<std::string> warnings = read(kWholeScene).warnings;
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_THAT(warnings[0], testing::StartsWith("quad: "));
    EXPECT_THAT(warnings[0], HasSubstr("quad.obj:11: facevaryingpropagatecorners is ignored"));
    EXPECT_THAT(warnings[1], testing::StartsWith("quad: "));
    EXPECT_THAT(warnings[1], HasSubstr("quad.obj: vertex 5 belongs to no face: left out"));
}

TEST_F(SceneFile, BoxCorners_AreNumberedAsInReadme) {
    // Edges of its front face, z = 1.5: infinitely sharp, so their limit is in that plane.
    const Scene scene =
        read(with("kind = \"torus\", major = 1.0, minor = 0.25, segments = [12, 6] }",
                  "kind = \"box\", size = [1, 2, 3] }\ncreases = [{ edges = [1, 2, 3, 4, 1], sharpness = "
                  "10 }]"));
    const std::unique_ptr<BaseSurface> surface = makeBaseSurface(scene.objects[1]);
    BaseSurface::Evaluator evaluator(*surface);
    evaluator.setPatch(0);
    for (const double u : {0.0, 0.3, 1.0})
        EXPECT_NEAR(evaluator.point(u, 0.5).position.z, 1.5, 1e-14) << u;
    const Vec3 corners[] = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1},    {-1, 1, 1},
                            {1, -1, -1}, {1, 1, -1}, {-1, -1, -1}, {-1, 1, -1}};
    for (size_t i = 0; i < 8; ++i)
        EXPECT_EQ(scene.objects[1].mesh.points[i], corners[i] * Vec3(0.5, 1, 1.5)) << i;
}

} // namespace
} // namespace plumbline
