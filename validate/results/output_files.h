// Where results go, checked before any work is done. The files themselves are written by
// scenes/core/replace_file.h.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline {

/// Creates the folder with its parents and makes sure a file can be created in it. Throws InputError.
void requireWritableFolder(const std::filesystem::path& folder);
/// Likewise for the folder a file is to be written to; also throws if the file is a folder, or one of
/// `inputs`, which it would replace.
void requireWritableFile(const std::filesystem::path& file, const std::vector<std::filesystem::path>& inputs);

/// Results and report page of an earlier run in the folder: to be gone before the first file of a new one, so
/// that no stopped run can pass for whole. Throws InputError.
void removeOldResults(const std::filesystem::path& folder);

/// A technique's or light's name as part of a file name: letters, digits and -_=. stay, @ becomes "-on-",
/// every run of others one '_'; never empty, never hidden, at most 100 characters. Two names can become one.
std::string safeFileName(const std::string& name);

} // namespace plumbline
