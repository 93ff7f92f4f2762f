// The stages of the reference, one by one, under Google Benchmark.
#pragma once

#include <map>
#include <string>

namespace plumbline {

/// Median figures of one benchmark.
struct StageResult {
    double realMs = 0;
    double itemsPerSecond = 0; // micro-triangles, or rays
    double ofBare = 0; // speed as a share of the bare library's, measured in turn; 0: nothing to compare with
};

/// Registers the stages for Google Benchmark, on the library scene `stone_torus`.
void registerStageBenchmarks();

/// Runs what is registered, prints Google Benchmark's table, and returns the medians by name ("trace/128").
std::map<std::string, StageResult> runStageBenchmarks();

} // namespace plumbline
