#include "scenes/core/error.h"
#include "tests/temporary_folder.h"
#include "validate/results/output_files.h"

#include <gtest/gtest.h>

#include <fstream>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public ::testing::Test {
  protected:
    TemporaryFolder temporary_;
    const fs::path folder_ = temporary_.path();
};

TEST_F(OutputFiles, NewFolder_IsCreatedWithParents) {
    requireWritableFolder(folder_ / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
    EXPECT_TRUE(fs::is_empty(folder_ / "a" / "b")); // the probe was removed
    requireWritableFile(folder_ / "c" / "frame.exr", {});
    EXPECT_FALSE(fs::exists(folder_ / "c" / "frame.exr"));
}

TEST_F(OutputFiles, InputFiles_AreNotReplaced) {
    for (const char* name : {"scene.toml", "mesh.obj"})
        std::ofstream(folder_ / name) << "text";
    const std::vector<fs::path> inputs{folder_ / "scene.toml", folder_ / "mesh.obj"};
    for (const fs::path& input : inputs)
        EXPECT_THROW(requireWritableFile(input, inputs), InputError) << input;
    EXPECT_NO_THROW(requireWritableFile(folder_ / "mesh.ply", inputs));
}

TEST_F(OutputFiles, OnlyOldResults_AreRemoved) {
    fs::create_directories(folder_ / "report");
    for (const char* name :
         {"results.json", "results.csv", "notes.txt", "report/index.html", "report/mine.html"})
        std::ofstream(folder_ / name) << "text";
    removeOldResults(folder_);
    for (const char* name : {"results.json", "results.csv", "report/index.html"})
        EXPECT_FALSE(fs::exists(folder_ / name)) << name;
    for (const char* name : {"notes.txt", "report/mine.html"})
        EXPECT_TRUE(fs::exists(folder_ / name)) << name;
    removeOldResults(folder_ / "nowhere"); // a missing folder is no error
}

TEST_F(OutputFiles, PathBelowFile_IsRefused) {
    std::ofstream(folder_ / "file") << "text";
    EXPECT_THROW(requireWritableFolder(folder_ / "file"), InputError);
    EXPECT_THROW(requireWritableFolder(folder_ / "file" / "below"), InputError);
    EXPECT_THROW(requireWritableFile(folder_ / "file" / "below.exr", {}), InputError);
    EXPECT_THROW(requireWritableFile(folder_, {}), InputError); // a folder instead of a file
}

TEST(SafeFileName, OddNames_StayReadableAndInside) {
    EXPECT_EQ(safeFileName("linear_binary@quadric"), "linear_binary-on-quadric");
    EXPECT_EQ(safeFileName("linear_binary:linear_steps=64"), "linear_binary_linear_steps=64");
    EXPECT_EQ(safeFileName("../../etc/passwd"), "_.._.._etc_passwd");
    EXPECT_EQ(safeFileName(""), "_");
    EXPECT_EQ(safeFileName(".."), "_..");
    EXPECT_EQ(safeFileName("a b\tc"), "a_b_c");
    EXPECT_EQ(safeFileName(std::string(500, 'x')).size(), 100u);
}

} // namespace
} // namespace plumbline
