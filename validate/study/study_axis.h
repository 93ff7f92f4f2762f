// Reads the axes of a study and their values.
#pragma once

#include "scenes/toml/toml_table.h"
#include "validate/study/study.h"

namespace plumbline {

/// Reads `[[grid.axis]]`: `field` or `fields`, and `values`, or `range`, `steps` and `spacing`. Throws
/// InputError.
StudyAxis readStudyAxis(const TomlTable& table, const std::string& name);

/// Reads one scalar or an array of them in TOML syntax; if `plain`, as texts without quotes. Throws
/// InputError if there is none.
std::vector<std::string> readStudyValues(const TomlTable& table, const std::string& key, bool plain);

} // namespace plumbline
