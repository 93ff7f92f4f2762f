// Everything that a path may lead to besides a file. None of it may be waited for: a test that blocks is
// ended by its alarm.
#include "scenes/core/content_hash.h"
#include "scenes/core/read_file.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <array>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ReadFile : public testing::Test {
  protected:
    ReadFile() { ::alarm(60); }
    ~ReadFile() override { ::alarm(0); }

    static void expectRefused(const fs::path& file, const std::string& part) {
        EXPECT_THAT(inputErrorOf([&] { readWholeFile(file); }), HasSubstr(part));
        EXPECT_THAT(inputErrorOf([&] { requireInputFile(file); }), HasSubstr(part));
        EXPECT_THAT(inputErrorOf([&] { ContentHash().addFile(file); }), HasSubstr(part));
    }

    TemporaryFolder folder_;
};

TEST_F(ReadFile, RegularFilesAndLinksToThem_AreRead) {
    const std::string bytes("a\0\n\xff", 4);
    writeFile(folder_ / "a", bytes);
    fs::create_symlink(folder_ / "a", folder_ / "link");
    EXPECT_EQ(readWholeFile(folder_ / "a"), bytes);
    EXPECT_EQ(readWholeFile(folder_ / "link"), bytes);
}

TEST_F(ReadFile, AnythingElse_IsRefusedAtOnce) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    fs::create_symlink(folder_ / "pipe", folder_ / "link to pipe");
    fs::create_symlink(folder_ / "nothing", folder_ / "dangling");
    fs::create_symlink(folder_ / "circle b", folder_ / "circle a");
    fs::create_symlink(folder_ / "circle a", folder_ / "circle b");
    writeFile(folder_ / "file", "x");

    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string socketName = (folder_ / "socket").string();
    ASSERT_LT(socketName.size(), sizeof address.sun_path);
    socketName.copy(address.sun_path, socketName.size());
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);

    expectRefused(folder_ / "pipe", "is not a file, it is a pipe; expected a regular file");
    expectRefused(folder_ / "link to pipe", "is not a file, it is a pipe");
    expectRefused(folder_ / "socket", "is not a file, it is a socket");
    expectRefused("/dev/zero", "is not a file, it is a device");
    expectRefused(folder_.path(), "is not a file, it is a folder");
    expectRefused(folder_ / "dangling", "is a symbolic link to something that doesn't exist");
    expectRefused(folder_ / "circle a", "is a symbolic link that leads in a circle");
    expectRefused(folder_ / "none", "none: no such file");
    expectRefused(folder_ / "file/below", "no such file");
    expectRefused(folder_ / std::string(300, 'x'), "can't be opened: File name too long");
    expectRefused(folder_ / std::string("file\0.toml", 10), "is not a file name: it has a zero byte");
    ::close(socket);
}

TEST_F(ReadFile, EmptyAndTooLongFiles_AreRefused) {
    writeFile(folder_ / "empty", "");
    writeFile(folder_ / "five", "12345");
    EXPECT_THAT(inputErrorOf([&] { readWholeFile(folder_ / "empty"); }), HasSubstr("is empty"));
    EXPECT_EQ(readWholeFile(folder_ / "five", 5), "12345");
    EXPECT_THAT(inputErrorOf([&] { readWholeFile(folder_ / "five", 4); }),
                HasSubstr("is 5 bytes long; expected at most 4"));
}

TEST_F(ReadFile, FileThatChanges_IsRefused) {
    writeFile(folder_ / "a", "12345");
    InputFile grown(folder_ / "a");
    std::array<char, 9> bytes{};
    EXPECT_EQ(grown.read(std::span(bytes).first(2)), 2u);
    EXPECT_EQ(grown.position(), 2u);
    EXPECT_NO_THROW(grown.checkUnchanged());
    writeFile(folder_ / "a", "123456");
    EXPECT_THAT(inputErrorOf([&] { grown.checkUnchanged(); }), HasSubstr("changed while it was read"));
    // Its size is 0 until it is read.
    EXPECT_THAT(inputErrorOf([] { readWholeFile("/proc/self/status"); }),
                HasSubstr("changed while it was read; expected a file that no other program writes"));
}

TEST_F(ReadFile, Positions_AreThoseAskedFor) {
    writeFile(folder_ / "a", "12345");
    InputFile input(folder_ / "a");
    std::array<char, 9> bytes{};
    input.moveTo(3);
    EXPECT_EQ(input.read(bytes), 2u);
    EXPECT_EQ(std::string(bytes.data(), 2), "45");
    EXPECT_EQ(input.position(), input.size());
    input.moveTo(0);
    EXPECT_EQ(input.read(std::span(bytes).first(1)), 1u);
    EXPECT_EQ(bytes[0], '1');
}

} // namespace
} // namespace plumbline
