// Overrides values in a parsed TOML tree.
#pragma once

#include "scenes/toml/toml_tree.h"

namespace plumbline {

/// Implements TomlTable::change.
void changeField(std::shared_ptr<TomlNode> root, const std::string& where, const std::string& path,
                 const std::string& value);

} // namespace plumbline
