#include "manifest.h"

#include "../scenes/data_folder.h"
#include "../scenes/error.h"
#include "../scenes/frame.h"
#include "gl_program.h"
#include "glsl_words.h"
#include "inputs/bake.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kSurfaceInputs{"quadric"}, kShadows{"relief", "none"},
    kGeometries{"proxy", "micro_triangles"}, kTypes{"int", "float", "bool", "choice"};
// Ints are injected as GLSL ints.
constexpr double kLargestInt = 2147483647.0;

/// A TOML table that remembers which of its keys were asked for.
class Fields {
  public:
    Fields(const fs::path& file, const toml::table& table, std::string prefix)
        : file_(file), table_(table), prefix_(std::move(prefix)) {}

    std::string at(const toml::node* node) const {
        const auto line = node ? node->source().begin.line : table_.source().begin.line;
        return line > 0 ? fmt::format("{}:{}", file_.string(), line) : file_.string();
    }
    [[noreturn]] void fail(const toml::node* node, const std::string& what, const std::string& expected,
                           const std::string& hint = {}) const {
        throw InputError(at(node), what, expected, hint);
    }

    const toml::node* find(const std::string& key) {
        known_.insert(key);
        return table_.get(key);
    }
    const toml::node& require(const std::string& key, const std::string& expected) {
        const toml::node* node = find(key);
        if (!node) fail(nullptr, fmt::format("{}{} is missing", prefix_, key), expected);
        return *node;
    }

    std::string text(const std::string& key, bool mayBeEmpty = false) {
        const toml::node& node = require(key, "a text");
        const auto value = node.value_exact<std::string>();
        if (!value || (value->empty() && !mayBeEmpty))
            fail(&node, fmt::format("{}{} is {}", prefix_, key, value ? "empty" : "not a text"),
                 "a text in quotes");
        return *value;
    }

    /// `choices` empty: any text.
    std::vector<std::string> texts(const std::string& key, const std::vector<std::string>& choices,
                                   bool required) {
        const toml::node* node = required ? &require(key, "a list of texts") : find(key);
        if (!node) return {};
        const toml::array* array = node->as_array();
        if (!array) fail(node, fmt::format("{}{} is not a list", prefix_, key), "[\"…\", \"…\"]");
        std::vector<std::string> values;
        for (const toml::node& element : *array) {
            const auto value = element.value_exact<std::string>();
            if (!value || value->empty())
                fail(&element, fmt::format("{}{} holds something that is not a text", prefix_, key),
                     "texts in quotes");
            checkChoice(element, key, *value, choices);
            if (std::find(values.begin(), values.end(), *value) != values.end())
                fail(&element, fmt::format("{}{} names '{}' twice", prefix_, key, *value), "each once");
            values.push_back(*value);
        }
        return values;
    }

    void checkChoice(const toml::node& node, const std::string& key, const std::string& value,
                     const std::vector<std::string>& choices) const {
        if (choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end()) return;
        fail(&node, fmt::format("{}{}: '{}' is not known", prefix_, key, value), listOf(choices),
             didYouMean(value, choices));
    }

    /// After all were asked for: any other key is a mistake.
    void rejectUnknown() const {
        for (const auto& [key, node] : table_) {
            const std::string name(key.str());
            if (known_.count(name)) continue;
            const std::vector<std::string> choices(known_.begin(), known_.end());
            fail(&node, fmt::format("{}{} is not a field of it", prefix_, name), listOf(choices),
                 didYouMean(name, choices));
        }
    }

  private:
    const fs::path& file_;
    const toml::table& table_;
    std::string prefix_;
    std::set<std::string> known_;
};

toml::table parseFile(const fs::path& file) {
    const std::string text = readText(file);
    try {
        return toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}:{}", file.string(), error.source().begin.line), error.description());
    }
}

double numberOf(const Fields& fields, const toml::node& node, const std::string& what, bool integer) {
    const auto value = integer ? std::optional<double>() : node.value<double>();
    const auto whole = node.value_exact<int64_t>();
    const double number = whole ? static_cast<double>(*whole) : value.value_or(kNanF);
    if (!std::isfinite(number) || (integer && std::abs(number) > kLargestInt))
        fields.fail(&node, what + " is not " + (integer ? "a whole number" : "a number"),
                    integer ? "a whole number of 32 bits" : "a finite number");
    return number;
}

/// Also in GLSL ES and in the manifest's own syntax: letters, digits and single underscores.
void checkParameterName(const Fields& fields, const toml::node* node, const std::string& name) {
    const bool goodStart = !name.empty() && (std::isalpha(static_cast<unsigned char>(name[0])) != 0);
    const bool goodRest = std::all_of(name.begin(), name.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    });
    if (!goodStart || !goodRest || name.find("__") != std::string::npos || name.starts_with("gl_"))
        fields.fail(node, fmt::format("parameter name '{}' can't be a GLSL name", name),
                    "a letter, then letters, digits and single underscores");
    if (isGlslWord(name))
        fields.fail(node, fmt::format("parameter name '{}' is a word of GLSL", name), "another name");
    if (isHarnessName(name))
        fields.fail(node, fmt::format("parameter name '{}' belongs to the harness", name), "another name");
}

void readRange(Fields& fields, Parameter& parameter) {
    const bool integer = parameter.type == ParameterValue::Type::Int;
    const toml::node& node = fields.require("range", "[lowest, highest]");
    const toml::array* range = node.as_array();
    if (!range || range->size() != 2) fields.fail(&node, "range is not a pair", "[lowest, highest]");
    parameter.low = numberOf(fields, *range->get(0), "range", integer);
    parameter.high = numberOf(fields, *range->get(1), "range", integer);
    if (!(parameter.low <= parameter.high))
        fields.fail(&node, fmt::format("range [{}, {}] is empty", parameter.low, parameter.high),
                    "[lowest, highest]");
}

void readDefault(Fields& fields, Parameter& parameter) {
    const toml::node& node = fields.require("default", "a value of the type");
    std::string text;
    if (const auto flag = node.value_exact<bool>())
        text = *flag ? "true" : "false";
    else if (const auto choice = node.value_exact<std::string>())
        text = *choice;
    else if (const auto whole = node.value_exact<int64_t>())
        text = fmt::format("{}", *whole);
    else
        text = fmt::format("{}", numberOf(fields, node, "default", false));
    const bool wantsText = parameter.type == ParameterValue::Type::Choice;
    if (node.is_string() != wantsText)
        fields.fail(&node, fmt::format("default '{}' is not of type {}", text, parameter.typeName()),
                    parameter.rangeText());
    parameter.defaultValue = parameter.parse(fields.at(&node), text);
}

Parameter readParameter(const fs::path& file, const toml::table& table) {
    Fields fields(file, table, "parameter.");
    Parameter parameter;
    parameter.name = fields.text("name");
    checkParameterName(fields, table.get("name"), parameter.name);
    const std::string type = fields.text("type");
    fields.checkChoice(*table.get("type"), "type", type, kTypes);
    parameter.type =
        static_cast<ParameterValue::Type>(std::find(kTypes.begin(), kTypes.end(), type) - kTypes.begin());
    if (parameter.type == ParameterValue::Type::Choice) {
        parameter.choices = fields.texts("choices", {}, true);
        if (parameter.choices.empty()) fields.fail(table.get("choices"), "choices is empty", "at least one");
        for (const std::string& choice : parameter.choices) // the shader sees NAME_CHOICE
            checkParameterName(fields, table.get("choices"), parameter.name + "_" + choice);
    } else if (parameter.type != ParameterValue::Type::Bool) {
        readRange(fields, parameter);
    }
    readDefault(fields, parameter);
    parameter.unit = fields.text("unit", true);
    parameter.meaning = fields.text("meaning");
    fields.rejectUnknown();
    return parameter;
}

void readParameters(const fs::path& file, Fields& fields, Manifest& manifest) {
    const toml::node* node = fields.find("parameter");
    if (!node) return;
    const toml::array* array = node->as_array();
    if (!array || !array->is_array_of_tables())
        fields.fail(node, "parameter is not a list of tables", "[[parameter]]");
    for (const toml::node& element : *array) {
        Parameter parameter = readParameter(file, *element.as_table());
        for (const Parameter& other : manifest.parameters)
            if (other.name == parameter.name)
                fields.fail(&element, fmt::format("parameter '{}' is declared twice", parameter.name),
                            "each once");
        manifest.parameters.push_back(std::move(parameter));
    }
}

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
    manifest.shadows = fields.texts("shadows", kShadows, true);
    if (manifest.shadows.empty()) fields.fail(table.get("shadows"), "shadows is empty", listOf(kShadows));
    fields.rejectUnknown();
    checkShader(manifest);
    return manifest;
}

} // namespace plumbline
