// [[parameter]] of a manifest.
#pragma once

#include "realtime/technique/manifest.h"
#include "scenes/toml/toml_table.h"

namespace plumbline {

/// Every [[parameter]], in the manifest's order. Throws InputError.
std::vector<Parameter> readParameters(const TomlTable& manifest);

} // namespace plumbline
