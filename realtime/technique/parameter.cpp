// Values of parameters: text in, text out.
#include "realtime/technique/manifest.h"
#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace plumbline {
namespace {

/// The whole text as a number, in the C locale.
bool parseNumber(const std::string& text, double& value) {
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
}

bool parseInteger(const std::string& text, double& value) {
    long long integer = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, integer);
    value = static_cast<double>(integer);
    return result.ec == std::errc() && result.ptr == end;
}

} // namespace

std::string Parameter::typeName() const {
    switch (type) {
    case ParameterValue::Type::Int:
        return "int";
    case ParameterValue::Type::Float:
        return "float";
    case ParameterValue::Type::Bool:
        return "bool";
    default:
        return "choice";
    }
}

std::string Parameter::rangeText() const {
    switch (type) {
    case ParameterValue::Type::Bool:
        return "true or false";
    case ParameterValue::Type::Choice:
        return listOf(choices);
    default:
        return fmt::format("{} to {}", low, high);
    }
}

ParameterValue Parameter::parse(const std::string& where, const std::string& text) const {
    ParameterValue value{type, 0};
    bool good = false;
    switch (type) {
    case ParameterValue::Type::Bool:
        good = text == "true" || text == "false";
        value.number = text == "true";
        break;
    case ParameterValue::Type::Choice: {
        const auto found = std::find(choices.begin(), choices.end(), text);
        good = found != choices.end();
        value.number = static_cast<double>(found - choices.begin());
        break;
    }
    case ParameterValue::Type::Int:
        good = parseInteger(text, value.number);
        break;
    case ParameterValue::Type::Float:
        good = parseNumber(text, value.number);
        break;
    }
    if (type == ParameterValue::Type::Int || type == ParameterValue::Type::Float)
        good = good && value.number >= low && value.number <= high;
    if (good) return value;
    const std::string expected =
        type == ParameterValue::Type::Int || type == ParameterValue::Type::Float
            ? fmt::format("{} from {}", type == ParameterValue::Type::Int ? "a whole number" : "a number",
                          rangeText())
            : rangeText();
    throw InputError(where, fmt::format("{} = '{}'", name, text), expected, didYouMean(text, choices));
}

std::string Parameter::format(const ParameterValue& value) const {
    switch (type) {
    case ParameterValue::Type::Bool:
        return value.number != 0 ? "true" : "false";
    case ParameterValue::Type::Choice:
        return choices[static_cast<size_t>(value.number)];
    case ParameterValue::Type::Int:
        return fmt::format("{}", static_cast<long long>(value.number));
    default:
        return fmt::format("{}", value.number);
    }
}

} // namespace plumbline
