// Images of baked maps: channels by kind, row order, unchanged values.
#include "realtime/bake/bake.h"
#include "realtime/bake/baked_map_picture.h"
#include "scenes/image/exr_file.h"
#include "tests/files.h"
#include "tests/realtime/bake/awkward_maps.h"
#include "tests/temporary_folder.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::ElementsAre;

class BakedMapPicture : public ::testing::Test {
  protected:
    ExrPlanes written(const BakedMap& map) const {
        writeBakedPicture(folder_ / "a.exr", map, {{"map", "stone"}});
        return readExr(folder_ / "a.exr", [](const std::vector<std::string>& names) { return names; });
    }
    static std::vector<std::string> namesOf(const ExrPlanes& picture) {
        std::vector<std::string> names;
        for (const auto& [name, plane] : picture.planes)
            names.push_back(name);
        return names;
    }
    TemporaryFolder folder_;
};

TEST_F(BakedMapPicture, Channels_AreNamedByKind) {
    const HeightMap map = noiseMap(5, 3, 1);
    const auto names = [&](const char* kind) {
        return namesOf(written(bakeMap(map, {.kind = kind, .scale = {}, .slices = 2})));
    };
    EXPECT_THAT(names("normal"), ElementsAre("D", "n.X", "n.Y", "n.Z"));
    EXPECT_THAT(names("max_mipmap"), ElementsAre("least", "most"));
    EXPECT_THAT(names("distance_field"),
                ElementsAre("slice000.box", "slice000.center", "slice001.box", "slice001.center"));
    const BakedMap cones{"cone_step_relaxed", 2, 1, {{1, 1, {0.5f, 0.25f}}}};
    EXPECT_THAT(namesOf(written(cones)), ElementsAre("cell.R", "texel.R"));
    EXPECT_EQ(written(cones).planes.at("cell.R"), std::vector{0.25f});
}

TEST_F(BakedMapPicture, TopRow_ComesFirst) {
    const HeightMap map("two rows", 2, 2, {0.0f, 0.25f, 0.5f, 0.75f});
    const ExrPlanes picture = written(bakeMap(map, {.kind = "normal", .scale = {}, .slices = 1}));
    EXPECT_EQ(picture.width, 2);
    EXPECT_EQ(picture.height, 2);
    EXPECT_EQ(picture.planes.at("D"), (std::vector{0.5f, 0.75f, 0.0f, 0.25f}));
    EXPECT_EQ(picture.attributes.at("kind"), "normal");
    EXPECT_EQ(picture.attributes.at("map"), "stone");
}

TEST_F(BakedMapPicture, EveryVoxel_IsInImage) {
    const HeightMap map = noiseMap(4, 3, 2);
    const BakedMap field = bakeMap(map, {.kind = "distance_field", .scale = {}, .slices = 5});
    const ExrPlanes picture = written(field);
    for (int k = 0; k < 5; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 4; ++i) {
                const auto pixel = static_cast<size_t>((2 - j) * 4 + i);
                const std::string slice = fmt::format("slice00{}.", k);
                EXPECT_EQ(picture.planes.at(slice + "box")[pixel], field.at(0, k, i, j)[0]);
                EXPECT_EQ(picture.planes.at(slice + "center")[pixel], field.at(0, k, i, j)[1]);
            }
}

TEST_F(BakedMapPicture, EqualMaps_GiveEqualBytes) {
    const BakedMap map = bakeMap(noiseMap(40, 30, 2), {.kind = "normal", .scale = {}, .slices = 1});
    written(map);
    const std::string first = readFile(folder_ / "a.exr");
    written(map);
    EXPECT_EQ(readFile(folder_ / "a.exr"), first);
}

} // namespace
} // namespace plumbline
