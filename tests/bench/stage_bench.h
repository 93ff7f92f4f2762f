// Benchmarks the stages of the reference with Google Benchmark.
#pragma once

#include <map>
#include <string>

namespace plumbline {

/// Median figures of one benchmark.
struct StageResult {
    double realMs = 0;
    double itemsPerSecond = 0; // micro-triangles, or rays
    double ofBare = 0;         // speed relative to the bare library, measured alternately; 0: no comparison
};

/// Registers the stages for Google Benchmark, on the library scene `stone_torus`.
void registerStageBenchmarks();

/// Runs the registered benchmarks, prints Google Benchmark's table, and returns the medians by name
/// ("trace/128").
std::map<std::string, StageResult> runStageBenchmarks();

} // namespace plumbline
