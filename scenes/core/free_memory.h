// How much memory this machine has to spare.
#pragma once

#include <cstdint>
#include <string_view>

namespace plumbline {

/// Bytes a process can take without others being paged out or killed: MemAvailable of /proc/meminfo, and what
/// the control group it is in still has (cgroup v2 and v1). 1 GiB where neither can be read.
uint64_t freeMemoryBytes();

/// Throws MachineError naming `what` when `bytes` exceed what is free: the system would promise them and end
/// the program later.
void requireMemory(std::string_view what, double bytes);

} // namespace plumbline
