#include "scenes/core/replace_file.h"

#include "scenes/core/error.h"
#include "scenes/core/temporary_file.h"
#include "scenes/core/write_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace plumbline {
namespace {

/// What is there already, if anything; `target`: no link.
std::optional<struct stat> statusOf(const std::filesystem::path& file, const std::filesystem::path& target) {
    if (!target.has_filename()) throw InputError(file.string(), "is not a file name");
    std::error_code ignored;
    if (!std::filesystem::is_directory(folderOf(target), ignored))
        throw InputError(file.string(),
                         fmt::format("the folder '{}' does not exist", folderOf(target).string()));
    struct stat status {};
    if (::lstat(target.c_str(), &status) != 0) {
        if (errno != ENOENT) failWrite(file, errno);
        return std::nullopt;
    }
    if (!S_ISREG(status.st_mode))
        throw InputError(file.string(), "exists and is not a regular file", "a file to write or to replace");
    return status;
}

/// What the old file's group might do is no more than what everybody might, where the new one has another.
void keepOwnerAndMode(int descriptor, const struct stat& old) {
    const bool owned = ::fchown(descriptor, old.st_uid, old.st_gid) == 0 ||
                       ::fchown(descriptor, static_cast<uid_t>(-1), old.st_gid) == 0;
    mode_t mode = old.st_mode & 0777;
    if (!owned) mode = (mode & ~mode_t(070)) | (mode & (mode << 3) & mode_t(070));
    (void)::fchmod(descriptor, mode); // some file systems have no modes
}

} // namespace

std::filesystem::path folderOf(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::filesystem::path linkTarget(const std::filesystem::path& file) {
    constexpr int kMostLinks = 40; // as Linux
    std::filesystem::path target = file;
    std::error_code ignored;
    for (int links = 0; std::filesystem::is_symlink(target, ignored); ++links) {
        if (links == kMostLinks) failWrite(file, ELOOP);
        const std::filesystem::path next = std::filesystem::read_symlink(target, ignored);
        target = folderOf(target) / next; // `next` alone if it is absolute
    }
    return target;
}

void replaceFile(const std::filesystem::path& file, const std::function<void(OutputStream& stream)>& write) {
    const std::filesystem::path target = linkTarget(file);
    const std::optional<struct stat> old = statusOf(file, target);
    // One that replaces a private file is private from the beginning.
    TemporaryFile temporary(folderOf(target), file, old ? 0600 : 0666);
    OutputStream stream(temporary.descriptor(), file);
    write(stream);
    stream.flush();
    if (old) keepOwnerAndMode(temporary.descriptor(), *old);
    temporary.rename(target.filename());
}

void replaceFile(const std::filesystem::path& file, std::string_view contents) {
    replaceFile(file, [&](OutputStream& stream) { stream.write(contents); });
}

} // namespace plumbline
