// A technique ready to be drawn: search and surface found, their manifests read, every parameter with its
// value.
#pragma once

#include "realtime/technique/manifest_cache.h"
#include "realtime/technique/technique_request.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// Which quadrics of the proxy's vertices (scenes/surface/quadric_fit.h) are given as the curvature of a bent
/// base. TwoTerms: C = 0.
enum class CurvatureSet { RingTwoTerms, RingThreeTerms, LimitTwoTerms, LimitThreeTerms };

struct Technique {
    struct Setting {
        Parameter parameter;
        ParameterValue value;
    };

    Manifest search;
    std::optional<Manifest> surface;      // none for micro-triangles
    std::vector<Setting> shaderSettings;  // of search and surface: become constants of the shader
    std::vector<Setting> harnessSettings; // those README.md lists, as far as they apply

    /// As in every result: SEARCH[@SURFACE][:key=value,…] with the parameters that differ from their default.
    std::string name() const;
    /// Resolves to this technique again, with nothing shared.
    TechniqueRequest request() const;

    /// Names of all settings, sorted.
    std::vector<std::string> settingNames() const;
    /// `own` wins over `shared`, whose unknown keys are ignored. Throws InputError: an unknown key of `own`,
    /// a value that isn't allowed, two baked maps that are read in the same way.
    void set(const Settings& own, const Settings& shared);

    const Setting* harness(const std::string& settingName) const;
    /// Text of a harness setting; empty if it doesn't apply.
    std::string choice(const std::string& settingName) const;
    bool drawsMicroTriangles() const { return search.drawsMicroTriangles(); }
    bool hasCurvedBase() const { return surface && surface->hasQuadricBase(); }
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

/// Search and surface of a request with every parameter at its default. Throws InputError: unknown technique
/// or surface, a surface it doesn't run on, a manifest, names or shadows of the two that don't fit together.
Technique composeTechnique(const TechniqueRequest& request, ManifestCache& manifests);

/// The same with the request's settings and the `shared` ones it knows. Throws InputError as composeTechnique
/// and Technique::set.
Technique resolveTechnique(const TechniqueRequest& request, const Settings& shared = {});
/// Of a text as parseTechnique takes it.
Technique resolveTechnique(const std::string& text, const Settings& shared = {});

} // namespace plumbline
