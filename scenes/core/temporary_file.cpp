#include "scenes/core/temporary_file.h"

#include "scenes/core/write_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <mutex>
#include <set>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <tuple>
#include <unistd.h>

namespace plumbline {
namespace {

std::string unguessableName() {
    uint64_t number = 0;
    if (::getrandom(&number, sizeof number, 0) != sizeof number) failWrite("/dev/urandom", errno);
    return fmt::format(".plumbline-{:016x}.tmp", number);
}

/// True once in a process for each folder: what is left over doesn't become more, and a folder may hold very
/// many files.
bool isFirstIn(const std::filesystem::path& name, const FolderHandle& folder) {
    static std::mutex mutex;
    static std::set<std::tuple<std::filesystem::path, dev_t, ino_t>> seen;
    struct stat status {};
    if (::fstat(folder.descriptor(), &status) != 0) return false;
    const std::lock_guard lock(mutex);
    return seen.emplace(name, status.st_dev, status.st_ino).second;
}

} // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& folder, const std::filesystem::path& file,
                             mode_t mode)
    : folder_(folder, file) {
    if (isFirstIn(folder, folder_)) folder_.removeLeftOvers();
    while (!tryCreate(mode)) {
    }
}

/// False if another process took it for one left over, before it was locked.
bool TemporaryFile::tryCreate(mode_t mode) {
    name_ = unguessableName();
    opened_ = folder_.open(name_, O_RDWR | O_CREAT | O_EXCL, mode);
    if (opened_.get() < 0) failWrite(folder_.file(), errno);
    removal_.emplace(folder_.descriptor(), name_);
    // Without locks on this file system nobody takes it for left over either.
    const bool taken = ::flock(opened_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!taken && folder_.isStill(name_, opened_)) return true;
    folder_.remove(name_);
    removal_.reset();
    return false;
}

TemporaryFile::~TemporaryFile() {
    if (removal_) folder_.remove(name_);
}

void TemporaryFile::rename(const std::string& name) {
    const bool synced = ::fsync(opened_.get()) == 0 || errno == EINVAL || errno == ENOTSUP;
    if (!synced) failWrite(folder_.file(), errno);
    folder_.rename(name_, name);
    removal_.reset();
}

} // namespace plumbline
