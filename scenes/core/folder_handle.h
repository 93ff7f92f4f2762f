// A folder held open, and the files that a run has in it only while it works: temporary files and locks. They
// begin with ".plumbline-" and carry flock(2)'s lock of the process that uses them. The kernel releases that
// however the process ends, and a network file system passes it on to other hosts, so that an unlocked one is
// known to be left over: no process id, which may be that of another process by now, says it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <utility>

namespace plumbline {

/// Whether a file of that name belongs to a run and isn't a result.
bool isRunsOwnFile(const std::filesystem::path& file);

/// Owns an open descriptor; -1: none.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { reset(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    int get() const { return number_; }
    void reset();

  private:
    int number_;
};

class FolderHandle {
  public:
    /// `file`: for errors. Throws as failWrite does.
    FolderHandle(const std::filesystem::path& folder, std::filesystem::path file);

    /// openat(2) without following a link, nullopt-like for failures: the descriptor is -1 and errno says
    /// why.
    Descriptor open(const std::string& name, int flags, mode_t mode = 0) const;
    /// Whether `name` still is the file of the descriptor: its owner may have removed it meanwhile.
    bool isStill(const std::string& name, const Descriptor& file) const;
    void remove(const std::string& name) const;
    /// Renames within the folder, and makes sure that the new name survives a power cut.
    void rename(const std::string& from, const std::string& to) const;
    /// Removes what runs that were killed left here.
    void removeLeftOvers() const;

    const std::filesystem::path& file() const { return file_; } // for errors
    int descriptor() const { return folder_.get(); }

  private:
    std::filesystem::path file_;
    Descriptor folder_;
};

} // namespace plumbline
