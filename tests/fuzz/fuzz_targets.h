// What is fuzzed: each target reads a file of one kind, or messages, whose bytes may be anything.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace plumbline {

using FuzzInput = std::span<const uint8_t>;

struct FuzzTarget {
    std::string_view name; // also of its folder in tests/fuzz/corpus
    /// Throws InputError, MachineError or std::runtime_error for what can't be read.
    void (*read)(FuzzInput bytes);
};

std::span<const FuzzTarget> fuzzTargets();

/// Null if there is no such target.
const FuzzTarget* findFuzzTarget(std::string_view name);

} // namespace plumbline
