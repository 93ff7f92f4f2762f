#include "realtime/technique/harness_parameters.h"

#include "scenes/core/contains.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

using Type = ParameterValue::Type;

Parameter choiceParameter(std::string name, std::vector<std::string> choices, std::string meaning) {
    Parameter parameter;
    parameter.name = std::move(name);
    parameter.type = Type::Choice;
    parameter.choices = std::move(choices);
    parameter.defaultValue = {Type::Choice, 0};
    parameter.meaning = std::move(meaning);
    return parameter;
}

Parameter numberParameter(std::string name, Type type, double low, double high, double defaultValue,
                          std::string unit, std::string meaning) {
    Parameter parameter;
    parameter.name = std::move(name);
    parameter.type = type;
    parameter.low = low;
    parameter.high = high;
    parameter.defaultValue = {type, defaultValue};
    parameter.unit = std::move(unit);
    parameter.meaning = std::move(meaning);
    return parameter;
}

/// The shadows that both search and surface allow, the default first; the shadow map, which has no
/// requirements, is last.
std::vector<std::string> allowedShadows(const Manifest& search, const Manifest& surface) {
    std::vector<std::string> allowed;
    for (const char* shadow : {"relief", "none"})
        if (contains(search.shadows, shadow) && contains(surface.shadows, shadow))
            allowed.emplace_back(shadow);
    if (allowed.empty())
        throw InputError(search.file.string(),
                         fmt::format("its shadows have none in common with surface '{}'", surface.name),
                         listOf(surface.shadows));
    allowed.emplace_back("map");
    return allowed;
}

Parameter boolParameter(std::string name, bool defaultValue, std::string meaning) {
    Parameter parameter;
    parameter.name = std::move(name);
    parameter.type = Type::Bool;
    parameter.defaultValue = {Type::Bool, defaultValue ? 1.0 : 0.0};
    parameter.meaning = std::move(meaning);
    return parameter;
}

} // namespace

std::vector<std::string> offeredShadows(const Manifest& manifest) {
    std::vector<std::string> shadows = manifest.shadows;
    if (!manifest.drawsMicroTriangles()) shadows.emplace_back("map");
    return shadows;
}

std::vector<Parameter> harnessParameters(const Manifest& search, const Manifest& surface) {
    std::vector<Parameter> parameters;
    parameters.push_back(choiceParameter("filter", {"exact", "hardware"},
                                         "lookups: exact bilinear in float, or the sampler's own filter"));
    const std::vector<std::string> shadows = allowedShadows(search, surface);
    parameters.push_back(
        choiceParameter("shadow", shadows,
                        "cast shadows: a second search along the light; none (attached shadow only); or "
                        "a map drawn from the light (RP-351, section 3.5)"));
    // The bias of Watt and Policarpo (2005), chapter 5, listing 5.3. Without a bias (as in their Fig. 5.11)
    // lit points shadow themselves, because the searches from the camera and from the light end at slightly
    // different depths.
    parameters.push_back(
        numberParameter("shadow_bias", Type::Float, 0, 1, 0.02, "relief depth",
                        "minimum distance of an occluder above a point of a relief that it shadows"));
    parameters.push_back(numberParameter("shadow_map_size", Type::Int, 16, 8192, 1024, "texels",
                                         "side of a shadow map; a point light has six of them"));
    parameters.push_back(numberParameter("shadow_map_bias", Type::Float, 0, 1000, 1, "",
                                         "factor of the bias derived from the map's texels"));
    parameters.push_back(boolParameter(
        "triangle_bounds", false,
        "a hit beyond the texture coordinates of its triangle is discarded (Premecz 2006, section 1.1)"));
    parameters.push_back(
        boolParameter("depth_correction", true,
                      "the depth buffer holds the hit's depth (RP-351, section 3.5); false: the "
                      "polygon's, as for Z and occlusion"));
    if (surface.hasQuadricBase())
        parameters.push_back(choiceParameter("coefficients", {"ring", "limit"},
                                             "the base's quadric: fitted to the one-ring, as in RP-351, or "
                                             "with the curvature of the limit surface"));
    return parameters;
}

std::vector<std::string> harnessParameterNames() {
    Manifest search, curvedSurface; // a pair to which all of them apply
    search.shadows = curvedSurface.shadows = {"relief", "none"};
    curvedSurface.inputs = {"quadric"};
    std::vector<std::string> names;
    for (Parameter& parameter : harnessParameters(search, curvedSurface))
        names.push_back(std::move(parameter.name));
    return names;
}

} // namespace plumbline
