#include "realtime/technique/composition.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {

const std::vector<SurfaceProperty>& surfaceProperties() {
    static const std::vector<SurfaceProperty> properties{
        {"linear_st", "texture coordinates that are linear along the ray", "beginWalk"},
        {"polynomial_depth", "a depth that is a polynomial of degree 2 along the ray", "hitInCell"},
        {"linear_depth", "a depth that is linear along the ray, 1 at its end", nullptr},
        {"bounded_descent", "a bound on the ray's descent", "steepestDescent"},
        {"flat_base", "a flat base, because distances differ on a curved one", nullptr},
    };
    return properties;
}

std::vector<std::string> surfacePropertyNames() {
    std::vector<std::string> names;
    for (const SurfaceProperty& property : surfaceProperties())
        names.emplace_back(property.name);
    return names;
}

std::string refusalOf(const Manifest& search, const Manifest& surface) {
    std::vector<std::string> missing;
    for (const auto& [name, meaning, function] : surfaceProperties())
        if (search.hasNeed(name) && !surface.hasOffer(name))
            missing.push_back(fmt::format("{} ({})", name, meaning));
    if (missing.empty()) return {};
    return fmt::format("the search needs {}, which the surface doesn't offer", fmt::join(missing, " and "));
}

std::vector<std::string> surfacesFor(const Manifest& search, const std::vector<Manifest>& surfaces) {
    std::vector<std::string> names;
    if (search.drawsMicroTriangles()) return names;
    std::vector<const Manifest*> chosen;
    for (const Manifest& surface : surfaces)
        if (refusalOf(search, surface).empty()) chosen.push_back(&surface);
    std::stable_sort(chosen.begin(), chosen.end(), [](const Manifest* a, const Manifest* b) {
        return a->offers.size() > b->offers.size();
    });
    for (const Manifest* surface : chosen)
        names.push_back(surface->name);
    return names;
}

} // namespace plumbline
