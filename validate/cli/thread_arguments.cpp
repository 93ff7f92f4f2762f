#include "validate/cli/thread_arguments.h"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <string>

namespace plumbline {

void ThreadArguments::addTo(CLI::App& command) {
    command.add_option("--threads", threads, "Threads of reference, bakes and llvmpipe (default: all)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
}

ThreadLimit::ThreadLimit(int threads) {
    if (threads == 0) return;
    control_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads));
    ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
}

} // namespace plumbline
