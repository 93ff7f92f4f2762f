// The settings every technique takes from the harness, beside its own and its surface's.
#pragma once

#include "realtime/technique/manifest.h"

#include <vector>

namespace plumbline {

/// `shadow` offers what both manifests allow, the first of them its default, and a map. Throws InputError
/// where they have nothing in common.
std::vector<Parameter> harnessParameters(const Manifest& search, const Manifest& surface);

/// The names of all of them.
std::vector<std::string> harnessParameterNames();

/// What a search or a surface can be drawn with: the manifest's, and a map, which asks nothing of either.
/// Empty for micro-triangles.
std::vector<std::string> offeredShadows(const Manifest& manifest);

} // namespace plumbline
