// Parsing and formatting of parameter values.
#include "realtime/technique/manifest.h"
#include "scenes/core/error.h"
#include "scenes/core/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace plumbline {

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
    const bool isNumber = type == ParameterValue::Type::Int || type == ParameterValue::Type::Float;
    std::optional<double> number;
    switch (type) {
    case ParameterValue::Type::Bool:
        if (text == "true" || text == "false") number = text == "true";
        break;
    case ParameterValue::Type::Choice:
        if (const auto found = std::ranges::find(choices, text); found != choices.end())
            number = static_cast<double>(found - choices.begin());
        break;
    case ParameterValue::Type::Int:
        if (const auto whole = parseNumber<long long>(text)) number = static_cast<double>(*whole);
        break;
    case ParameterValue::Type::Float:
        number = parseNumber<double>(text);
        break;
    }
    if (number && (!isNumber || (*number >= low && *number <= high))) return {type, *number};
    const std::string expected =
        isNumber ? fmt::format("{} from {}",
                               type == ParameterValue::Type::Int ? "a whole number" : "a number", rangeText())
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
