// The settings every technique takes from the harness, beside its own and its surface's.
#pragma once

#include "realtime/technique/manifest.h"

#include <vector>

namespace plumbline {

/// `shadow` offers what both manifests allow, the first of them its default, and a map. Throws InputError
/// where they have nothing in common.
std::vector<Parameter> harnessParameters(const Manifest& search, const Manifest& surface);

} // namespace plumbline
