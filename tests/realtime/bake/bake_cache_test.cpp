// The cache of baked maps: its keys, and that damaged files are never used.
#include "realtime/bake/bake_cache.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/realtime/bake/awkward_maps.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Sets environment variables for one test and restores them.
class Variables {
  public:
    ~Variables() {
        for (const auto& [name, value] : before_)
            value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
    }
    void set(const std::string& name, const std::string& value) {
        remember(name);
        ::setenv(name.c_str(), value.c_str(), 1);
    }
    void unset(const std::string& name) {
        remember(name);
        ::unsetenv(name.c_str());
    }

  private:
    void remember(const std::string& name) {
        const char* value = std::getenv(name.c_str());
        before_.emplace_back(name, value ? std::optional<std::string>(value) : std::nullopt);
    }
    std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

class BakeCache : public ::testing::Test {
  protected:
    BakeCache() { variables_.set("PLUMBLINE_CACHE", (folder_ / "cache").string()); }

    static void expectSameMap(const BakedMap& a, const BakedMap& b) {
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.slices, b.slices);
        EXPECT_EQ(a.channels, b.channels);
        ASSERT_EQ(a.levels.size(), b.levels.size());
        for (size_t k = 0; k < a.levels.size(); ++k) {
            EXPECT_EQ(a.levels[k].width, b.levels[k].width);
            EXPECT_EQ(a.levels[k].height, b.levels[k].height);
            EXPECT_TRUE(sameBits(a.levels[k].values, b.levels[k].values)) << "level " << k;
        }
    }

    TemporaryFolder folder_;
    Variables variables_;
};

BakeRequest request(const std::string& kind, BakeScale scale = {}, int slices = 4) {
    return {.kind = kind, .scale = scale, .slices = slices};
}

TEST_F(BakeCache, StoredMap_IsReadBack) {
    for (const BakeKind& kind : bakeKinds())
        for (const HeightMap& map : {noiseMap(13, 6, 1), noiseMap(1, 1, 2, Wrap::Clamp)}) {
            SCOPED_TRACE(kind.name);
            const BakeRequest asked = request(std::string(kind.name), {1, 2, 0.3});
            const BakeOutcome made = bakeCached(map, asked), kept = bakeCached(map, asked);
            EXPECT_FALSE(made.fromCache);
            EXPECT_TRUE(kept.fromCache);
            EXPECT_THAT(made.warning + kept.warning, IsEmpty());
            EXPECT_GT(made.ms, 0);
            EXPECT_EQ(kept.ms, made.ms) << "what it took when it was made";
            EXPECT_EQ(kept.bytes, made.map.bytes());
            EXPECT_EQ(kept.file, made.file);
            EXPECT_EQ(kept.file.parent_path(), folder_ / "cache");
            EXPECT_TRUE(kept.file.filename().string().starts_with(std::string(kind.name) + "-"));
            expectSameMap(made.map, kept.map);
            expectSameMap(kept.map, bakeMap(map, asked));
        }
}

TEST_F(BakeCache, Key_DiffersForDifferentValues) {
    const HeightMap map = noiseMap(8, 4, 1);
    std::vector<float> nudged = map.depths();
    nudged[17] = std::nextafter(nudged[17], 0.0f);
    const auto with = [&](int width, int height, const std::vector<float>& depths, Wrap s, Wrap t) {
        return bakeCacheKey(HeightMap("other", width, height, depths, s, t), request("normal"));
    };
    std::vector<std::string> keys{
        bakeCacheKey(map, request("normal")),
        bakeCacheKey(map, request("max_mipmap")),
        bakeCacheKey(map, request("distance_field")),
        bakeCacheKey(map, request("distance_field", {}, 5)),
        bakeCacheKey(map, request("normal", {1, 1, 1.0000000000000002})),
        bakeCacheKey(map, request("normal", {1, 2, 1})),
        bakeCacheKey(map, request("normal", {2, 1, 1})),
        with(4, 8, map.depths(), Wrap::Repeat, Wrap::Repeat),
        with(8, 4, map.depths(), Wrap::Clamp, Wrap::Repeat),
        with(8, 4, map.depths(), Wrap::Repeat, Wrap::Clamp),
        with(8, 4, nudged, Wrap::Repeat, Wrap::Repeat),
    };
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
    for (const std::string& key : keys)
        EXPECT_EQ(key.size(), 32u);
}

TEST_F(BakeCache, Key_IgnoresIrrelevantInputs) {
    const HeightMap map = noiseMap(8, 4, 1), renamed("other", 8, 4, map.depths());
    const auto key = [&](const BakeRequest& asked) { return bakeCacheKey(map, asked); };
    EXPECT_EQ(bakeCacheKey(renamed, request("normal")), key(request("normal")));
    EXPECT_EQ(key(request("normal", {2, 4, 6})), key(request("normal", {1, 2, 3}))) << "ratios alone";
    EXPECT_EQ(key(request("normal", {}, 7)), key(request("normal", {}, 9))) << "it has no slices";
    EXPECT_EQ(key(request("max_mipmap", {1, 2, 3}, 7)), key(request("max_mipmap", {0, 0, 0}, 9)));
}

/// Bakes a map, modifies its file, and expects it to be baked again and the file to be restored.
void expectBakedAgain(const HeightMap& map, const BakeRequest& asked, const std::string& damaged) {
    const BakeOutcome first = bakeCached(map, asked);
    writeFile(first.file, damaged);
    const BakeOutcome second = bakeCached(map, asked);
    EXPECT_FALSE(second.fromCache);
    EXPECT_THAT(second.warning, HasSubstr("damaged"));
    EXPECT_THAT(second.warning, HasSubstr(first.file.string()));
    EXPECT_TRUE(sameBits(second.map.levels[0].values, first.map.levels[0].values));
    const BakeOutcome third = bakeCached(map, asked);
    EXPECT_TRUE(third.fromCache);
    EXPECT_TRUE(sameBits(third.map.levels[0].values, first.map.levels[0].values));
}

TEST_F(BakeCache, DamagedFile_IsRemade) {
    const HeightMap map = noiseMap(6, 5, 3);
    const BakeRequest asked = request("max_mipmap");
    const std::string good = readFile(bakeCached(map, asked).file);
    expectBakedAgain(map, asked, "");
    expectBakedAgain(map, asked, "not a baked map at all");
    expectBakedAgain(map, asked, std::string(100000, '\xff'));
    for (size_t length = 1; length < good.size(); ++length)
        expectBakedAgain(map, asked, good.substr(0, length));
    expectBakedAgain(map, asked, good + '\0');
    expectBakedAgain(map, asked, good + good);
    // An intact file of another map with the same size.
    expectBakedAgain(map, asked, readFile(bakeCached(noiseMap(6, 5, 4), asked).file));
}

TEST_F(BakeCache, FlippedBit_IsDetected) {
    const HeightMap map = noiseMap(1, 1, 5);
    const BakeRequest asked = request("normal");
    const BakeOutcome made = bakeCached(map, asked);
    const std::string good = readFile(made.file);
    for (size_t byte = 0; byte < good.size(); ++byte)
        for (int bit = 0; bit < 8; ++bit) {
            std::string flipped = good;
            flipped[byte] = static_cast<char>(flipped[byte] ^ (1 << bit));
            writeFile(made.file, flipped);
            ASSERT_FALSE(bakeCached(map, asked).fromCache) << "byte " << byte << ", bit " << bit;
        }
}

// The magic number, the version and the key are followed by five sizes, for which no memory may be allocated
// unchecked.
TEST_F(BakeCache, HugeHeader_IsRefusedBeforeAllocation) {
    const HeightMap map = noiseMap(4, 4, 5);
    const BakeRequest asked = request("max_mipmap");
    const std::string good = readFile(bakeCached(map, asked).file);
    for (size_t number = 0; number < 5; ++number)
        for (const uint32_t claimed : {0u, 5u, 1024u, 1u << 20, 0x7fffffffu, 0xffffffffu}) {
            std::string lying = good;
            std::memcpy(&lying[8 + 4 + 32 + 4 * number], &claimed, sizeof claimed);
            expectBakedAgain(map, asked, lying);
        }
}

TEST_F(BakeCache, Folder_HoldsOnlyWholeFiles) {
    for (int n = 0; n < 3; ++n)
        bakeCached(noiseMap(4, 4, static_cast<unsigned>(n)), request("normal"));
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "cache"))
        EXPECT_EQ(entry.path().extension(), ".bake") << entry.path();
}

TEST_F(BakeCache, Folder_FollowsEnvironment) {
    variables_.set("PLUMBLINE_CACHE", "/one");
    variables_.set("XDG_CACHE_HOME", "/two");
    variables_.set("HOME", "/three");
    EXPECT_EQ(bakeCacheFolder(), "/one");
    variables_.set("PLUMBLINE_CACHE", "");
    EXPECT_EQ(bakeCacheFolder(), "/two/plumbline");
    variables_.set("XDG_CACHE_HOME", "relative");
    EXPECT_EQ(bakeCacheFolder(), "/three/.cache/plumbline");
    variables_.unset("XDG_CACHE_HOME");
    variables_.unset("PLUMBLINE_CACHE");
    EXPECT_EQ(bakeCacheFolder(), "/three/.cache/plumbline");
    variables_.unset("HOME");
    EXPECT_EQ(bakeCacheFolder(), std::nullopt);
}

// Permission bits don't affect root, so the path is blocked by a file, or the file by a folder.
TEST_F(BakeCache, NoFolder_StillBakes) {
    const HeightMap map = noiseMap(4, 3, 1);
    const BakeRequest asked = request("normal");
    writeFile(folder_ / "file", "in the way");
    const std::string blocked = (folder_ / "file").string() + "/cache";
    variables_.set("PLUMBLINE_CACHE", blocked);
    for (int n = 0; n < 2; ++n) {
        const BakeOutcome outcome = bakeCached(map, asked);
        EXPECT_FALSE(outcome.fromCache);
        EXPECT_THAT(outcome.file.string(), IsEmpty());
        EXPECT_THAT(outcome.warning, HasSubstr(blocked));
        expectSameMap(outcome.map, bakeMap(map, asked));
    }
    for (const char* name : {"PLUMBLINE_CACHE", "XDG_CACHE_HOME", "HOME"})
        variables_.unset(name);
    EXPECT_THAT(bakeCached(map, asked).warning, HasSubstr("PLUMBLINE_CACHE"));

    variables_.set("PLUMBLINE_CACHE", (folder_ / "cache").string());
    std::filesystem::create_directories(folder_ / "cache" / ("normal-" + bakeCacheKey(map, asked) + ".bake"));
    const BakeOutcome outcome = bakeCached(map, asked);
    EXPECT_THAT(outcome.warning, HasSubstr("isn't kept"));
    expectSameMap(outcome.map, bakeMap(map, asked));
}

TEST_F(BakeCache, FailedBake_IsNotStored) {
    const HeightMap map = noiseMap(2, 2, 1);
    EXPECT_THAT(inputErrorOf([&] { bakeCached(map, request("norml")); }),
                HasSubstr("did you mean 'normal'?"));
    EXPECT_THROW(bakeCached(map, request("normal", {1, 1, -1})), InputError);
    EXPECT_THROW(bakeCached(map, request("distance_field", {}, 0)), InputError);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "cache") && !std::filesystem::is_empty(folder_ / "cache"));
}

} // namespace
} // namespace plumbline
