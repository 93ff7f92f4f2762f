// Decides which searches run on which surfaces: a surface's manifest lists the properties that it `offers`, a
// technique's those that it `needs`. One table defines the names of both.
#pragma once

#include "realtime/technique/manifest.h"

#include <string>
#include <vector>

namespace plumbline {

/// A property of a surface on which a search may rely.
struct SurfaceProperty {
    const char* name;
    const char* meaning;  // continues "the search needs …"
    const char* function; // that a search may call only if the surface has the property; null: none
};
const std::vector<SurfaceProperty>& surfaceProperties();
std::vector<std::string> surfacePropertyNames();

/// The reason why the search doesn't run on the surface; empty if it does.
std::string refusalOf(const Manifest& search, const Manifest& surface);

/// Names of the `surfaces` on which the search runs, sorted by the number of offered properties, so that the
/// simplest one comes first in lists and tables; empty for the control technique.
std::vector<std::string> surfacesFor(const Manifest& search, const std::vector<Manifest>& surfaces);

} // namespace plumbline
