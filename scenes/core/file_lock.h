// Keeps other runs from what this one writes or rewrites.
#pragma once

#include "scenes/core/folder_handle.h"
#include "scenes/core/removed_at_signal.h"

#include <chrono>
#include <memory>
#include <optional>

namespace plumbline {

enum class LockKind { Exclusive, Shared };

/// The lock of a name in a folder: of one that has it exclusively, or of several that share it. Held until
/// this is destroyed or the process ends in any way. Two objects of one process exclude each other as well.
/// The lock is a file of its own (folder_handle.h) beside what it protects, which is replaced, and a lock on
/// a replaced file would be one on the old file.
class FileLock {
  public:
    /// nullopt if another still has it after `wait`. `name`: of any length. Throws as failWrite does, also if
    /// the file system has no locks.
    static std::optional<FileLock> acquire(const std::filesystem::path& folder, const std::string& name,
                                           LockKind kind = LockKind::Exclusive,
                                           std::chrono::milliseconds wait = {});
    ~FileLock();
    FileLock(FileLock&&) noexcept = default;
    FileLock& operator=(FileLock&&) = delete;

  private:
    FileLock(const std::filesystem::path& folder, const std::string& name, LockKind kind);
    bool tryLock();

    std::unique_ptr<FolderHandle> folder_; // null: moved from
    std::string name_;                     // of the lock's file
    LockKind kind_;
    Descriptor opened_;
    std::unique_ptr<RemovedAtSignal> removal_;
};

} // namespace plumbline
