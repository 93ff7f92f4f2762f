// Opens the files that the program reads: the one way in for scenes, meshes, pictures, frames, shaders,
// results and cached maps, so that all of them are refused for the same reasons.
//
// An input is a regular file, or a symbolic link to one. Pipes, sockets, devices and folders are refused
// without opening them or waiting for a writer, so `-` and a pipe at /dev/stdin aren't inputs; `< file` at
// /dev/stdin is. A file must not change while it is read, and its size must be that of its contents, which
// isn't so for most files in /proc.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace plumbline {

// Largest sizes in bytes. Formats that are read in pieces (frames, pictures, baked maps) have none: what
// their headers claim is limited instead.
/// Meshes and results, which are kept in memory whole: an OBJ file of 2^30 bytes has about 20 million faces.
inline constexpr uint64_t kMostFileBytes = uint64_t(1) << 30;
/// TOML: a parsed text takes up to 80 times its size in memory, and seconds. A scene of 4096 objects has 1
/// MB.
inline constexpr uint64_t kMostTomlBytes = uint64_t(1) << 24;
/// The whole source of one shader, with the harness's parts. Shaders have kilobytes; of code as long as this
/// a compiler takes more than 10 s and half a gigabyte (Mesa 22.3), which the limit on drawing's time ends.
inline constexpr uint64_t kMostShaderBytes = uint64_t(1) << 22;

/// A file opened for reading, at its beginning. Closed when destroyed.
class InputFile {
  public:
    /// Throws InputError if the file is missing, not a regular file, or can't be opened.
    explicit InputFile(std::filesystem::path file, std::string_view expected = {});

    const std::filesystem::path& path() const { return path_; }
    /// As it was opened, in bytes.
    uint64_t size() const { return size_; }
    uint64_t position() const { return position_; }
    void moveTo(uint64_t position);
    /// The number of bytes read into the front of `bytes`; fewer than it has only at the end of the file.
    /// Throws InputError if the file can't be read.
    size_t read(std::span<char> bytes);
    /// Throws InputError if the file was written to since it was opened.
    void checkUnchanged() const;

  private:
    std::filesystem::path path_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
    uint64_t size_ = 0, position_ = 0;
    int64_t modifiedNs_ = 0; // since the epoch
};

/// For libraries that open files by their path. Throws InputError like InputFile; `expected`: what the path
/// should have been.
void requireInputFile(const std::filesystem::path& file, std::string_view expected = {});

/// Throws InputError like InputFile, and if the file is empty, longer than `mostBytes`, or changes while it
/// is read.
std::string readWholeFile(const std::filesystem::path& file, uint64_t mostBytes = kMostFileBytes);

} // namespace plumbline
