#include "scenes/core/error.h"
#include "scenes/core/replace_file.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

mode_t modeOf(const fs::path& file) {
    struct stat status {};
    EXPECT_EQ(::stat(file.c_str(), &status), 0) << file;
    return status.st_mode & 07777;
}

TEST(ReplaceFile, Failure_KeepsOldFileOnly) {
    const TemporaryFolder folder;
    replaceFile(folder / "a.txt", "old");
    EXPECT_THROW(replaceFile(folder / "a.txt",
                             [](OutputStream& stream) {
                                 stream.write("half");
                                 throw std::runtime_error("stop");
                             }),
                 std::runtime_error);
    EXPECT_EQ(readFile(folder / "a.txt"), "old");
    EXPECT_EQ(folder.fileCount(), 1u);
    replaceFile(folder / "a.txt", "new");
    EXPECT_EQ(readFile(folder / "a.txt"), "new");
    EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(ReplaceFile, SeekingWriter_ReplacesBytes) {
    const TemporaryFolder folder;
    const std::string large(200'000, 'x'); // larger than the stream's buffer
    replaceFile(folder / "a", [&](OutputStream& stream) {
        stream.write("0123");
        stream.write(large);
        EXPECT_EQ(stream.position(), 200'004u);
        stream.seek(1);
        stream.write("ab");
        EXPECT_EQ(stream.position(), 3u);
    });
    EXPECT_EQ(readFile(folder / "a"), "0ab3" + large);
}

TEST(ReplaceFile, FoldersAndDevices_AreRefused) {
    const TemporaryFolder folder;
    EXPECT_NE(inputErrorOf([&] { replaceFile(folder.path(), "x"); }).find("not a regular file"),
              std::string::npos);
    EXPECT_NE(inputErrorOf([&] { replaceFile("/dev/null", "x"); }).find("not a regular file"),
              std::string::npos);
    EXPECT_NE(inputErrorOf([&] { replaceFile(folder / "none" / "a", "x"); }).find("does not exist"),
              std::string::npos);
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_NE(inputErrorOf([&] { replaceFile(folder / "pipe", "x"); }).find("not a regular file"),
              std::string::npos);
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
    std::string message;
    try {
        replaceFile(folder / "a", std::string(100000, 'x'));
    } catch (const MachineError& error) {
        message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &old);
    EXPECT_NE(message.find("can't be written: File too large"), std::string::npos) << message;
    EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(ReplaceFile, Links_LeadToTheirTarget) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "real");
    writeFile(folder / "real/file", "old");
    fs::create_symlink("real/file", folder / "second");
    fs::create_symlink("second", folder / "first");
    replaceFile(folder / "first", "new");
    EXPECT_EQ(readFile(folder / "real/file"), "new");
    EXPECT_TRUE(fs::is_symlink(folder / "first"));
    EXPECT_TRUE(fs::is_symlink(folder / "second"));
    fs::create_symlink("real/made", folder / "dangling"); // a file that isn't there yet
    replaceFile(folder / "dangling", "made");
    EXPECT_EQ(readFile(folder / "real/made"), "made");
    fs::create_symlink("circle", folder / "circle");
    EXPECT_NE(inputErrorOf([&] { replaceFile(folder / "circle", "x"); }).find("symbolic links"),
              std::string::npos);
}

TEST(ReplaceFile, Mode_IsTheOldFilesOrTheUmasks) {
    const TemporaryFolder folder;
    const mode_t before = ::umask(027);
    replaceFile(folder / "new", "x");
    EXPECT_EQ(modeOf(folder / "new"), 0640u);
    for (const mode_t mode : {0600u, 0664u, 0755u, 0400u}) {
        ASSERT_EQ(::chmod((folder / "new").c_str(), mode), 0);
        replaceFile(folder / "new", "y");
        EXPECT_EQ(modeOf(folder / "new"), mode);
    }
    ::umask(before);
}

// 255 bytes are the longest name of common file systems.
TEST(ReplaceFile, LongestName_IsWritten) {
    const TemporaryFolder folder;
    const std::string name(255, 'n');
    replaceFile(folder / name, "x");
    EXPECT_EQ(readFile(folder / name), "x");
    EXPECT_NE(inputErrorOf([&] { replaceFile(folder / (name + "n"), "x"); }).find("File name too long"),
              std::string::npos);
}

TEST(ReplaceFile, LeftOverFiles_AreRemovedUnlessInUse) {
    const TemporaryFolder folder;
    writeFile(folder / ".plumbline-0123456789abcdef.tmp", "of a killed run");
    writeFile(folder / ".plumbline-0.lock", "");
    writeFile(folder / ".plumbline-1.tmp", "of a run at work");
    writeFile(folder / "a.tmp", "somebody's");
    fs::create_symlink("a.tmp", folder / ".plumbline-2.tmp"); // planted
    const int inUse = ::open((folder / ".plumbline-1.tmp").c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_EQ(::flock(inUse, LOCK_EX), 0);
    replaceFile(folder / "result", "x");
    EXPECT_FALSE(fs::exists(folder / ".plumbline-0123456789abcdef.tmp"));
    EXPECT_FALSE(fs::exists(folder / ".plumbline-0.lock"));
    EXPECT_TRUE(fs::exists(folder / ".plumbline-1.tmp"));
    EXPECT_EQ(readFile(folder / "a.tmp"), "somebody's");
    ::close(inUse);
}

} // namespace
} // namespace plumbline
