// Parses the JSON of files: results, histories, outcomes of studies.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace plumbline {

/// A value with is_discarded() if the text isn't JSON. Throws InputError about `where` if its values nest
/// deeper than in any file that the program writes, because the library copies and writes them recursively.
nlohmann::json parseJson(const std::string& where, const std::string& text);

} // namespace plumbline
