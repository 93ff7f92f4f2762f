// Checks and claims the places of output files before any work is done. scenes/core/replace_file.h writes the
// files.
#pragma once

#include "scenes/core/file_lock.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline {

/// Every path that a person gives for output is checked by one of the first four. They throw InputError, or
/// MachineError for a full disk or a place where another run is at work.
///
/// Creates the folder with its parents and checks that a file can be created in it.
void requireWritableFolder(const std::filesystem::path& folder);
/// The same for the folder of a file that will be written. Also throws if it can't be replaced by a file, or
/// if it is one of `inputs`, which would be overwritten.
void requireWritableFile(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs);
/// The same, and no other run can claim the folder, a file in it, or this file until the claim is destroyed:
/// results of two runs aren't mixed. Several may claim different files of a folder.
[[nodiscard]] FileLock claimFolder(const std::filesystem::path& folder);
struct FileClaim {
    FileLock folder, file;
};
[[nodiscard]] FileClaim claimFile(const std::filesystem::path& file,
                                  const std::vector<std::filesystem::path>& inputs);

/// Removes results and report page of an earlier run from the folder. Called before a run writes its first
/// file, so that an interrupted run isn't mistaken for a complete one. Throws InputError.
void removeOldResults(const std::filesystem::path& folder);

/// A technique's or light's name as part of a file name: letters, digits and -_=. are kept, @ becomes "-on-",
/// each sequence of other characters '_'. Never empty, never hidden, at most 100 characters. Different names
/// may give the same result.
std::string safeFileName(const std::string& name);

} // namespace plumbline
