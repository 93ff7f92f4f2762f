// A file being written, before it has its name.
#pragma once

#include "scenes/core/folder_handle.h"
#include "scenes/core/removed_at_signal.h"

#include <optional>

namespace plumbline {

/// Created with a name that nobody can guess or have planted; removed in the destructor unless it was
/// renamed. The first one of this process in a folder also removes what killed runs left there.
class TemporaryFile {
  public:
    /// `file`: for errors. Throws as failWrite does.
    TemporaryFile(const std::filesystem::path& folder, const std::filesystem::path& file, mode_t mode);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int descriptor() const { return opened_.get(); }
    /// Gives it that name in its folder, in place of the file that had it. Contents and name are on the disk
    /// then: a power cut leaves the old file or the whole new one.
    void rename(const std::string& name);

  private:
    bool tryCreate(mode_t mode);

    FolderHandle folder_;
    std::string name_;
    Descriptor opened_;
    std::optional<RemovedAtSignal> removal_; // while it is there
};

} // namespace plumbline
