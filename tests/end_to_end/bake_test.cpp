// plumbline bake: output, files, the cache with two concurrent processes and with damaged files, and bad
// input.
#include "scenes/image/exr_file.h"
#include "scenes/image/image_file.h"
#include "tests/end_to_end/program.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <limits>
#include <thread>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class Bake : public EndToEnd {
  protected:
    /// Runs `plumbline bake …` with a cache for this test only.
    Outcome bake(std::vector<std::string> arguments) const { return bakeIn(folder_, std::move(arguments)); }
    Outcome bakeIn(const std::filesystem::path& workingFolder, std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "bake");
        return runProgram(arguments, workingFolder, {{"PLUMBLINE_CACHE", (folder_ / "cache").string()}});
    }
    std::vector<std::string> keptFiles() const { return filesBelow(folder_ / "cache"); }

    /// Expects the exit code, one line that contains `part`, nothing on stdout, and no files.
    void expectRefused(const std::vector<std::string>& arguments, const std::string& part,
                       int exitCode = 2) const {
        const auto before = filesBelow(folder_);
        const Outcome outcome = bake(arguments);
        EXPECT_EQ(outcome.signal, 0) << "crashed: " << part;
        EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(part));
        EXPECT_THAT(outcome.err, Not(HasSubstr("internal error")));
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_THAT(outcome.out, IsEmpty());
        EXPECT_EQ(filesBelow(folder_), before) << part;
    }

    /// A gray image, row 0 = top.
    void writeGray(const std::string& name, int width, int height, const std::vector<float>& values) const {
        writeExr(folder_ / name, width, height, {{"R", values}, {"G", values}, {"B", values}}, {});
    }
};

const std::vector<std::string> kScale{"--depth", "0.5", "--tile-size", "2,3"};

std::vector<std::string> withScale(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), kScale.begin(), kScale.end());
    return arguments;
}

// Heights 1, 3/4, 1/2, 1/4 in each row, that is, depths 0, 1/4, 1/2, 3/4 along s. With repeat the last of the
// four patches goes back to the first.
TEST_F(Bake, KnownImage_EqualsHandComputed) {
    writeGray("ramp.exr", 4, 1, {1.0f, 0.75f, 0.5f, 0.25f});
    const Outcome made =
        bake({"ramp.exr", "--kind", "max_mipmap", "--stores", "height", "-o", "pictures/bounds.exr"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_THAT(made.err, IsEmpty());
    EXPECT_THAT(made.out, StartsWith("max_mipmap: 4 x 1, 1 slice, 2 channels, 3 levels, 56 bytes; "));
    EXPECT_THAT(made.out, HasSubstr("made now: " + (folder_ / "cache").string()));
    EXPECT_THAT(made.out, HasSubstr("pictures/bounds.exr\n"));
    const ExrPlanes picture =
        readExr(folder_ / "pictures/bounds.exr", [](const std::vector<std::string>& names) { return names; });
    EXPECT_EQ(picture.planes.at("least"), (std::vector{0.0f, 0.25f, 0.5f, 0.0f}));
    EXPECT_EQ(picture.planes.at("most"), (std::vector{0.25f, 0.5f, 0.75f, 0.75f}));
    EXPECT_EQ(picture.attributes.at("kind"), "max_mipmap");
    EXPECT_EQ(picture.attributes.at("map"), "ramp.exr");
    EXPECT_THAT(picture.attributes.at("program"), StartsWith("plumbline "));

    // Interpreted as depths, or clamped, the same image is a different map.
    for (const auto& [stores, wrap, last] :
         {std::tuple("depth", "repeat,repeat", 0.25f), std::tuple("depth", "clamp,repeat", 0.25f),
          std::tuple("height", "clamp,repeat", 0.75f)}) {
        ASSERT_EQ(
            bake({"ramp.exr", "--kind", "max_mipmap", "--stores", stores, "--wrap", wrap, "-o", "a.exr"})
                .exitCode,
            0);
        EXPECT_EQ(readExr(folder_ / "a.exr", [](const auto& names) { return names; }).planes.at("least")[3],
                  last)
            << stores << " " << wrap;
    }
    EXPECT_EQ(keptFiles().size(), 4u);
}

// Depths 0, 1/4, 1/2, 3/4 along s have a slope of 1 per map width, that is, 0.5 world units over 2, so the
// normal is (1/4, 0, 1). Along t, over 3 world units, it is (0, 1/6, 1).
TEST_F(Bake, Scale_TakesEffect) {
    const auto slope = [&](const std::string& map, const std::string& channel) {
        EXPECT_EQ(bake(withScale({map, "--kind", "normal", "--stores", "depth", "-o", "n.exr"})).exitCode, 0);
        const ExrPlanes picture = readExr(folder_ / "n.exr", [](const auto& names) { return names; });
        EXPECT_EQ(picture.attributes.at("tile_size"), "2 3");
        EXPECT_EQ(picture.attributes.at("relief_depth"), "0.5");
        return picture.planes.at(channel)[1] / picture.planes.at("n.Z")[1];
    };
    writeGray("along_s.exr", 4, 1, {0.0f, 0.25f, 0.5f, 0.75f});
    writeGray("along_t.exr", 1, 4, {0.75f, 0.5f, 0.25f, 0.0f}); // the top row first
    EXPECT_FLOAT_EQ(slope("along_s.exr", "n.X"), 0.25f);
    EXPECT_FLOAT_EQ(slope("along_t.exr", "n.Y"), 1.0f / 6);
}

TEST_F(Bake, SecondBake_ComesFromCache) {
    writeSmallScene();
    for (const char* kind : {"normal", "distance_field"}) {
        const auto arguments = withScale({"small.toml#stone", "--kind", kind});
        const Outcome first = bake(arguments), second = bake(arguments);
        ASSERT_EQ(first.exitCode, 0) << first.err;
        ASSERT_EQ(second.exitCode, 0) << second.err;
        EXPECT_THAT(first.out, HasSubstr(", made now: "));
        std::string expected = first.out;
        expected.replace(expected.find("made now"), 8, "from the cache");
        EXPECT_EQ(second.out, expected) << "also the time it took when it was made";
    }
    EXPECT_EQ(keptFiles().size(), 2u);
    EXPECT_THAT(bake(withScale({"stone_torus#stone", "--kind", "normal"})).out, HasSubstr("256 x 256"));
}

TEST_F(Bake, CacheAndOneThread_GiveEqualBytes) {
    writeSmallScene();
    const auto picture = [&](const std::string& file, const std::string& threads) {
        EXPECT_EQ(bake(withScale({"small.toml#stone", "--kind", "distance_field", "--slices", "9", "-o", file,
                                  "--threads", threads}))
                      .exitCode,
                  0);
        return readFile(folder_ / file);
    };
    const std::string two = picture("a.exr", "2"), cached = picture("b.exr", "2");
    std::filesystem::remove_all(folder_ / "cache");
    const std::string one = picture("c.exr", "1");
    EXPECT_GT(two.size(), 1000u);
    EXPECT_TRUE(two == cached);
    EXPECT_TRUE(two == one);
}

// Both may bake the map. One complete file must remain, from the process that renamed last.
TEST_F(Bake, TwoProcesses_ShareCache) {
    const std::string scene = writeSmallScene();
    for (const char* folder : {"a", "b"})
        std::filesystem::create_directories(folder_ / folder);
    for (int round = 0; round < 5; ++round) {
        const std::vector<std::string> arguments =
            withScale({scene + "#stone", "--kind", "distance_field", "--slices", std::to_string(250 + round),
                       "-o", "picture.exr"});
        Outcome a, b;
        std::thread other([&] { a = bakeIn(folder_ / "a", arguments); });
        b = bakeIn(folder_ / "b", arguments);
        other.join();
        for (const Outcome& outcome : {a, b}) {
            EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
            EXPECT_THAT(outcome.err, IsEmpty());
        }
        EXPECT_TRUE(readFile(folder_ / "a/picture.exr") == readFile(folder_ / "b/picture.exr"));
        EXPECT_THAT(bake(arguments).out, HasSubstr("from the cache"));
        EXPECT_EQ(keptFiles().size(), static_cast<size_t>(round + 1)) << "nothing else is left";
    }
}

TEST_F(Bake, DamagedFile_IsRemade) {
    writeGray("ramp.exr", 4, 1, {1.0f, 0.75f, 0.5f, 0.25f});
    const std::vector<std::string> arguments{"ramp.exr", "--kind", "max_mipmap", "--stores", "height"};
    ASSERT_EQ(bake(arguments).exitCode, 0);
    const std::filesystem::path file = folder_ / "cache" / keptFiles().at(0);
    const std::string good = readFile(file);
    std::string flipped = good;
    flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 4);
    for (const std::string& damaged : {std::string(), good.substr(0, good.size() - 1), good + "x", flipped,
                                       std::string(good.size(), '\0')}) {
        writeFile(file, damaged);
        const Outcome rebaked = bake(arguments);
        EXPECT_EQ(rebaked.exitCode, 0) << rebaked.err;
        EXPECT_THAT(rebaked.out, HasSubstr("made now"));
        EXPECT_THAT(rebaked.err, StartsWith("warning: " + file.string() + ": is damaged"));
        const Outcome kept = bake(arguments);
        EXPECT_THAT(kept.out, HasSubstr("from the cache"));
        EXPECT_THAT(kept.err, IsEmpty());
    }
}

TEST_F(Bake, NoCache_StillBakes) {
    writeGray("gray.exr", 2, 1, {0.5f, 0.25f});
    writeFile(folder_ / "file", "in the way");
    const std::vector<std::string> arguments{"bake",     "gray.exr", "--kind", "max_mipmap",
                                             "--stores", "depth",    "-o",     "a.exr"};
    const Outcome blocked =
        runProgram(arguments, folder_, {{"PLUMBLINE_CACHE", (folder_ / "file/cache").string()}});
    EXPECT_EQ(blocked.exitCode, 0) << blocked.err;
    EXPECT_THAT(blocked.out, HasSubstr("made now: not kept"));
    EXPECT_THAT(blocked.err, StartsWith("warning: baked maps aren't kept"));
    EXPECT_THAT(readFile(folder_ / "a.exr"), Not(IsEmpty()));
    const Outcome nowhere =
        runProgram(arguments, folder_, {{"PLUMBLINE_CACHE", ""}, {"XDG_CACHE_HOME", ""}, {"HOME", ""}});
    EXPECT_EQ(nowhere.exitCode, 0) << nowhere.err;
    EXPECT_THAT(nowhere.err, HasSubstr("none of PLUMBLINE_CACHE, XDG_CACHE_HOME and HOME is set"));
}

TEST_F(Bake, OneTexelAndConstant_Bake) {
    writeGray("one.exr", 1, 1, {0.5f});
    writeGray("flat.exr", 7, 3, std::vector<float>(21, 1.0f));
    for (const char* map : {"one.exr", "flat.exr"})
        for (const char* wrap : {"repeat,repeat", "clamp,repeat", "clamp,clamp"}) {
            const std::vector<std::string> common{map, "--stores", "depth", "--wrap", wrap, "--kind"};
            for (const char* kind : {"normal", "distance_field", "max_mipmap"}) {
                std::vector<std::string> arguments = common;
                arguments.emplace_back(kind);
                const Outcome made =
                    bake(std::string(kind) == "max_mipmap" ? arguments : withScale(arguments));
                EXPECT_EQ(made.exitCode, 0) << made.err;
                EXPECT_THAT(made.err, IsEmpty());
            }
        }
}

TEST_F(Bake, BadMaps_AreRefused) {
    const auto stores = [](const std::string& map) {
        return std::vector<std::string>{map, "--kind", "max_mipmap", "--stores", "depth"};
    };
    writeSmallScene();
    expectRefused(stores("missing.png"), "missing.png");
    expectRefused(stores("."), ".");
    writeFile(folder_ / "text.png", "no picture\n");
    expectRefused(stores("text.png"), "text.png");
    writeGray("nan.exr", 3, 2, {0, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0});
    expectRefused(stores("nan.exr"),
                  "nan.exr: 1 of 6 texels are NaN or outside [0,1], the first is nan at column 1, "
                  "row 1 from the top");
    writeGray("high.exr", 1, 1, {1.5f});
    expectRefused(stores("high.exr"), "high.exr");
    expectRefused({"small.toml", "--kind", "max_mipmap"}, "SCENE.toml#NAME");
    expectRefused({"small.toml#ston", "--kind", "max_mipmap"}, "did you mean 'stone'?");
    expectRefused({"smal.toml#stone", "--kind", "max_mipmap"}, "smal.toml");
    expectRefused({"stone_tours#stone", "--kind", "max_mipmap"}, "did you mean 'stone_torus'?");
    expectRefused({"#", "--kind", "max_mipmap"}, "scene");
    expectRefused(stores("small.toml#stone"), "--stores: found 'depth' with a scene's map");
    expectRefused({"small.toml#stone", "--kind", "max_mipmap", "--wrap", "clamp,clamp"}, "--wrap");
    expectRefused({"high.exr", "--kind", "max_mipmap"}, "--stores: is missing");
}

TEST_F(Bake, BadOptions_AreRefused) {
    writeGray("a.exr", 1, 1, {0.5f});
    const auto with = [](const std::string& kind, std::vector<std::string> more) {
        more.insert(more.begin(), {"a.exr", "--stores", "depth", "--kind", kind});
        return more;
    };
    expectRefused({"a.exr"}, "--kind");
    expectRefused(with("normall", {}), "did you mean 'normal'?");
    expectRefused(with("", {}), "expected");
    expectRefused(with("normal", {}), "--depth: is missing");
    expectRefused(with("normal", {"--depth", "1"}), "--tile-size: is missing");
    expectRefused(with("max_mipmap", {"--depth", "1"}), "--depth: found '1'; expected no scale");
    expectRefused(with("max_mipmap", {"--tile-size", "1,1"}), "--tile-size");
    for (const char* bad : {"-1", "0", "nan", "inf", "1e10", "deep", ""})
        expectRefused(with("normal", {"--depth", bad, "--tile-size", "1,1"}), "--depth");
    for (const char* bad : {"1", "1,", ",1", "1,1,1", "0,1", "1,-1", "1x1", ""})
        expectRefused(with("normal", {"--depth", "1", "--tile-size", bad}), "--tile-size");
    expectRefused(with("normal", {"--depth", "1e9", "--tile-size", "1e-9,1"}), "scale");
    for (const char* bad : {"0", "-1", "1025", "many"})
        expectRefused(withScale(with("distance_field", {"--slices", bad})), "--slices");
    expectRefused(withScale(with("normal", {"--slices", "8"})), "--slices");
    for (const char* bad : {"repeat", "repeat,mirror", "clamp,", "repeat,repeat,repeat", ""})
        expectRefused(with("max_mipmap", {"--wrap", bad}), "--wrap");
    expectRefused({"a.exr", "--kind", "max_mipmap", "--stores", "heights"}, "did you mean 'height'?");
}

TEST_F(Bake, UnwritableOutput_IsRefused) {
    writeGray("a.exr", 1, 1, {0.5f});
    const auto into = [](const std::string& file) {
        return std::vector<std::string>{"a.exr", "--stores", "depth", "--kind", "max_mipmap", "-o", file};
    };
    EXPECT_EQ(bake(into("new/folder/b.exr")).exitCode, 0) << "a missing folder is made";
    expectRefused(into("a.exr/b.exr"), "a.exr");
    expectRefused(into("."), "folder");
    expectRefused(into("/dev/full"), "/dev/full");
}

TEST_F(Bake, TooMuchMemory_IsMachineError) {
    std::string scene = kSmallScene;
    scene = withLine(scene, "kind = \"cobbles\", size = 32", "kind = \"ramp\", size = 16384");
    scene = withLine(scene, "relief = { map = \"stone\", depth = 0.1, tile = [3, 2] }\n", "");
    writeFile(folder_ / "big.toml", scene);
    expectRefused(withScale({"big.toml#stone", "--kind", "distance_field", "--slices", "1024"}),
                  "memory: a distance field of generated ramp, 16384 x 16384", 3);
}

TEST_F(Bake, List_PrintsKinds) {
    const Outcome list = run({"list", "bakes"});
    EXPECT_EQ(list.exitCode, 0);
    for (const char* part : {"normal: ", "distance_field: ", "max_mipmap: ", "channels: ", "needs a scale"})
        EXPECT_THAT(list.out, HasSubstr(part));
    EXPECT_THAT(run({"doctor"}, {{"PLUMBLINE_CACHE", (folder_ / "cache").string()}}).out,
                HasSubstr((folder_ / "cache").string() + ", 0 baked maps"));
}

} // namespace
} // namespace plumbline
