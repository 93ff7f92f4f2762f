#include "scenes/core/read_file.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& what, std::string_view expected = {}) {
    throw InputError(file.string(), what, expected);
}

const char* kindOf(mode_t mode) {
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a pipe";
    if (S_ISSOCK(mode)) return "a socket";
    if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
    return "something else";
}

void requireRegular(const fs::path& file, const struct stat& status, std::string_view expected) {
    if (!S_ISREG(status.st_mode))
        refuse(file, fmt::format("is not a file, it is {}", kindOf(status.st_mode)),
               expected.empty() ? "a regular file" : expected);
}

/// Why a path can't be looked up or opened, from errno.
[[noreturn]] void refuseByErrno(const fs::path& file, std::string_view expected) {
    const int reason = errno;
    if (reason == ELOOP) refuse(file, "is a symbolic link that leads in a circle", expected);
    struct stat link {};
    if (reason == ENOENT && ::lstat(file.c_str(), &link) == 0 && S_ISLNK(link.st_mode))
        refuse(file, "is a symbolic link to something that doesn't exist", expected);
    if (reason == ENOENT || reason == ENOTDIR) refuse(file, "no such file", expected);
    refuse(file, fmt::format("can't be opened: {}", std::strerror(reason)));
}

int64_t modifiedNs(const struct stat& status) {
    return int64_t(status.st_mtim.tv_sec) * 1'000'000'000 + status.st_mtim.tv_nsec;
}

/// Looked at before it is opened, because opening a device may do something; and again when it is open,
/// because another file may have taken its place. O_NONBLOCK: a pipe that did isn't waited for.
int openRegular(const fs::path& file, struct stat& status, std::string_view expected) {
    if (file.native().find('\0') != std::string::npos) refuse(file, "is not a file name: it has a zero byte");
    if (::stat(file.c_str(), &status) != 0) refuseByErrno(file, expected);
    requireRegular(file, status, expected);
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0) refuseByErrno(file, expected);
    try {
        if (::fstat(descriptor, &status) != 0) refuseByErrno(file, expected);
        requireRegular(file, status, expected);
    } catch (...) {
        ::close(descriptor);
        throw;
    }
    return descriptor;
}

[[noreturn]] void refuseChanged(const fs::path& file) {
    refuse(file, "changed while it was read", "a file that no other program writes");
}

} // namespace

InputFile::InputFile(fs::path file, std::string_view expected)
    : path_(std::move(file)), stream_(nullptr, &std::fclose) {
    struct stat status {};
    const int descriptor = openRegular(path_, status, expected);
    stream_.reset(::fdopen(descriptor, "rb"));
    if (!stream_) {
        ::close(descriptor);
        refuse(path_, "can't be opened: no memory");
    }
    size_ = static_cast<uint64_t>(status.st_size);
    modifiedNs_ = modifiedNs(status);
}

void InputFile::moveTo(uint64_t position) {
    if (::fseeko(stream_.get(), static_cast<off_t>(position), SEEK_SET) != 0)
        refuse(path_, fmt::format("can't be read: {}", std::strerror(errno)));
    position_ = position;
}

size_t InputFile::read(std::span<char> bytes) {
    errno = 0;
    const size_t count = std::fread(bytes.data(), 1, bytes.size(), stream_.get());
    if (std::ferror(stream_.get())) refuse(path_, fmt::format("can't be read: {}", std::strerror(errno)));
    position_ += count;
    return count;
}

void InputFile::checkUnchanged() const {
    struct stat now {};
    if (::fstat(::fileno(stream_.get()), &now) != 0) refuseByErrno(path_, {});
    if (static_cast<uint64_t>(now.st_size) != size_ || modifiedNs(now) != modifiedNs_) refuseChanged(path_);
}

void requireInputFile(const fs::path& file, std::string_view expected) {
    InputFile{file, expected};
}

std::string readWholeFile(const fs::path& file, uint64_t mostBytes) {
    InputFile input(file);
    if (input.size() > mostBytes)
        refuse(file, fmt::format("is {} bytes long", input.size()), fmt::format("at most {}", mostBytes));
    std::string text(input.size(), '\0');
    // One byte more than the file should have: it may have grown, and files in /proc have a size of 0.
    char more = 0;
    if (input.read(text) != text.size() || input.read({&more, 1}) != 0) refuseChanged(file);
    input.checkUnchanged();
    if (text.empty()) refuse(file, "is empty");
    return text;
}

} // namespace plumbline
