#include "scenes/core/folder_handle.h"

#include "scenes/core/write_error.h"

#include <cerrno>
#include <cstdio>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace plumbline {
namespace {

constexpr std::string_view kBeginning = ".plumbline-";

struct CloseFolder {
    void operator()(DIR* folder) const { ::closedir(folder); }
};

/// Some file systems can't sync a folder, or don't need to.
bool isNoFailure(int error) {
    return error == EINVAL || error == ENOTSUP || error == ENOSYS || error == EACCES;
}

} // namespace

bool isRunsOwnFile(const std::filesystem::path& file) {
    return file.filename().string().starts_with(kBeginning);
}

void Descriptor::reset() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
}

// O_PATH: a folder may be writable and not readable.
FolderHandle::FolderHandle(const std::filesystem::path& folder, std::filesystem::path file)
    : file_(std::move(file)), folder_(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
    if (folder_.get() < 0) failWrite(file_, errno);
}

// O_NONBLOCK: somebody else may have put a pipe there.
Descriptor FolderHandle::open(const std::string& name, int flags, mode_t mode) const {
    constexpr int kAlways = O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK;
    return Descriptor(::openat(descriptor(), name.c_str(), flags | kAlways, mode));
}

bool FolderHandle::isStill(const std::string& name, const Descriptor& file) const {
    struct stat opened {
    }, named{};
    return ::fstat(file.get(), &opened) == 0 &&
           ::fstatat(descriptor(), name.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

void FolderHandle::remove(const std::string& name) const {
    ::unlinkat(descriptor(), name.c_str(), 0);
}

void FolderHandle::rename(const std::string& from, const std::string& to) const {
    if (::renameat(descriptor(), from.c_str(), descriptor(), to.c_str()) != 0) failWrite(file_, errno);
    const Descriptor readable = open(".", O_RDONLY | O_DIRECTORY);
    if ((readable.get() < 0 || ::fsync(readable.get()) != 0) && !isNoFailure(errno)) failWrite(file_, errno);
}

void FolderHandle::removeLeftOvers() const {
    // A second descriptor, which closedir() closes.
    const int list = ::openat(descriptor(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (list < 0) return; // can't be listed, though it may be written
    const std::unique_ptr<DIR, CloseFolder> entries(::fdopendir(list));
    if (!entries) {
        ::close(list);
        return;
    }
    while (const dirent* entry =
               ::readdir(entries.get())) { // NOLINT(concurrency-mt-unsafe): a DIR of its own
        const std::string name = entry->d_name;
        if (!isRunsOwnFile(name)) continue;
        const Descriptor file = open(name, O_RDWR);
        if (file.get() >= 0 && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0 && isStill(name, file))
            remove(name);
    }
}

} // namespace plumbline
