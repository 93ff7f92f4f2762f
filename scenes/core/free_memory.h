// Memory available on this machine.
#pragma once

#include <cstdint>
#include <string_view>

namespace plumbline {

/// Bytes this process can allocate without swapping, being killed or being refused: the smallest of
/// MemAvailable in /proc/meminfo, what remains of its control group's limit (cgroup v2 or v1), and what
/// remains of its own limits (ulimit -v and -d). 1 GiB if none can be read.
uint64_t freeMemoryBytes();

/// Throws MachineError naming `what` if `bytes` exceeds the free memory. Without this check, an
/// overcommitting kernel would grant the allocation and kill the program later, and libraries that are
/// refused one crash.
void requireMemory(std::string_view what, double bytes);

/// Throws MachineError if a limit of this process (ulimit -v) leaves less address space: libraries that are
/// refused some while they are loaded or start threads crash, or wait for threads that don't exist.
void requireAddressSpace(std::string_view what, double bytes);

} // namespace plumbline
