// Hashes the contents of a TOML tree.
#pragma once

#include "scenes/core/content_hash.h"
#include "scenes/toml/toml_tree.h"

namespace plumbline {

/// Implements TomlTable::addTo.
void addTree(ContentHash& hash, const TomlNode& root, std::string_view except);

} // namespace plumbline
