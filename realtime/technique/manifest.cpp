#include "realtime/technique/manifest.h"

#include "realtime/bake/bake.h"
#include "realtime/technique/glsl_words.h"
#include "realtime/technique/manifest_fields.h"
#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "scenes/frame/frame.h"

#include <algorithm>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kSurfaceInputs{"quadric", "quadric_full"}, kShadows{"relief", "none"},
    kGeometries{"proxy", "micro_triangles"};

/// The parts a technique and a surface have in common; the caller asks for the rest before rejectUnknown().
void readCommon(const fs::path& file, Fields& fields, Manifest& manifest) {
    manifest.title = fields.text("title");
    manifest.citation = fields.text("citation");
    manifest.inputs = fields.texts("inputs", {}, true);
    manifest.limits = fields.texts("limits", {}, true);
    readParameters(file, fields, manifest);
}

/// Each input is one of `known`, or in a technique the name of a choice between kinds of baked maps.
void checkInputs(const Fields& fields, const toml::table& table, const Manifest& manifest,
                 std::vector<std::string> known) {
    for (const Parameter& parameter : manifest.parameters)
        if (parameter.type == ParameterValue::Type::Choice &&
            std::all_of(parameter.choices.begin(), parameter.choices.end(), isBakeKind))
            known.push_back(parameter.name);
    for (const toml::node& element : *table["inputs"].as_array())
        fields.checkChoice(element, "inputs", *element.value<std::string>(), known);
}

std::vector<std::string> techniqueInputs() {
    std::vector<std::string> names{"height"};
    for (const BakeKind& kind : bakeKinds())
        names.emplace_back(kind.name);
    return names;
}

/// [refused_surfaces]: name = "reason".
void readRefusals(const fs::path& file, Fields& fields, Manifest& manifest) {
    const toml::node* node = fields.find("refused_surfaces");
    if (!node) return;
    const toml::table* table = node->as_table();
    if (!table)
        fields.fail(node, "refused_surfaces is not a table", "[refused_surfaces] with SURFACE = \"reason\"");
    Fields reasons(file, *table, "refused_surfaces.");
    for (const std::string& surface : surfaceNames()) {
        if (!table->contains(surface)) {
            (void)reasons.find(surface); // known all the same
            continue;
        }
        if (std::find(manifest.surfaces.begin(), manifest.surfaces.end(), surface) != manifest.surfaces.end())
            fields.fail(table->get(surface), fmt::format("surface '{}' is both taken and refused", surface),
                        "one of them");
        manifest.refusals[surface] = reasons.text(surface);
    }
    reasons.rejectUnknown();
}

std::vector<std::string> channelNames() {
    std::vector<std::string> names;
    for (const ChannelInfo& info : channelTable())
        if (!info.name.starts_with("uncertain")) names.emplace_back(info.name);
    return names;
}

void checkShader(const Manifest& manifest) {
    const std::string glsl = readText(manifest.shaderFile());
    if (const auto byte = firstForeignByte(glsl))
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

/// Absolute, without "." and a trailing slash, so that the last part is the folder's name.
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
    manifest.folder = folder; // messages show the path as it was given
    manifest.file = folder / fileName;
    if (!fs::exists(manifest.file))
        throw InputError(folder.string(), fmt::format("has no {}", fileName),
                         fmt::format("{} and {}.glsl", fileName, manifest.name),
                         "realtime/techniques/_template/ is one to copy");
    return manifest;
}

} // namespace

bool Manifest::hasInput(const std::string& input) const {
    return std::find(inputs.begin(), inputs.end(), input) != inputs.end();
}

Manifest readTechniqueManifest(const fs::path& folder) {
    Manifest manifest = emptyManifest(folder, "technique.toml");
    const toml::table table = parseFile(manifest.file);
    Fields fields(manifest.file, table, "");
    readCommon(manifest.file, fields, manifest);
    checkInputs(fields, table, manifest, techniqueInputs());
    manifest.channels = fields.texts("channels", channelNames(), false);
    const auto writes = [&](const char* channel) {
        return std::find(manifest.channels.begin(), manifest.channels.end(), channel) !=
               manifest.channels.end();
    };
    if (table.contains("channels") && !writes("A") && !writes("id"))
        fields.fail(table.get("channels"),
                    "channels has neither A nor id, so that no frame says what it covers",
                    "one of them among the channels");
    if (const toml::node* node = fields.find("geometry")) {
        const auto value = node->value_exact<std::string>();
        if (!value) fields.fail(node, "geometry is not a text", listOf(kGeometries));
        fields.checkChoice(*node, "geometry", *value, kGeometries);
        if (*value == "micro_triangles") manifest.geometry = Geometry::MicroTriangles;
    }
    if (manifest.geometry == Geometry::Proxy) {
        manifest.surfaces = fields.texts("surfaces", surfaceNames(), true);
        readRefusals(manifest.file, fields, manifest);
        manifest.shadows = fields.texts("shadows", kShadows, false);
        if (!table.contains("shadows")) manifest.shadows = kShadows;
        if (manifest.surfaces.empty())
            fields.fail(table.get("surfaces"), "surfaces is empty", listOf(surfaceNames()));
        if (manifest.shadows.empty()) fields.fail(table.get("shadows"), "shadows is empty", listOf(kShadows));
        checkShader(manifest);
    } else if (!manifest.parameters.empty()) {
        fields.fail(table.get("parameter"),
                    "a technique of geometry micro_triangles has no shader to take parameters",
                    "no [[parameter]]");
    }
    fields.rejectUnknown();
    return manifest;
}

Manifest readSurfaceManifest(const fs::path& folder) {
    Manifest manifest = emptyManifest(folder, "surface.toml");
    const toml::table table = parseFile(manifest.file);
    Fields fields(manifest.file, table, "");
    readCommon(manifest.file, fields, manifest);
    checkInputs(fields, table, manifest, kSurfaceInputs);
    if (manifest.inputs.size() > 1)
        fields.fail(table.get("inputs"), "a base is given one quadric", listOf(kSurfaceInputs));
    manifest.shadows = fields.texts("shadows", kShadows, true);
    if (manifest.shadows.empty()) fields.fail(table.get("shadows"), "shadows is empty", listOf(kShadows));
    if (const toml::node* node = fields.find("variant_of")) {
        manifest.variantOf = fields.text("variant_of");
        fields.checkChoice(*node, "variant_of", manifest.variantOf, surfaceNames());
    }
    fields.rejectUnknown();
    checkShader(manifest);
    return manifest;
}

} // namespace plumbline
