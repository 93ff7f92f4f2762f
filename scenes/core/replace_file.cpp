#include "scenes/core/replace_file.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <unistd.h>

namespace plumbline {
namespace {

void checkTarget(const std::filesystem::path& file) {
    std::error_code error;
    if (!file.has_filename()) throw InputError(file.string(), "is not a file name");
    const auto status = std::filesystem::status(file, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw InputError(file.string(), "exists and is not a regular file", "a file to write or to replace");
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder, error))
        throw InputError(file.string(), fmt::format("the folder '{}' does not exist", folder.string()));
}

/// Unique among processes and threads, so that two writers of the same file never share a temporary file.
std::filesystem::path temporaryBeside(const std::filesystem::path& file) {
    static std::atomic<unsigned> counter{0};
    auto name = file;
    name += fmt::format(".tmp-{}-{}", getpid(), counter++);
    return name;
}

} // namespace

void replaceFile(const std::filesystem::path& file,
                 const std::function<void(const std::filesystem::path& temporary)>& write) {
    checkTarget(file);
    const auto temporary = temporaryBeside(file);
    std::error_code ignored;
    try {
        write(temporary);
    } catch (...) {
        std::filesystem::remove(temporary, ignored);
        throw;
    }
    std::error_code error;
    std::filesystem::rename(temporary, file, error);
    if (!error) return;
    std::filesystem::remove(temporary, ignored);
    throw InputError(file.string(), "can't be written: " + error.message());
}

void replaceFile(const std::filesystem::path& file, std::string_view contents) {
    replaceFile(file, [&](const std::filesystem::path& temporary) {
        errno = 0;
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(contents.data(), static_cast<std::streamsize>(contents.size()));
        stream.close();
        if (!stream)
            throw InputError(file.string(), fmt::format("can't be written: {}", std::strerror(errno)));
    });
}

} // namespace plumbline
