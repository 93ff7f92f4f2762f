#include "scenes/core/free_memory.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

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

/// The field of /proc/self/statm, pages: 0 address space, 5 data and stack.
std::optional<uint64_t> ownBytes(int field) {
    std::ifstream stream("/proc/self/statm");
    uint64_t pages = 0;
    for (int i = 0; i <= field; ++i)
        stream >> pages;
    if (!stream) return std::nullopt;
    return pages * static_cast<uint64_t>(::sysconf(_SC_PAGESIZE));
}

std::optional<uint64_t> leftUnder(__rlimit_resource_t resource, int statmField) {
    rlimit limit{};
    if (::getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
    const uint64_t used = ownBytes(statmField).value_or(0);
    return limit.rlim_cur > used ? limit.rlim_cur - used : 0;
}

std::string sizeText(double bytes) {
    return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

} // namespace

uint64_t freeMemoryBytes() {
    std::optional<uint64_t> free = availableBytes();
    for (const auto& left : {leftUnder("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"),
                             leftUnder("/sys/fs/cgroup/memory/memory.limit_in_bytes",
                                       "/sys/fs/cgroup/memory/memory.usage_in_bytes"),
                             leftUnder(RLIMIT_AS, 0), leftUnder(RLIMIT_DATA, 5)})
        if (left) free = std::min(free.value_or(*left), *left);
    constexpr uint64_t kUnknown = uint64_t(1) << 30;
    return free.value_or(kUnknown);
}

void requireMemory(std::string_view what, double bytes) {
    const auto free = static_cast<double>(freeMemoryBytes());
    if (bytes > free)
        throw MachineError("memory",
                           fmt::format("{} needs {}, {} are free", what, sizeText(bytes), sizeText(free)));
}

void requireAddressSpace(std::string_view what, double bytes) {
    const std::optional<uint64_t> left = leftUnder(RLIMIT_AS, 0);
    if (left && bytes > static_cast<double>(*left))
        throw MachineError("memory",
                           fmt::format("{} takes {} of address space, the limit leaves {}", what,
                                       sizeText(bytes), sizeText(static_cast<double>(*left))),
                           "a higher limit (ulimit -v)");
}

} // namespace plumbline
