// The field `merge`, and warnings of loose faces and constant maps.
#include "tests/scenes/scene_file/scene_file_fixture.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Two squares side by side that share no vertex.
const char* const kLooseQuads =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nvt 0 0\n"
    "f 1/1 2/1 3/1 4/1\nf 5/1 6/1 7/1 8/1\n";

/// The whole scene with another mesh and `fields` in its object.
std::string withFields(const std::string& fields) {
    return with("proxy_rate = 2\n", "proxy_rate = 2\n" + fields + "\n");
}

TEST_F(SceneFile, LooseFaces_AreWarnedOfAndMerged) {
    writeFile(folder_ / "quad.obj", kLooseQuads);
    const auto warning = HasSubstr("quad.obj: 2 boundary edges lie on another boundary edge");
    const Scene loose = read(withFields(""));
    EXPECT_THAT(loose.warnings, Contains(warning));
    EXPECT_THAT(loose.warnings, Contains(HasSubstr("merge = true")));
    EXPECT_EQ(loose.objects[0].mesh.points.size(), 8u);
    EXPECT_EQ(read(withFields("merge = false")).objects[0].mesh.points.size(), 8u);
    for (const char* merge : {"merge = true", "merge = 0", "merge = 0.5", "merge = 1e-9"}) {
        const Scene merged = read(withFields(merge));
        EXPECT_EQ(merged.objects[0].mesh.points.size(), 6u) << merge;
        EXPECT_THAT(merged.warnings, Not(Contains(warning)));
        EXPECT_NE(merged.hash, loose.hash);
    }
}

TEST_F(SceneFile, MergeWithoutEffect_IsWarnedOf) {
    EXPECT_THAT(read(withFields("merge = true")).warnings,
                Contains(HasSubstr("merge = true merges no vertices")));
}

TEST_F(SceneFile, Creases_CountVerticesBeforeMerging) {
    writeFile(folder_ / "quad.obj", kLooseQuads);
    const Scene scene =
        read(with("scheme = \"none\"", "merge = true\ncreases = [{ edges = [8, 7], sharpness = 3 }]"));
    ASSERT_EQ(scene.objects[0].mesh.tags.creases.size(), 1u);
    EXPECT_EQ(
        std::minmax(scene.objects[0].mesh.tags.creases[0].from, scene.objects[0].mesh.tags.creases[0].to),
        std::minmax(2, 5)); // vertices 3 and 7 of the file, of which 5 and 8 are gone
}

TEST_F(SceneFile, FaultyMerge_NamesField) {
    const std::pair<const char*, const char*> cases[] = {
        {"merge = \"yes\"",
         "object.merge: is \"yes\"; expected true, false or a distance in the mesh's units"},
        {"merge = [true]", "object.merge: is an array of 1; expected true or false"},
        {"merge = []", "object.merge: is an array; expected true, false or a distance"},
        {"merge = -1", "object.merge: is -1; expected"},
        {"merge = nan", "object.merge: is nan; expected"},
        {"merge = { distance = 1 }", "object.merge"},
        {"merge = 10", "names vertex"}, // nothing is left of the square
    };
    for (const auto& [field, message] : cases)
        EXPECT_THAT(messageFor(withFields(field)), HasSubstr(message)) << field;
    EXPECT_THAT(messageFor(with("color = [0.8, 0.75, 0.7]", "merge = true")),
                HasSubstr("object.merge: is for meshes of files; expected no merge beside shape"));
}

TEST_F(SceneFile, ConstantMap_IsWarnedOf) {
    const auto warning = HasSubstr("is constant, with the depth 0.8");
    EXPECT_THAT(read(kWholeScene).warnings, Not(Contains(warning)));
    writePng(folder_ / "maps/stone.png", 2, 1, {51, 51, 51, 51, 51, 51});
    EXPECT_THAT(read(kWholeScene).warnings, Contains(warning));
}

} // namespace
} // namespace plumbline
