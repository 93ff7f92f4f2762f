// Reads the [[parameter]] tables of a manifest.
#pragma once

#include "realtime/technique/manifest.h"
#include "scenes/toml/toml_table.h"

namespace plumbline {

/// All parameters in file order. Throws InputError.
std::vector<Parameter> readParameters(const TomlTable& manifest);

} // namespace plumbline
