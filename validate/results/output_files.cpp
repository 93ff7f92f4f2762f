#include "validate/results/output_files.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <unistd.h>

namespace plumbline {
namespace {

void tryCreateFile(const std::filesystem::path& folder) {
    const std::filesystem::path probe = folder / fmt::format(".plumbline-probe-{}", ::getpid());
    const bool written = static_cast<bool>(std::ofstream(probe) << "probe" << std::flush);
    std::error_code ignored;
    std::filesystem::remove(probe, ignored);
    if (!written)
        throw InputError(folder.string(), "no file can be written here", "a folder with write permission");
}

} // namespace

void requireWritableFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw InputError(folder.string(),
                         "the folder can't be created" + (error ? fmt::format(" ({})", error.message()) : ""),
                         "a folder for results, given with -o");
    tryCreateFile(folder);
}

void requireWritableFile(const std::filesystem::path& file,
                         const std::vector<std::filesystem::path>& inputs) {
    std::error_code ignored;
    for (const std::filesystem::path& input : inputs)
        if (std::filesystem::equivalent(file, input, ignored))
            throw InputError(file.string(), "this file is an input and would be overwritten",
                             "another file for the result");
    if (std::filesystem::is_directory(file, ignored) || !file.has_filename())
        throw InputError(file.string(), "this is a folder", "the name of a file");
    requireWritableFolder(file.has_parent_path() ? file.parent_path() : std::filesystem::path("."));
}

void removeOldResults(const std::filesystem::path& folder) {
    for (const char* name : {"results.json", "results.csv", "report/index.html"}) {
        std::error_code error;
        std::filesystem::remove(folder / name, error);
        if (error)
            throw InputError((folder / name).string(), "can't be removed", "a file that may be replaced");
    }
}

std::string safeFileName(const std::string& name) {
    constexpr size_t kLongest = 100; // leaves space for a suffix in the 255 bytes of common file systems
    std::string result;
    for (const char c : name) {
        const bool keep = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                          std::string_view("-_=.").find(c) != std::string_view::npos;
        if (keep)
            result += c;
        else if (c == '@') // oiiotool and similar tools read it as a frame number
            result += "-on-";
        else if (result.empty() || result.back() != '_')
            result += '_';
    }
    result = result.substr(0, kLongest);
    if (result.empty() || result[0] == '.') result.insert(0, "_");
    return result;
}

} // namespace plumbline
