#include "scenes/core/error.h"
#include "scenes/core/replace_file.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/resource.h>
#include <vector>

namespace plumbline {
namespace {

TEST(Error, AllParts_AreInOrder) {
    EXPECT_STREQ(InputError("scene.toml:3: width", "is 0", "1 to 32768", "did you mean 1?").what(),
                 "scene.toml:3: width: is 0; expected 1 to 32768; did you mean 1?");
    EXPECT_STREQ(InputError("a.obj", "no such file").what(), "a.obj: no such file");
    EXPECT_STREQ(MachineError("", "no OpenGL").what(), "no OpenGL");
}

TEST(Error, QuotedNewlines_StayOneLine) {
    EXPECT_STREQ(InputError("a\nb", "c\rd\te").what(), "a b: c d e");
}

TEST(Error, Typo_FindsNearestName) {
    const std::vector<std::string> names{"repeat", "clamp", "torus"};
    EXPECT_EQ(didYouMean("repaet", names), "did you mean 'repeat'?"); // two letters swapped: distance 1
    EXPECT_EQ(didYouMean("Torus", names), "did you mean 'torus'?");   // capitals don't count
    EXPECT_EQ(didYouMean("clmp", names), "did you mean 'clamp'?");
    EXPECT_EQ(didYouMean("sphere", names), ""); // "repeat" is 5 edits away, more than a third
    EXPECT_EQ(didYouMean("x", names), "");
    EXPECT_EQ(didYouMean("", names), "");
    EXPECT_EQ(didYouMean("torus", {}), "");
    EXPECT_EQ(didYouMean(std::string(1 << 20, 'a'), names), ""); // no quadratic search for a huge name
}

TEST(Error, SeveralNames_AreListed) {
    EXPECT_EQ(listOf(std::vector<std::string>{"a", "b", "c"}), "a, b or c");
    EXPECT_EQ(listOf(std::vector<std::string>{"a"}), "a");
    EXPECT_EQ(listOf({}), "");
}

TEST(ReplaceFile, Failure_KeepsOldFileOnly) {
    const TemporaryFolder folder;
    replaceFile(folder / "a.txt", "old");
    EXPECT_THROW(replaceFile(folder / "a.txt",
                             [](const std::filesystem::path& temporary) {
                                 writeFile(temporary, "half");
                                 throw std::runtime_error("stop");
                             }),
                 std::runtime_error);
    EXPECT_EQ(readFile(folder / "a.txt"), "old");
    EXPECT_EQ(folder.fileCount(), 1u);
    replaceFile(folder / "a.txt", "new");
    EXPECT_EQ(readFile(folder / "a.txt"), "new");
    EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(ReplaceFile, FoldersAndDevices_AreRefused) {
    const TemporaryFolder folder;
    EXPECT_NE(inputErrorOf([&] { replaceFile(folder.path(), "x"); }).find("not a regular file"),
              std::string::npos);
    EXPECT_NE(inputErrorOf([&] { replaceFile("/dev/null", "x"); }).find("not a regular file"),
              std::string::npos);
    EXPECT_NE(inputErrorOf([&] { replaceFile(folder / "none" / "a", "x"); }).find("does not exist"),
              std::string::npos);
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(ReplaceFile, FullDisk_LeavesNothing) {
    const TemporaryFolder folder;
    // A file size limit simulates a full disk: write() fails halfway.
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = old;
    small.rlim_cur = 10000;
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = inputErrorOf([&] { replaceFile(folder / "a", std::string(100000, 'x')); });
    setrlimit(RLIMIT_FSIZE, &old);
    EXPECT_NE(message.find("can't be written"), std::string::npos) << message;
    EXPECT_EQ(folder.fileCount(), 0u);
}

} // namespace
} // namespace plumbline
