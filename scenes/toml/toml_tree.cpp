#include "scenes/toml/toml_tree.h"

#include "scenes/core/error.h"
#include "scenes/toml/toml_key_depth.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

namespace plumbline {
namespace {

std::shared_ptr<TomlNode> convertTable(const toml::table& table, const std::string& file,
                                       const std::string& path);

TomlValue convertValue(const toml::node& node, const std::string& file, const std::string& path) {
    TomlValue value;
    value.line = static_cast<int>(node.source().begin.line);
    if (const auto* boolean = node.as_boolean()) {
        value.content = boolean->get();
    } else if (const auto* integer = node.as_integer()) {
        value.content = integer->get();
    } else if (const auto* number = node.as_floating_point()) {
        value.content = number->get();
    } else if (const auto* text = node.as_string()) {
        value.content = text->get();
    } else if (const auto* table = node.as_table()) {
        value.content = convertTable(*table, file, path);
    } else if (const auto* array = node.as_array()) {
        TomlValue::Array elements;
        for (const toml::node& element : *array)
            elements.push_back(convertValue(element, file, path));
        value.content = std::move(elements);
    }
    return value;
}

std::shared_ptr<TomlNode> convertTable(const toml::table& table, const std::string& file,
                                       const std::string& path) {
    auto node = std::make_shared<TomlNode>();
    node->file = file;
    node->path = path;
    node->line = std::max(1, static_cast<int>(table.source().begin.line));
    for (const auto& [key, element] : table) {
        TomlValue value = convertValue(element, file, joinPath(path, key.str()));
        // The table's own line may be that of a later header.
        value.line = static_cast<int>(key.source().begin.line);
        if (value.line == 0) value.line = node->line;
        node->values.emplace(std::string(key.str()), std::move(value));
    }
    return node;
}

/// Formats a number for a message: 3.0 keeps its decimal point, because it isn't an integer in TOML.
std::string describe(double number) {
    const std::string text = fmt::format("{}", number);
    const bool looksWhole = text.find_first_not_of("-0123456789") == std::string::npos;
    return looksWhole ? text + ".0" : text;
}

} // namespace

std::shared_ptr<TomlNode> parseToml(const std::string& fileName, const std::string& text) {
    checkKeyDepth(fileName, text);
    try {
        return convertTable(toml::parse(text, fileName), fileName, {});
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}:{}", fileName, error.source().begin.line),
                         fmt::format("is not valid TOML: {}", error.description()));
    }
}

TomlValue parseTomlValue(const std::string& where, const std::string& path, const std::string& text) {
    checkKeyDepth(where, text);
    try {
        const toml::table table = toml::parse("value = " + text);
        if (table.size() != 1) throw InputError(where, fmt::format("'{}' is more than a value", text));
        return convertValue(*table.get("value"), where, path);
    } catch (const toml::parse_error& error) {
        throw InputError(where, fmt::format("'{}' is not a TOML value: {}", text, error.description()),
                         "a value as in a scene file: 0.5, [1, 2, 3], \"text\", { … }");
    }
}

std::optional<std::string> tomlText(const std::string& text) {
    std::ostringstream stream;
    stream << toml::toml_formatter(toml::value<std::string>(text), toml::format_flags::none);
    try { // parse it back to check that the parser accepts it
        if (toml::parse("x = " + stream.str())["x"].value<std::string>() == text) return stream.str();
    } catch (const toml::parse_error&) { // as below
    }
    return std::nullopt;
}

std::string joinPath(const std::string& path, std::string_view key) {
    if (path.empty()) return std::string(key);
    return key.empty() ? path : fmt::format("{}.{}", path, key);
}

std::string describe(const TomlValue& value) {
    if (const auto* boolean = value.as<bool>()) return *boolean ? "true" : "false";
    if (const auto* integer = value.as<int64_t>()) return fmt::format("{}", *integer);
    if (const auto* number = value.as<double>()) return describe(*number);
    if (const auto* text = value.as<std::string>())
        return fmt::format("the string \"{}\"", text->size() > 60 ? text->substr(0, 60) + "…" : *text);
    if (const auto* array = value.as<TomlValue::Array>()) return fmt::format("an array of {}", array->size());
    if (value.as<std::shared_ptr<TomlNode>>()) return "a table";
    return "a date or time";
}

} // namespace plumbline
