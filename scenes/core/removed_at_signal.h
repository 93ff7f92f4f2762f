// Files that a run has only while it works, removed when Ctrl-C or another signal ends it.
#pragma once

#include <string>

namespace plumbline {

/// Names a file to remove in a folder, until this is destroyed. SIGKILL can't be handled: the next run
/// removes what it leaves (folder_handle.h).
class RemovedAtSignal {
  public:
    /// `folder`: an open descriptor that outlives this. `shared`: the file's own, if others may have locked
    /// it too and it is to stay then; -1: nobody has.
    RemovedAtSignal(int folder, const std::string& name, int shared = -1);
    ~RemovedAtSignal();
    RemovedAtSignal(const RemovedAtSignal&) = delete;
    RemovedAtSignal& operator=(const RemovedAtSignal&) = delete;

  private:
    int slot_; // -1: all were taken, so that the next run removes it
};

} // namespace plumbline
