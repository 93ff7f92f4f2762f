#include "validate/results/output_files.h"

#include "scenes/core/error.h"
#include "scenes/core/replace_file.h"
#include "scenes/core/temporary_file.h"
#include "scenes/core/write_error.h"

#include <fmt/format.h>

#include <cctype>

namespace plumbline {
namespace {

/// What no path of output may be, file or folder.
void requireName(const std::filesystem::path& path, const char* expected) {
    if (path.empty()) throw InputError("the name for results", "is empty", expected);
    if (path == "-")
        throw InputError("-", "is no place for results: they aren't written to stdout", expected,
                         "'./-' is a file or folder of that name");
    if (path.native().find('\0') != std::string::npos)
        throw InputError(path.string(), "contains a NUL character", expected);
}

/// Also one of which only the name differs.
void requireNoInput(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs) {
    std::error_code ignored;
    for (const std::filesystem::path& input : inputs)
        if (std::filesystem::equivalent(file, input, ignored))
            throw InputError(file.string(), "this file is an input and would be overwritten",
                             "another file for the result");
}

/// The lock of a folder is one of an empty name in it.
FileLock claim(const std::filesystem::path& folder, const std::string& name, LockKind kind,
               const std::filesystem::path& given) {
    std::optional<FileLock> lock = FileLock::acquire(folder, name, kind);
    if (!lock)
        throw MachineError(given.string(), "another run of plumbline is writing here",
                           "one run at a time, or another place given with -o");
    return std::move(*lock);
}

} // namespace

void requireWritableFolder(const std::filesystem::path& folder) {
    constexpr const char* kExpected = "a folder for results, given with -o";
    requireName(folder, kExpected);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
        throw InputError(folder.string(),
                         "the folder can't be created" + (error ? fmt::format(" ({})", error.message()) : ""),
                         kExpected);
    const TemporaryFile probe(folder, folder, 0600);
    OutputStream stream(probe.descriptor(), folder);
    stream.write("a full disk refuses this");
    stream.flush();
}

void requireWritableFile(const std::filesystem::path& file,
                         const std::vector<std::filesystem::path>& inputs) {
    requireName(file, "the name of a file");
    requireNoInput(file, inputs);
    const std::filesystem::path target = linkTarget(file);
    std::error_code error;
    std::filesystem::file_status status = std::filesystem::symlink_status(target, error);
    if (std::filesystem::is_directory(status) || !target.has_filename())
        throw InputError(file.string(), "this is a folder", "the name of a file");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw InputError(file.string(), "exists and is not a regular file", "a file to write or to replace");
    requireWritableFolder(folderOf(target));
    // A name that the file system refuses in a folder that it has: too long, for example.
    status = std::filesystem::symlink_status(target, error);
    if (error && error != std::errc::no_such_file_or_directory) failWrite(file, error.value());
}

FileLock claimFolder(const std::filesystem::path& folder) {
    requireWritableFolder(folder);
    return claim(folder, "", LockKind::Exclusive, folder);
}

FileClaim claimFile(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs) {
    requireWritableFile(file, inputs);
    const std::filesystem::path target = linkTarget(file);
    return {claim(folderOf(target), "", LockKind::Shared, file),
            claim(folderOf(target), target.filename().string(), LockKind::Exclusive, file)};
}

void removeOldResults(const std::filesystem::path& folder) {
    for (const char* name : {"results.json", "results.csv", "report/index.html"}) {
        std::error_code error;
        std::filesystem::remove(linkTarget(folder / name), error); // a link stays, as when it is replaced
        if (error)
            throw InputError((folder / name).string(), fmt::format("can't be removed ({})", error.message()),
                             "a file that may be replaced");
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
