// The library's techniques and surfaces: the folders of realtime/techniques/ and realtime/surfaces/. Names
// are sorted; those that begin with '_' or '.' are left out.
#pragma once

#include "realtime/technique/manifest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline {

std::filesystem::path techniquesFolder();
std::filesystem::path surfacesFolder();
std::vector<std::string> techniqueNames();
std::vector<std::string> surfaceNames();

/// Folder of a search: a name of the library, or a path. Throws InputError that lists the names.
std::filesystem::path techniqueFolder(const std::string& search);
/// Folder of a surface of the library. Throws InputError that lists the names.
std::filesystem::path surfaceFolder(const std::string& surface);

/// The manifests of all of them. Throws InputError for one that can't be read.
std::vector<Manifest> listTechniques();
std::vector<Manifest> listSurfaces();

} // namespace plumbline
