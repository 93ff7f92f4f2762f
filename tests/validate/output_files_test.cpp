#include "../../scenes/error.h"
#include "../../validate/output_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <unistd.h>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("plumbline_output_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_;
};

TEST_F(OutputFiles, FoldersAreCreatedWithTheirParentsAndLeftEmpty) {
    requireWritableFolder(folder_ / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
    EXPECT_TRUE(fs::is_empty(folder_ / "a" / "b")); // the probe is gone
    requireWritableFile(folder_ / "c" / "frame.exr", "no input");
    EXPECT_FALSE(fs::exists(folder_ / "c" / "frame.exr"));
}

TEST_F(OutputFiles, APlaceBelowAFileIsRefused) {
    std::ofstream(folder_ / "file") << "text";
    EXPECT_THROW(requireWritableFolder(folder_ / "file"), InputError);
    EXPECT_THROW(requireWritableFolder(folder_ / "file" / "below"), InputError);
    EXPECT_THROW(requireWritableFile(folder_ / "file" / "below.exr", "no input"), InputError);
    EXPECT_THROW(requireWritableFile(folder_, "no input"), InputError); // a folder where a file should be
}

TEST(SafeFileName, KeepsNamesReadableAndInsideTheFolder) {
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
