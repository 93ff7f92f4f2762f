// [[parameter]] of a manifest.
#include "realtime/bake/bake.h"
#include "realtime/technique/glsl_words.h"
#include "realtime/technique/manifest_fields.h"
#include "scenes/core/math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kTypes{"int", "float", "bool", "choice"};
// Ints are injected as GLSL ints.
constexpr double kLargestInt = 2147483647.0;
constexpr float kLargestFloat = std::numeric_limits<float>::max();

double numberOf(const Fields& fields, const toml::node& node, const std::string& what, bool integer) {
    const auto value = integer ? std::optional<double>() : node.value<double>();
    const auto whole = node.value_exact<int64_t>();
    const double number = whole ? static_cast<double>(*whole) : value.value_or(kNanF);
    if (!std::isfinite(number) || std::abs(number) > (integer ? kLargestInt : double(kLargestFloat)))
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
    if (isHarnessName(name) || isBakeKind(name))
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

} // namespace

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

} // namespace plumbline
