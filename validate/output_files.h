// Where results go, checked before any work is done. The files themselves are written by
// scenes/replace_file.h.
#pragma once

#include <filesystem>
#include <string>

namespace plumbline {

/// Creates the folder with its parents and makes sure a file can be created in it. Throws InputError.
void requireWritableFolder(const std::filesystem::path& folder);
/// Likewise for the folder a file is to be written to; also throws if the file is a folder, or `input`, which it would replace.
void requireWritableFile(const std::filesystem::path& file, const std::filesystem::path& input);

/// A technique's or light's name as part of a file name: letters, digits and -_=. stay, @ becomes "-on-", every run of
/// others one '_'; never empty, never hidden, at most 100 characters. Two names can become one.
std::string safeFileName(const std::string& name);

} // namespace plumbline
