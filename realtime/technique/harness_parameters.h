// The harness's settings of a technique, in addition to its own and its surface's parameters.
#pragma once

#include "realtime/technique/manifest.h"

#include <vector>

namespace plumbline {

/// The choices of `shadow` are those allowed by both manifests, with the first as the default, and a shadow
/// map. Throws InputError if the manifests have none in common.
std::vector<Parameter> harnessParameters(const Manifest& search, const Manifest& surface);

/// The names of all of them.
std::vector<std::string> harnessParameterNames();

/// The shadows available for a search or a surface: those of the manifest and a shadow map, which has no
/// requirements. Empty for micro-triangles.
std::vector<std::string> offeredShadows(const Manifest& manifest);

} // namespace plumbline
