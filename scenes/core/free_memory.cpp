#include "scenes/core/free_memory.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

namespace plumbline {

namespace {

std::optional<uint64_t> readNumber(const char* file) {
    std::ifstream stream(file);
    uint64_t number = 0;
    if (stream >> number) return number;
    return std::nullopt; // "max", or no such file
}

std::optional<uint64_t> availableBytes() {
    std::ifstream stream("/proc/meminfo");
    std::string key, unit;
    uint64_t kilobytes = 0;
    while (stream >> key >> kilobytes) {
        std::getline(stream, unit);
        if (key == "MemAvailable:") return kilobytes * 1024;
    }
    return std::nullopt;
}

/// Bytes left below a limit; nothing if there is no limit.
std::optional<uint64_t> leftUnder(const char* limitFile, const char* usageFile) {
    const auto limit = readNumber(limitFile), usage = readNumber(usageFile);
    if (!limit || !usage) return std::nullopt;
    return *limit > *usage ? *limit - *usage : 0;
}

} // namespace

uint64_t freeMemoryBytes() {
    std::optional<uint64_t> free = availableBytes();
    for (const auto& left : {leftUnder("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"),
                             leftUnder("/sys/fs/cgroup/memory/memory.limit_in_bytes",
                                       "/sys/fs/cgroup/memory/memory.usage_in_bytes")})
        if (left) free = std::min(free.value_or(*left), *left);
    constexpr uint64_t kUnknown = uint64_t(1) << 30;
    return free.value_or(kUnknown);
}

void requireMemory(std::string_view what, double bytes) {
    const auto free = static_cast<double>(freeMemoryBytes());
    if (bytes > free)
        throw MachineError(
            "memory", fmt::format("{} needs {:.1f} GB, {:.1f} GB are free", what, bytes / 1e9, free / 1e9));
}

} // namespace plumbline
