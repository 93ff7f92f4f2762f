// A technique as specified by the user: SEARCH[@SURFACE][:key=value,…], where SEARCH is a name in
// realtime/techniques/ or a folder.
#pragma once

#include <map>
#include <string>

namespace plumbline {

/// Values of parameters as text, by name.
using Settings = std::map<std::string, std::string>;

inline constexpr const char* kFlatSurface = "flat";

struct TechniqueRequest {
    std::string search; // name or path
    std::string surface = kFlatSurface;
    Settings settings; // only of this technique
};

/// Throws InputError for a malformed text.
TechniqueRequest parseTechnique(const std::string& text);

} // namespace plumbline
