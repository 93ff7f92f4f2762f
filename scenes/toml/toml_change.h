// Other values put into a TOML tree that was read.
#pragma once

#include "scenes/toml/toml_tree.h"

namespace plumbline {

/// TomlTable::change.
void changeField(std::shared_ptr<TomlNode> root, const std::string& where, const std::string& path,
                 const std::string& value);

} // namespace plumbline
