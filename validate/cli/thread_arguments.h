// --threads.
#pragma once

#include <tbb/global_control.h>

#include <optional>

namespace CLI {
class App;
}

namespace plumbline {

struct ThreadArguments {
    int threads = 0; // 0: as many as the machine has

    void addTo(CLI::App& command);
};

/// Limits the threads of this program while it lives.
class ThreadLimit {
  public:
    /// 0: no limit. Before GL starts: llvmpipe reads its limit then. Throws MachineError if this process
    /// can't have as many threads: TBB ends the process where one of its threads can't start another.
    explicit ThreadLimit(int threads);

  private:
    std::optional<tbb::global_control> control_;
};

} // namespace plumbline
