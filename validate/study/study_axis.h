// The values an axis of a study takes.
#pragma once

#include "scenes/toml/toml_table.h"
#include "validate/study/study.h"

namespace plumbline {

/// `[[grid.axis]]`: `field` or `fields`, and `values`, or `range`, `steps` and `spacing`. Throws InputError.
StudyAxis readStudyAxis(const TomlTable& table, const std::string& name);

/// One scalar or an array of them, each as TOML writes it; as plain texts if `plain`. Throws InputError for
/// none.
std::vector<std::string> readStudyValues(const TomlTable& table, const std::string& key, bool plain);

} // namespace plumbline
