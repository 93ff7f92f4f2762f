// Memory available on this machine.
#pragma once

#include <cstdint>
#include <string_view>

namespace plumbline {

/// Bytes this process can allocate without swapping or being killed: the smaller of MemAvailable in
/// /proc/meminfo and what remains of its control group's limit (cgroup v2 or v1). 1 GiB if neither can be
/// read.
uint64_t freeMemoryBytes();

/// Throws MachineError naming `what` if `bytes` exceeds the free memory. Without this check, an
/// overcommitting kernel would grant the allocation and kill the program later.
void requireMemory(std::string_view what, double bytes);

} // namespace plumbline
