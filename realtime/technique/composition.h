// Which searches run on which surfaces: a surface's manifest says what it `offers`, a technique's what it
// `needs`, both by the names of one table.
#pragma once

#include "realtime/technique/manifest.h"

#include <string>
#include <vector>

namespace plumbline {

/// What a search may rely on in the surface below it.
struct SurfaceProperty {
    const char* name;
    const char* meaning;  // continues "the search needs …"
    const char* function; // that a search calls only where the surface has the property; null: none
};
const std::vector<SurfaceProperty>& surfaceProperties();
std::vector<std::string> surfacePropertyNames();

/// Why the search doesn't run on the surface; empty if it does.
std::string refusalOf(const Manifest& search, const Manifest& surface);

/// Names of those of `surfaces` the search runs on, those that offer most first, so that the plainest leads
/// lists and tables; none for the control technique.
std::vector<std::string> surfacesFor(const Manifest& search, const std::vector<Manifest>& surfaces);

} // namespace plumbline
