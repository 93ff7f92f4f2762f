// The library's techniques and surfaces: the subfolders of realtime/techniques/ and realtime/surfaces/. Names
// are sorted; those that begin with '_' or '.' are omitted.
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

/// An unknown name or folder, or a surface on which the technique doesn't run: an error in the request, not
/// in the technique.
class NoSuchTechnique : public InputError {
    using InputError::InputError;
};

/// The folder of a search, given by its name in the library or a path. Throws NoSuchTechnique that lists the
/// names.
std::filesystem::path techniqueFolder(const std::string& search);

/// The manifests of the whole library. Throws InputError for an invalid one.
std::vector<Manifest> listTechniques();
std::vector<Manifest> listSurfaces();

} // namespace plumbline
