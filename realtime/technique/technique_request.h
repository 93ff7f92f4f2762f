// A technique as the user names it: SEARCH[@SURFACE][:key=value,…], SEARCH a name in realtime/techniques/ or
// a folder.
#pragma once

#include <map>
#include <string>

namespace plumbline {

/// Parameters by name, with the text of their value.
using Settings = std::map<std::string, std::string>;

inline constexpr const char* kFlatSurface = "flat";

struct TechniqueRequest {
    std::string search; // name or path
    std::string surface = kFlatSurface;
    Settings settings; // of this technique alone
};

/// Throws InputError for a text that doesn't have this form.
TechniqueRequest parseTechnique(const std::string& text);

} // namespace plumbline
