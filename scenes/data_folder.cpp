#include "data_folder.h"

#include "error.h"

#include <cstdlib>

namespace plumbline {

std::filesystem::path dataFolder() {
    const char* fromEnvironment = std::getenv("PLUMBLINE_DATA");
    const bool chosen = fromEnvironment && *fromEnvironment;
    const std::filesystem::path folder = chosen ? fromEnvironment : PLUMBLINE_SOURCE_DIR;
    for (const char* subfolder : {"scenes", "realtime", "validate"}) {
        std::error_code error;
        if (!std::filesystem::is_directory(folder / subfolder, error))
            throw MachineError(folder.string(), std::string("has no folder '") + subfolder + "'",
                               "the folder with the scenes and techniques of the program",
                               chosen ? "PLUMBLINE_DATA names it" : "set PLUMBLINE_DATA to where it is now");
    }
    return folder;
}

} // namespace plumbline
