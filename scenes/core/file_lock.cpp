#include "scenes/core/file_lock.h"

#include "scenes/core/content_hash.h"
#include "scenes/core/write_error.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>

namespace plumbline {
namespace {

constexpr std::chrono::milliseconds kPollInterval(10);
/// A process that looks for files left over locks each for a moment, which isn't another run's lock.
constexpr std::chrono::milliseconds kShortestWait(200);

/// As long for the longest names.
std::string lockName(const std::string& name) {
    ContentHash hash;
    hash.add(name);
    return ".plumbline-" + hash.hexadecimal() + ".lock";
}

/// Opens the file, or creates it: never both in one call, which Linux refuses for another user's file in a
/// folder that everybody may write to (fs.protected_regular). Of one that can't be written a lock can be had
/// on local file systems.
Descriptor openLock(const FolderHandle& folder, const std::string& name) {
    for (;;) {
        Descriptor opened = folder.open(name, O_RDWR);
        if (opened.get() < 0 && errno == EACCES) opened = folder.open(name, O_RDONLY);
        if (opened.get() >= 0) return opened;
        if (errno != ENOENT) failWrite(folder.file(), errno);
        opened = folder.open(name, O_RDWR | O_CREAT | O_EXCL, 0666);
        if (opened.get() >= 0) return opened;
        if (errno != EEXIST) failWrite(folder.file(), errno);
    }
}

} // namespace

FileLock::FileLock(const std::filesystem::path& folder, const std::string& name, LockKind kind)
    : folder_(std::make_unique<FolderHandle>(folder, folder / name)), name_(lockName(name)), kind_(kind) {}

/// Whoever has the lock removes its file, so that one just locked may not be the one of that name any more.
bool FileLock::tryLock() {
    for (;;) {
        opened_ = openLock(*folder_, name_);
        if (::flock(opened_.get(), (kind_ == LockKind::Shared ? LOCK_SH : LOCK_EX) | LOCK_NB) != 0) {
            if (errno == EINTR) continue;
            if (errno != EWOULDBLOCK) failWrite(folder_->file(), errno);
            return false;
        }
        if (folder_->isStill(name_, opened_)) return true;
    }
}

std::optional<FileLock> FileLock::acquire(const std::filesystem::path& folder, const std::string& name,
                                          LockKind kind, std::chrono::milliseconds wait) {
    const auto end = std::chrono::steady_clock::now() + std::max(wait, kShortestWait);
    FileLock lock(folder, name, kind);
    while (!lock.tryLock()) {
        if (std::chrono::steady_clock::now() >= end) {
            lock.folder_.reset(); // the other's file stays
            return std::nullopt;
        }
        std::this_thread::sleep_for(kPollInterval);
    }
    const int shared = kind == LockKind::Shared ? lock.opened_.get() : -1;
    lock.removal_ = std::make_unique<RemovedAtSignal>(lock.folder_->descriptor(), lock.name_, shared);
    return lock;
}

FileLock::~FileLock() {
    removal_.reset();
    if (!folder_) return;
    // The last one that shares it removes it.
    if (kind_ == LockKind::Exclusive ||
        (::flock(opened_.get(), LOCK_EX | LOCK_NB) == 0 && folder_->isStill(name_, opened_)))
        folder_->remove(name_);
}

} // namespace plumbline
