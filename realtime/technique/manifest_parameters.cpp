#include "realtime/technique/manifest_parameters.h"

#include "realtime/glsl/glsl_text.h"
#include "realtime/technique/reserved_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace plumbline {
namespace {

using Type = ParameterValue::Type;

const std::vector<std::string> kTypes{"int", "float", "bool", "choice"}; // in the order of Type
// Ints are injected as GLSL ints.
constexpr int kLargestInt = std::numeric_limits<int32_t>::max();
constexpr double kLargestFloat = std::numeric_limits<float>::max();

/// Throws InputError if `name` isn't a valid name in GLSL, GLSL ES and `--technique NAME:key=value`. `name`
/// is the parameter's name, or a GLSL name derived from the field `key`.
void checkParameterName(const TomlTable& table, const char* key, const std::string& name) {
    const auto isLetter = [](unsigned char c) { return std::isalpha(c) != 0; };
    if (name.empty() || !isLetter(static_cast<unsigned char>(name[0])) ||
        !std::all_of(name.begin(), name.end(), isNameCharacter) || name.find("__") != std::string::npos ||
        name.starts_with("gl_"))
        table.fail(key, fmt::format("'{}' can't be a GLSL name", name),
                   "a letter, then letters, digits and single underscores");
    if (isGlslWord(name)) table.fail(key, fmt::format("'{}' is reserved in GLSL", name), "another name");
    if (isReserved(name)) table.fail(key, fmt::format("'{}' is used by the harness", name), "another name");
}

void readRange(const TomlTable& table, Parameter& parameter) {
    if (parameter.type == Type::Int) {
        const Vec2i range = table.integers2("range", -kLargestInt, kLargestInt);
        parameter.low = range.x;
        parameter.high = range.y;
    } else {
        const Vec2 range = table.vector2("range", -kLargestFloat, kLargestFloat);
        parameter.low = range.x;
        parameter.high = range.y;
    }
    if (!(parameter.low <= parameter.high))
        table.fail("range", fmt::format("[{}, {}] is empty", parameter.low, parameter.high),
                   "[lowest, highest]");
}

void readChoices(const TomlTable& table, Parameter& parameter) {
    parameter.choices = table.distinctTexts("choices");
    if (parameter.choices.empty()) table.fail("choices", "is empty", "at least one");
    for (const std::string& choice : parameter.choices) // the shader sees NAME_CHOICE
        checkParameterName(table, "choices", parameter.name + "_" + choice);
}

double readDefault(const TomlTable& table, const Parameter& parameter) {
    switch (parameter.type) {
    case Type::Int:
        return table.integer("default", static_cast<int>(parameter.low), static_cast<int>(parameter.high));
    case Type::Float:
        return table.number("default", parameter.low, parameter.high);
    case Type::Bool:
        return table.boolean("default") ? 1 : 0;
    default:
        const auto& choices = parameter.choices;
        const auto chosen = std::find(choices.begin(), choices.end(), table.choice("default", choices));
        return static_cast<double>(chosen - choices.begin());
    }
}

Parameter readParameter(const TomlTable& table) {
    Parameter parameter;
    parameter.name = table.text("name");
    checkParameterName(table, "name", parameter.name);
    const auto type = std::find(kTypes.begin(), kTypes.end(), table.choice("type", kTypes));
    parameter.type = static_cast<Type>(type - kTypes.begin());
    if (parameter.type == Type::Choice)
        readChoices(table, parameter);
    else if (parameter.type != Type::Bool)
        readRange(table, parameter);
    parameter.defaultValue = {parameter.type, readDefault(table, parameter)};
    parameter.unit = table.text("unit");
    parameter.meaning = table.line("meaning");
    table.finish();
    return parameter;
}

} // namespace

std::vector<Parameter> readParameters(const TomlTable& manifest) {
    std::vector<Parameter> parameters;
    for (const TomlTable& table : manifest.tables("parameter")) {
        parameters.push_back(readParameter(table));
        for (size_t i = 0; i + 1 < parameters.size(); ++i)
            if (parameters[i].name == parameters.back().name)
                table.fail("name", fmt::format("'{}' is declared twice", parameters[i].name), "each once");
    }
    return parameters;
}

} // namespace plumbline
