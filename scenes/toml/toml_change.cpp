#include "scenes/toml/toml_change.h"

#include "scenes/core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

bool isTables(const TomlValue& value) {
    const auto* array = value.as<TomlValue::Array>();
    return array && !array->empty() &&
           std::all_of(array->begin(), array->end(), [](const TomlValue& element) {
               return element.as<std::shared_ptr<TomlNode>>() != nullptr;
           });
}

/// Keys of a table whose values are tables or arrays of tables.
std::vector<std::string> tablesOf(const TomlNode& node) {
    std::vector<std::string> names;
    for (const auto& [name, value] : node.values)
        if (value.as<std::shared_ptr<TomlNode>>() || isTables(value)) names.push_back(name);
    return names;
}

/// An element of an array of tables, by its name or its index from 0.
std::shared_ptr<TomlNode> elementNamed(const std::string& where, const std::string& key,
                                       const TomlValue& value, const std::string& step) {
    std::vector<std::string> names;
    for (const TomlValue& element : *value.as<TomlValue::Array>()) {
        const auto& node = *element.as<std::shared_ptr<TomlNode>>();
        const auto name = node->values.find("name");
        const auto* text = name == node->values.end() ? nullptr : name->second.as<std::string>();
        const std::string number = std::to_string(names.size());
        if (step == number || (text && step == *text)) return node;
        names.push_back(text ? *text : number);
    }
    throw InputError(where, fmt::format("no {} is called '{}'", key, step), listOf(names),
                     didYouMean(step, names));
}

std::vector<std::string> stepsOf(const std::string& path) {
    std::vector<std::string> steps(1);
    for (const char c : path) {
        if (c == '.')
            steps.emplace_back();
        else
            steps.back() += c;
    }
    return steps;
}

} // namespace

void changeField(std::shared_ptr<TomlNode> root, const std::string& where, const std::string& path,
                 const std::string& value) {
    const TomlValue parsed = parseTomlValue(where, path, value);
    const std::vector<std::string> steps = stepsOf(path);
    std::shared_ptr<TomlNode> node = std::move(root);
    for (size_t i = 0; i + 1 < steps.size(); ++i) {
        const auto found = node->values.find(steps[i]);
        if (found == node->values.end()) {
            const std::vector<std::string> choices = tablesOf(*node);
            throw InputError(where, fmt::format("there is no table '{}'", joinPath(node->path, steps[i])),
                             listOf(choices), didYouMean(steps[i], choices));
        }
        const bool moreSteps = i + 2 < steps.size();
        if (const auto* table = found->second.as<std::shared_ptr<TomlNode>>())
            node = *table;
        else if (isTables(found->second) && moreSteps)
            node = elementNamed(where, steps[i], found->second, steps[i + 1]), ++i;
        else
            throw InputError(where, fmt::format("'{}' is {}", steps[i], describe(found->second)),
                             isTables(found->second) ? steps[i] + ".NAME.FIELD=VALUE" : "a table");
    }
    if (steps.back().empty()) throw InputError(where, "names no field", "TABLE.FIELD=VALUE");
    TomlValue& changed = node->values[steps.back()];
    changed = parsed;
    changed.line = node->line;
    changed.changedBy = where;
}

} // namespace plumbline
