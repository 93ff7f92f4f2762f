#include "scenes/core/data_folder.h"

#include "scenes/core/error.h"

#include <cstdlib>

namespace plumbline {

std::filesystem::path programFolder() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

std::filesystem::path dataFolder() {
    return chooseDataFolder(std::getenv("PLUMBLINE_DATA"), programFolder(), PLUMBLINE_SOURCE_DIR);
}

std::filesystem::path chooseDataFolder(const char* fromEnvironment, const std::filesystem::path& program,
                                       const std::filesystem::path& sourceTree) {
    const bool chosen = fromEnvironment && *fromEnvironment;
    const std::filesystem::path installed = program.parent_path() / "share" / "plumbline";
    std::error_code error;
    const bool isInstalled = !program.empty() && std::filesystem::is_directory(installed, error);
    std::filesystem::path folder = chosen ? fromEnvironment : isInstalled ? installed : sourceTree;
    for (const char* subfolder : {"scenes", "realtime", "validate"}) {
        if (!std::filesystem::is_directory(folder / subfolder, error))
            throw MachineError(folder.string(), std::string("has no folder '") + subfolder + "'",
                               "the folder with the scenes and techniques of the program",
                               chosen ? "PLUMBLINE_DATA names it" : "set PLUMBLINE_DATA to where it is now");
    }
    return folder;
}

} // namespace plumbline
