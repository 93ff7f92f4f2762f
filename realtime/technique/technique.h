// A resolved technique: the manifests of search and surface, and the values of all parameters.
#pragma once

#include "realtime/technique/manifest_cache.h"
#include "realtime/technique/technique_request.h"

#include <optional>
#include <string>
#include <vector>

namespace plumbline {

/// Which quadrics of the proxy's vertices (scenes/surface/quadric_fit.h) define the curvature of a curved
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
    std::vector<Setting> harnessSettings; // those of README.md that apply

    /// The name in all results: SEARCH[@SURFACE][:key=value,…] with the parameters that differ from their
    /// defaults.
    std::string name() const;
    /// A request that resolves to this technique without shared settings.
    TechniqueRequest request() const;

    /// Names of all settings, sorted.
    std::vector<std::string> settingNames() const;
    /// `own` takes precedence over `shared`, whose unknown keys are ignored. Throws InputError for an unknown
    /// key of `own`, an invalid value, or two baked maps of the same family.
    void set(const Settings& own, const Settings& shared);

    const Setting* harness(const std::string& settingName) const;
    /// The value of a harness setting as text; empty if it doesn't apply.
    std::string choice(const std::string& settingName) const;
    bool drawsMicroTriangles() const { return search.drawsMicroTriangles(); }
    bool hasCurvedBase() const { return surface && surface->hasQuadricBase(); }
    /// The quadrics of the base; only for a curved base.
    CurvatureSet curvatureSet() const;
    bool castsReliefShadows() const { return choice("shadow") == "relief"; }
    bool readsShadowMaps() const { return choice("shadow") == "map"; }
    bool discardsOutsideTriangle() const { return choice("triangle_bounds") == "true"; }
    bool correctsDepth() const { return choice("depth_correction") == "true"; }
    bool hardwareFilter() const { return choice("filter") == "hardware"; }
    /// Kinds of the baked maps that it reads with the current values.
    std::vector<std::string> bakedKinds() const;
    /// All settings as text.
    Settings parameters() const;
    /// The GLSL constants of shaderSettings, one per line.
    std::string glslConstants() const;
};

/// Search and surface of a request with default parameters. Throws InputError for an unknown technique or
/// surface, an invalid manifest, a surface on which the search doesn't run, and conflicting parameter names
/// or shadows.
Technique composeTechnique(const TechniqueRequest& request, ManifestCache& manifests);

/// The same with the request's settings and the applicable `shared` ones. Throws InputError like
/// composeTechnique and Technique::set.
Technique resolveTechnique(const TechniqueRequest& request, const Settings& shared = {});
/// The same for a text that parseTechnique parses.
Technique resolveTechnique(const std::string& text, const Settings& shared = {});

} // namespace plumbline
