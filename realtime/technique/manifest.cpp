#include "realtime/technique/manifest.h"

#include "realtime/bake/bake.h"
#include "realtime/glsl/glsl_text.h"
#include "realtime/glsl/shader_source.h"
#include "realtime/technique/composition.h"
#include "realtime/technique/manifest_parameters.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/contains.h"
#include "scenes/core/error.h"
#include "scenes/frame/frame.h"
#include "scenes/toml/toml_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kSurfaceInputs{"quadric", "quadric_full"}, kShadows{"relief", "none"},
    kGeometries{"proxy", "micro_triangles"};

/// Reads the fields common to techniques and surfaces except `inputs`; the caller reads the others and calls
/// finish().
void readCommon(const TomlTable& table, Manifest& manifest) {
    manifest.title = table.line("title");
    manifest.citation = table.line("citation");
    manifest.limits = table.distinctTexts("limits");
    manifest.parameters = readParameters(table);
}

void readShaderName(const TomlTable& table, Manifest& manifest) {
    manifest.shader = manifest.name + ".glsl";
    if (!table.has("shader")) return;
    manifest.shader = table.line("shader");
    if (!fs::is_regular_file(manifest.shaderFile()))
        table.fail("shader", fmt::format("names {}, which is no file", manifest.shaderFile().string()),
                   "the path of a file, from the manifest's folder");
}

std::vector<std::string> readShadows(const TomlTable& table,
                                     std::optional<std::vector<std::string>> fallback = {}) {
    std::vector<std::string> shadows = table.someOf("shadows", kShadows, std::move(fallback));
    if (shadows.empty()) table.fail("shadows", "is empty", listOf(kShadows));
    return shadows;
}

/// The height map, kinds of baked maps, and parameters that choose between such kinds.
std::vector<std::string> techniqueInputs(const Manifest& manifest) {
    std::vector<std::string> names{"height"};
    for (const BakeKind& kind : bakeKinds())
        names.emplace_back(kind.name);
    for (const Parameter& parameter : manifest.parameters)
        if (parameter.type == ParameterValue::Type::Choice &&
            std::all_of(parameter.choices.begin(), parameter.choices.end(), isBakeKind))
            names.push_back(parameter.name);
    return names;
}

std::vector<std::string> channelNames() {
    std::vector<std::string> names;
    for (const ChannelInfo& info : channelTable())
        if (!info.name.starts_with("uncertain")) names.emplace_back(info.name);
    return names;
}

void checkShader(const Manifest& manifest) {
    const std::string glsl = readShader(manifest.shaderFile());
    if (const auto byte = firstNonAsciiByte(glsl))
        throw InputError(fmt::format("{}:{}", manifest.shaderFile().string(), byte->line),
                         fmt::format("holds the byte {:#04x} outside of a comment", byte->value),
                         "ASCII text",
                         "editors write such bytes as typographic quotes, no-break spaces or a mark of UTF-8 "
                         "at the start");
    for (const Parameter& parameter : manifest.parameters)
        if (!manifest.hasInput(parameter.name) && !namesIdentifier(glsl, parameter.name))
            throw InputError(manifest.file.string(),
                             fmt::format("parameter '{}' doesn't occur in {}", parameter.name,
                                         manifest.shaderFile().filename().string()),
                             "a shader that uses every parameter of the manifest");
}

/// A shader that calls a function valid only on some surfaces must declare it under `needs`; otherwise the
/// results on other surfaces would be silently wrong.
void checkNeeds(const TomlTable& table, const Manifest& manifest) {
    const std::string glsl = readShader(manifest.shaderFile());
    for (const auto& [name, meaning, function] : surfaceProperties())
        if (function && namesIdentifier(glsl, function) && !manifest.hasNeed(name))
            table.fail("needs",
                       fmt::format("lacks {}, which {} relies on by calling {}", name,
                                   manifest.shaderFile().filename().string(), function),
                       fmt::format("\"{}\" among them", name));
}

/// An absolute path without "." or a trailing slash, so that the last component is the folder's name.
fs::path properFolder(const fs::path& folder) {
    std::error_code error;
    fs::path proper = fs::weakly_canonical(folder, error);
    if (error) proper = fs::absolute(folder).lexically_normal();
    return proper.has_filename() ? proper : proper.parent_path();
}

Manifest emptyManifest(const fs::path& folder, const char* fileName) {
    Manifest manifest;
    manifest.folder = properFolder(folder);
    manifest.name = manifest.folder.filename().string();
    manifest.folder = folder; // messages show the path as given
    manifest.file = folder / fileName;
    if (!fs::exists(manifest.file))
        throw InputError(folder.string(), fmt::format("has no {}", fileName),
                         fmt::format("{} and {}.glsl", fileName, manifest.name),
                         "realtime/techniques/_template/ is one to copy");
    return manifest;
}

} // namespace

bool Manifest::hasInput(const std::string& input) const {
    return contains(inputs, input);
}

bool Manifest::hasNeed(const std::string& property) const {
    return contains(needs, property);
}

bool Manifest::hasOffer(const std::string& property) const {
    return contains(offers, property);
}

Manifest readTechniqueManifest(const fs::path& folder) {
    Manifest manifest = emptyManifest(folder, "technique.toml");
    const TomlTable table = TomlTable::readFile(manifest.file);
    readCommon(table, manifest);
    manifest.inputs = table.someOf("inputs", techniqueInputs(manifest));
    manifest.channels = table.someOf("channels", channelNames(), std::vector<std::string>{});
    if (table.has("channels") && !contains(manifest.channels, "A") && !contains(manifest.channels, "id"))
        table.fail("channels", "has neither A nor id, so frames have no coverage",
                   "one of them among the channels");
    if (table.choice("geometry", kGeometries, "proxy") == "micro_triangles") {
        manifest.geometry = Geometry::MicroTriangles;
        if (!manifest.parameters.empty())
            table.fail("parameter", "is given, but micro_triangles have no shader that could use parameters",
                       "no [[parameter]]");
    } else {
        readShaderName(table, manifest);
        manifest.needs = table.someOf("needs", surfacePropertyNames());
        manifest.shadows = readShadows(table, kShadows);
        checkShader(manifest);
        checkNeeds(table, manifest);
    }
    table.finish();
    return manifest;
}

Manifest readSurfaceManifest(const fs::path& folder) {
    Manifest manifest = emptyManifest(folder, "surface.toml");
    const TomlTable table = TomlTable::readFile(manifest.file);
    readCommon(table, manifest);
    manifest.inputs = table.someOf("inputs", kSurfaceInputs);
    if (manifest.inputs.size() > 1) table.fail("inputs", "holds two quadrics", listOf(kSurfaceInputs));
    manifest.offers = table.someOf("offers", surfacePropertyNames());
    manifest.shadows = readShadows(table);
    readShaderName(table, manifest);
    if (table.has("variant_of")) manifest.variantOf = table.choice("variant_of", surfaceNames());
    table.finish();
    checkShader(manifest);
    return manifest;
}

} // namespace plumbline
