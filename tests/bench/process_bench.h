// Wall time and peak memory of whole processes.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

struct ProcessResult {
    int exitCode = -1;
    double wallSeconds = 0;   // median
    double peakMegabytes = 0; // median of the largest resident set
    int runs = 0;
};

/// Runs a command `runs` times after one warm-up and discards its output.
ProcessResult runProcess(const std::vector<std::string>& command, int runs);

} // namespace plumbline
