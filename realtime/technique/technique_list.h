// The library's techniques and surfaces: the folders of realtime/techniques/ and realtime/surfaces/. Names
// are sorted; those that begin with '_' or '.' are left out.
#pragma once

#include "realtime/technique/manifest.h"
#include "scenes/core/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline {

std::filesystem::path techniquesFolder();
std::filesystem::path surfacesFolder();
std::vector<std::string> techniqueNames();
std::vector<std::string> surfaceNames();

/// A name or folder that isn't there, or a surface the technique doesn't run on: an error of who asks, not of
/// the technique.
class NoSuchTechnique : public InputError {
    using InputError::InputError;
};

/// Folder of a search: a name of the library, or a path. Throws NoSuchTechnique that lists the names.
std::filesystem::path techniqueFolder(const std::string& search);

/// The manifests of all of them. Throws InputError for one that can't be read.
std::vector<Manifest> listTechniques();
std::vector<Manifest> listSurfaces();

} // namespace plumbline
