#include "validate/cli/thread_arguments.h"

#include "scenes/core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace plumbline {

void ThreadArguments::addTo(CLI::App& command) {
    command.add_option("--threads", threads, "Threads of reference, bakes and llvmpipe (default: all)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
}

namespace {

/// Starts as many threads at once as TBB and OpenEXR will, and ends them again.
void requireThreads(unsigned count) {
    std::mutex untilAllRun;
    std::unique_lock hold(untilAllRun);
    std::vector<std::thread> started;
    bool failed = false;
    try {
        for (unsigned i = 0; i < count; ++i)
            started.emplace_back([&] { const std::lock_guard wait(untilAllRun); });
    } catch (const std::exception&) { // system_error or bad_alloc
        failed = true;
    }
    const size_t possible = started.size();
    hold.unlock();
    for (std::thread& thread : started)
        thread.join();
    if (failed)
        throw MachineError("threads",
                           fmt::format("this process can start {} of the {} it needs", possible, count),
                           "a higher limit of processes (ulimit -u) or of memory (ulimit -v)");
}

} // namespace

ThreadLimit::ThreadLimit(int threads) {
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    requireThreads(cores + (threads == 0 ? cores : std::min(cores, static_cast<unsigned>(threads))));
    if (threads == 0) return;
    control_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads));
    ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
}

} // namespace plumbline
