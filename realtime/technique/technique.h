// A technique ready to be drawn: search and surface found, their manifests read, every parameter with its
// value.
#pragma once

#include "realtime/technique/curvature_set.h"
#include "realtime/technique/manifest.h"
#include "realtime/technique/technique_request.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

struct Technique {
    struct Setting {
        Parameter parameter;
        ParameterValue value;
    };

    Manifest search;
    std::optional<Manifest> surface;      // none for micro_triangles
    std::vector<Setting> shaderSettings;  // of search and surface: become constants of the shader
    std::vector<Setting> harnessSettings; // those README.md lists, as far as they apply
    std::string name;                     // as in every result

    const Setting* harness(const std::string& settingName) const;
    /// Text of a harness setting; empty if it doesn't apply.
    std::string choice(const std::string& settingName) const;
    bool drawsMicroTriangles() const { return search.drawsMicroTriangles(); }
    bool hasBentBase() const { return surface && surface->isBent(); }
    /// The quadrics its base is given; only where it is bent.
    CurvatureSet curvatureSet() const;
    bool castsReliefShadows() const { return choice("shadow") == "relief"; }
    bool readsShadowMaps() const { return choice("shadow") == "map"; }
    bool discardsOutsideTriangle() const { return choice("triangle_bounds") == "true"; }
    bool correctsDepth() const { return choice("depth_correction") == "true"; }
    bool hardwareFilter() const { return choice("filter") == "hardware"; }
    /// Kinds of the baked maps it reads, with choices made.
    std::vector<std::string> bakedKinds() const;
    /// Every setting as text.
    Settings parameters() const;
    /// The GLSL constants of shaderSettings, one a line.
    std::string glslConstants() const;
};

/// Throws InputError: unknown technique or surface, a surface it doesn't compose with, manifest, setting.
/// Keys of `shared` that the technique doesn't know are ignored.
Technique resolveTechnique(const TechniqueRequest& request, const Settings& shared);

/// Names of the settings a technique takes: its own, its surface's and the harness's.
std::vector<std::string> knownSettings(const TechniqueRequest& request);
/// Name as results show it; for a technique whose manifest can't be read, as the user wrote it.
std::string displayName(const TechniqueRequest& request, const Settings& settings);
/// Name as results show it, without drawing.
std::string techniqueName(const TechniqueRequest& request, const Settings& shared);

} // namespace plumbline
