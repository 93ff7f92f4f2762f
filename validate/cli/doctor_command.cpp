#include "realtime/bake/bake_cache.h"
#include "realtime/gl/gl_probe.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "scenes/core/program_name.h"
#include "scenes/image/image_file.h"
#include "scenes/scene_file/scene_library.h"
#include "validate/cli/command.h"
#include "validate/cli/exit_codes.h"
#include "validate/report/page_bundle.h"

#include <fmt/format.h>

#include <thread>
#include <unistd.h>

namespace plumbline {
namespace {

void printLine(bool good, const std::string& what, const std::string& detail) {
    fmt::print("{:<4} {:<16} {}\n", good ? "ok" : "--", what, detail);
}

std::string memoryText() {
    const double bytes =
        static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
    return fmt::format("{:.1f} GB of memory", bytes / 1e9);
}

bool checkPictures() {
    try {
        printLine(true, "pictures", imageModuleFile().string());
        return true;
    } catch (const MachineError& error) {
        printLine(false, "pictures", error.what());
        return false;
    }
}

bool checkData() {
    try {
        printLine(true, "data",
                  fmt::format("{}, {} scenes in the library", dataFolder().string(), libraryScenes().size()));
        return true;
    } catch (const std::runtime_error& error) {
        printLine(false, "data", error.what());
        return false;
    }
}

/// Plain reports are no reason to fail.
void checkReportPage() {
    const std::string_view plain = report::plainReportReason();
    printLine(plain.empty(), "report", plain.empty() ? "interactive" : fmt::format("plain pages: {}", plain));
}

/// The folder, or where it doesn't exist yet the nearest one above it.
bool canBeWritten(std::filesystem::path folder) {
    std::error_code ignored;
    while (!std::filesystem::exists(folder, ignored) && folder.has_relative_path())
        folder = folder.parent_path();
    return std::filesystem::is_directory(folder, ignored) && ::access(folder.c_str(), W_OK | X_OK) == 0;
}

/// Never a reason to fail: without one maps are made each time.
void reportCache() {
    const std::optional<std::filesystem::path> folder = bakeCacheFolder();
    if (!folder) {
        printLine(false, "cache",
                  "none of PLUMBLINE_CACHE, XDG_CACHE_HOME and HOME is set: baked maps aren't kept");
        return;
    }
    if (!canBeWritten(*folder)) {
        printLine(false, "cache",
                  fmt::format("{} can't be written: baked maps aren't kept", folder->string()));
        return;
    }
    size_t maps = 0;
    uint64_t bytes = 0;
    std::error_code error;
    for (auto entry = std::filesystem::directory_iterator(*folder, error);
         !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        if (entry->path().extension() != ".bake") continue;
        std::error_code gone; // another process may be tidying up
        const uint64_t size = entry->file_size(gone);
        if (gone) continue;
        ++maps;
        bytes += size;
    }
    printLine(true, "cache",
              fmt::format("{}, {} baked maps, {:.1f} MB; may be deleted at any time", folder->string(), maps,
                          static_cast<double>(bytes) / 1e6));
}

bool checkTechniques() {
    try {
        std::string names;
        for (const Manifest& technique : listTechniques())
            names += (names.empty() ? "" : ", ") + technique.name;
        printLine(true, "techniques", names);
        return true;
    } catch (const std::runtime_error& error) {
        printLine(false, "techniques", error.what());
        return false;
    }
}

bool checkGl() {
    const std::vector<GlProbe> probes = probeGl();
    bool any = false;
    for (const GlProbe& probe : probes) {
        printLine(probe.works, "GL " + probe.backend, probe.detail);
        any = any || probe.works;
    }
    if (!any)
        printLine(
            false, "GL",
            probes.empty()
                ? "built without it (preset no-gl): no 'validate' and no 'realtime'"
                : "nothing works: no 'validate' and no 'realtime'; install libegl1 and libgl1-mesa-dri");
    return any;
}

int runDoctor() {
    printLine(true, "program", programName());
    printLine(true, "machine",
              fmt::format("{} threads, {}", std::thread::hardware_concurrency(), memoryText()));
    reportCache();
    checkReportPage();
    const bool pictures = checkPictures(), data = checkData(), techniques = checkTechniques(), gl = checkGl();
    return pictures && data && techniques && gl ? kExitDone : kExitMachine;
}

} // namespace

Command doctorCommand() {
    return {"doctor", "Report what this machine supports", [](CLI::App&) { return CommandRun(runDoctor); }};
}

} // namespace plumbline
