// Manifests of techniques and surfaces: technique.toml and surface.toml. Every field is documented in
// README.md; missing, unknown or invalid fields are errors with their line.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace plumbline {

/// A value of a parameter: int, float, bool, or the index of a choice.
struct ParameterValue {
    enum class Type { Int, Float, Bool, Choice };
    Type type = Type::Int;
    double number = 0; // Int, Float; Bool 0 or 1; Choice: index
    bool operator==(const ParameterValue&) const = default;
};

struct Parameter {
    std::string name;
    ParameterValue::Type type = ParameterValue::Type::Int;
    double low = 0, high = 0;         // Int, Float: both inclusive
    std::vector<std::string> choices; // Choice
    ParameterValue defaultValue;
    std::string unit;    // empty: dimensionless
    std::string meaning; // one sentence

    /// Throws InputError naming `where` and the parameter: wrong type, out of range or unknown choice.
    ParameterValue parse(const std::string& where, const std::string& text) const;
    /// The shortest text that parses to the value.
    std::string format(const ParameterValue& value) const;
    /// "int", "float", "bool" or "choice".
    std::string typeName() const;
    /// "1 to 4096", "true or false", "exact or hardware".
    std::string rangeText() const;
};

/// Geometry a technique is drawn on.
enum class Geometry { Proxy, MicroTriangles };

struct Manifest {
    std::string name; // of the folder
    std::filesystem::path folder, file;
    std::string shader; // path from `folder`
    std::string title, citation;
    Geometry geometry = Geometry::Proxy;
    std::vector<std::string>
        inputs; // of a technique: "height", kinds of baked maps, parameters that choose between such kinds;
                // of a surface: "quadric" (without cross term), "quadric_full" or nothing
    std::vector<std::string> needs;    // of a technique: required properties of surfaces (composition.h)
    std::vector<std::string> offers;   // of a surface: properties it has
    std::string variantOf;             // of a surface: the surface it modifies; may be empty
    std::vector<std::string> shadows;  // "none", "relief": supported kinds of shadows
    std::vector<std::string> channels; // of a technique: channels of its frames; empty = all
    std::vector<std::string> limits;
    std::vector<Parameter> parameters;

    bool hasInput(const std::string& input) const;
    bool drawsMicroTriangles() const { return geometry == Geometry::MicroTriangles; }
    bool hasNeed(const std::string& property) const;
    bool hasOffer(const std::string& property) const;
    /// Of a surface: whether its base is a quadric.
    bool hasQuadricBase() const { return hasInput("quadric") || hasInput("quadric_full"); }
    /// FOLDER/NAME.glsl, or the file that the manifest names.
    std::filesystem::path shaderFile() const { return folder / shader; }
};

/// Reads FOLDER/technique.toml or FOLDER/surface.toml and checks it, also that the shader is there and
/// names every parameter. Throws InputError.
Manifest readTechniqueManifest(const std::filesystem::path& folder);
Manifest readSurfaceManifest(const std::filesystem::path& folder);

} // namespace plumbline
