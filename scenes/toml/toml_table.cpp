#include "scenes/toml/toml_table.h"

#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/core/read_file.h"
#include "scenes/toml/toml_change.h"
#include "scenes/toml/toml_hash.h"
#include "scenes/toml/toml_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

std::string rangeText(const char* what, double low, double high) {
    constexpr double kUnlimited = std::numeric_limits<double>::max();
    if (low <= -kUnlimited && high >= kUnlimited) return fmt::format("a finite {}", what);
    if (high >= kUnlimited) return fmt::format("a finite {}, at least {}", what, low);
    return fmt::format("a {} from {} to {}", what, low, high);
}

double numberOf(const TomlTable& table, std::string_view key, const TomlValue& value, double low,
                double high) {
    const auto* integer = value.as<int64_t>();
    const auto* floating = value.as<double>();
    const double number = integer ? static_cast<double>(*integer) : floating ? *floating : 0.0;
    // The negated comparison rejects NaN.
    if ((!integer && !floating) || !(number >= low && number <= high) || !std::isfinite(number))
        table.fail(key, "is " + describe(value), rangeText("number", low, high));
    return number;
}

int integerOf(const TomlTable& table, std::string_view key, const TomlValue& value, int low, int high) {
    const auto* integer = value.as<int64_t>();
    if (!integer || *integer < low || *integer > high)
        table.fail(key, "is " + describe(value), fmt::format("a whole number from {} to {}", low, high));
    return static_cast<int>(*integer);
}

const TomlValue::Array& arrayOf(const TomlTable& table, std::string_view key, const TomlValue& value,
                                size_t length) {
    const auto* array = value.as<TomlValue::Array>();
    if (!array || array->size() != length)
        table.fail(key, "is " + describe(value), fmt::format("an array of {} numbers", length));
    return *array;
}

template <class Vector>
Vector vectorOf(const TomlTable& table, std::string_view key, const TomlValue& value, double low,
                double high) {
    const auto& array = arrayOf(table, key, value, static_cast<size_t>(Vector::length()));
    Vector vector;
    for (int axis = 0; axis < Vector::length(); ++axis)
        vector[axis] = numberOf(table, key, array[static_cast<size_t>(axis)], low, high);
    return vector;
}

} // namespace

TomlTable::TomlTable(std::shared_ptr<TomlNode> node) : node_(std::move(node)) {}

TomlTable TomlTable::readFile(const std::filesystem::path& file) {
    return parse(file.string(), readWholeFile(file, kMostTomlBytes));
}

TomlTable TomlTable::parse(const std::string& fileName, const std::string& text) {
    return TomlTable(parseToml(fileName, text));
}

void TomlTable::change(const std::string& where, const std::string& path, const std::string& value) {
    changeField(node_, where, path, value);
}

void TomlTable::addTo(ContentHash& hash, std::string_view except) const {
    addTree(hash, *node_, except);
}

bool TomlTable::has(std::string_view key) const {
    return find(key) != nullptr;
}

std::vector<std::string> TomlTable::keys() const {
    std::vector<std::string> names;
    for (const auto& [name, value] : node_->values)
        names.push_back(name);
    return names;
}

const TomlValue* TomlTable::find(std::string_view key) const {
    node_->known.emplace(key);
    const auto found = node_->values.find(key);
    return found == node_->values.end() ? nullptr : &found->second;
}

std::string TomlTable::where(std::string_view key, const TomlValue* value) const {
    const std::string path = joinPath(node_->path, key);
    return fmt::format("{}:{}{}{}", node_->file, value ? value->line : node_->line, path.empty() ? "" : ": ",
                       path);
}

std::string TomlTable::where(std::string_view key) const {
    const auto found = node_->values.find(key);
    if (found == node_->values.end()) return where(key, nullptr);
    return found->second.changedBy.empty() ? where(key, &found->second) : found->second.changedBy;
}

void TomlTable::failElement(std::string_view key, const TomlValue& element, std::string_view what,
                            std::string_view expected, std::string_view hint) const {
    const bool changed = !node_->values.find(key)->second.changedBy.empty();
    throw InputError(changed ? where(key) : where(key, &element), what, expected, hint);
}

void TomlTable::fail(std::string_view key, std::string_view what, std::string_view expected,
                     std::string_view hint) const {
    throw InputError(where(key), what, expected, hint);
}

void TomlTable::failMissing(std::string_view key, std::string_view expected) const {
    fail(key, "is missing", expected);
}

std::string TomlTable::text(std::string_view key, std::optional<std::string> fallback) const {
    const TomlValue* value = find(key);
    if (!value && fallback) return *fallback;
    if (!value) failMissing(key, "a string");
    const auto* text = value->as<std::string>();
    if (!text) fail(key, "is " + describe(*value), "a string in quotes");
    return *text;
}

std::string TomlTable::line(std::string_view key) const {
    const TomlValue* value = find(key);
    if (!value) failMissing(key, "a single-line string");
    const auto* text = value->as<std::string>();
    if (!text) fail(key, "is " + describe(*value), "a string in quotes");
    if (text->empty() || printable(*text) != *text)
        fail(key, text->empty() ? "is empty" : "has a control character", "a single-line string");
    return *text;
}

bool TomlTable::boolean(std::string_view key, std::optional<bool> fallback) const {
    const TomlValue* value = find(key);
    if (!value && fallback) return *fallback;
    if (!value) failMissing(key, "true or false");
    const auto* boolean = value->as<bool>();
    if (!boolean) fail(key, "is " + describe(*value), "true or false");
    return *boolean;
}

int TomlTable::integer(std::string_view key, int low, int high, std::optional<int> fallback) const {
    const TomlValue* value = find(key);
    if (!value && fallback) return *fallback;
    if (!value) failMissing(key, fmt::format("a whole number from {} to {}", low, high));
    return integerOf(*this, key, *value, low, high);
}

double TomlTable::number(std::string_view key, double low, double high,
                         std::optional<double> fallback) const {
    const TomlValue* value = find(key);
    if (!value && fallback) return *fallback;
    if (!value) failMissing(key, rangeText("number", low, high));
    return numberOf(*this, key, *value, low, high);
}

Vec2 TomlTable::vector2(std::string_view key, double low, double high, std::optional<Vec2> fallback) const {
    const TomlValue* value = find(key);
    if (!value && fallback) return *fallback;
    if (!value) failMissing(key, "[x, y]");
    return vectorOf<Vec2>(*this, key, *value, low, high);
}

Vec3 TomlTable::vector3(std::string_view key, double low, double high, std::optional<Vec3> fallback) const {
    const TomlValue* value = find(key);
    if (!value && fallback) return *fallback;
    if (!value) failMissing(key, "[x, y, z]");
    return vectorOf<Vec3>(*this, key, *value, low, high);
}

Vec2i TomlTable::integers2(std::string_view key, int low, int high, std::optional<Vec2i> fallback) const {
    const TomlValue* value = find(key);
    if (!value && fallback) return *fallback;
    if (!value) failMissing(key, "two whole numbers");
    const auto& array = arrayOf(*this, key, *value, 2);
    return {integerOf(*this, key, array[0], low, high), integerOf(*this, key, array[1], low, high)};
}

std::vector<int> TomlTable::integers(std::string_view key, int low, int high) const {
    const TomlValue* value = find(key);
    if (!value) failMissing(key, "an array of whole numbers");
    const auto* array = value->as<TomlValue::Array>();
    if (!array) fail(key, "is " + describe(*value), "an array of whole numbers");
    std::vector<int> result;
    for (const TomlValue& element : *array)
        result.push_back(integerOf(*this, key, element, low, high));
    return result;
}

std::string TomlTable::choice(std::string_view key, const std::vector<std::string>& choices,
                              std::optional<std::string> fallback) const {
    const TomlValue* value = find(key);
    if (!value && fallback) return *fallback;
    if (!value) failMissing(key, listOf(choices));
    const auto* text = value->as<std::string>();
    if (!text || std::find(choices.begin(), choices.end(), *text) == choices.end())
        fail(key, "is " + describe(*value), listOf(choices),
             text ? didYouMean(*text, choices) : std::string());
    return *text;
}

std::string TomlTable::name(std::set<std::string>& taken) const {
    std::string name = text("name");
    const auto allowed = [](unsigned char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    };
    if (name.empty() || name.size() > 64 || !std::all_of(name.begin(), name.end(), allowed))
        fail("name", fmt::format("is \"{}\"", name.substr(0, 64)), "1 to 64 of the letters a-z A-Z 0-9 _ -");
    if (!taken.insert(name).second) fail("name", fmt::format("\"{}\" is taken already", name), "another one");
    return name;
}

std::vector<std::string> TomlTable::texts(std::string_view key,
                                          std::optional<std::vector<std::string>> fallback) const {
    const TomlValue* value = find(key);
    if (!value && fallback) return *fallback;
    if (!value) failMissing(key, "an array of strings");
    const auto* array = value->as<TomlValue::Array>();
    if (!array) fail(key, "is " + describe(*value), "an array of strings");
    std::vector<std::string> result;
    for (const TomlValue& element : *array) {
        const auto* text = element.as<std::string>();
        if (!text) failElement(key, element, "holds " + describe(element), "strings");
        result.push_back(*text);
    }
    return result;
}

std::vector<std::string> TomlTable::distinctTexts(std::string_view key,
                                                  std::optional<std::vector<std::string>> fallback) const {
    const TomlValue* value = find(key);
    std::vector<std::string> result = texts(key, std::move(fallback));
    if (!value) return result;
    const auto& elements = *value->as<TomlValue::Array>();
    for (size_t i = 0; i < result.size(); ++i) {
        if (result[i].empty()) failElement(key, elements[i], "holds an empty string", "strings");
        if (std::find(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(i), result[i]) !=
            result.begin() + static_cast<std::ptrdiff_t>(i))
            failElement(key, elements[i], fmt::format("holds \"{}\" twice", result[i]), "each once");
    }
    return result;
}

std::vector<std::string> TomlTable::someOf(std::string_view key, const std::vector<std::string>& choices,
                                           std::optional<std::vector<std::string>> fallback) const {
    const TomlValue* value = find(key);
    if (!value && !fallback) failMissing(key, "an array with some of " + listOf(choices));
    std::vector<std::string> result = distinctTexts(key, std::move(fallback));
    if (!value) return result;
    const auto& elements = *value->as<TomlValue::Array>();
    for (size_t i = 0; i < result.size(); ++i)
        if (std::find(choices.begin(), choices.end(), result[i]) == choices.end())
            failElement(key, elements[i], "holds " + describe(elements[i]), listOf(choices),
                        didYouMean(result[i], choices));
    return result;
}

std::vector<std::string> TomlTable::textOrTexts(std::string_view key) const {
    const TomlValue* value = find(key);
    if (!value) failMissing(key, "a string or an array of strings");
    if (const auto* text = value->as<std::string>()) return {*text};
    if (!value->as<TomlValue::Array>())
        fail(key, "is " + describe(*value), "a string or an array of strings");
    return texts(key);
}

std::vector<std::string> TomlTable::scalars(std::string_view key) const {
    const TomlValue* value = find(key);
    if (!value) failMissing(key, "a number, a string, true, false, or an array of them");
    const auto* array = value->as<TomlValue::Array>();
    std::vector<std::string> result;
    for (const TomlValue& element : array ? *array : TomlValue::Array{*value}) {
        if (const auto* text = element.as<std::string>()) {
            if (text->find_first_of("\"\\\n") != std::string::npos)
                fail(key, "holds " + describe(element),
                     "a single-line string, without quotes and backslashes");
            result.push_back('"' + *text + '"');
        } else if (const auto* number = element.as<double>()) {
            result.push_back(fmt::format("{}", *number)); // 3.0 as 3
        } else if (element.as<bool>() || element.as<int64_t>()) {
            result.push_back(describe(element));
        } else {
            fail(key, "holds " + describe(element), "numbers, strings, true or false");
        }
    }
    return result;
}

TomlTable TomlTable::table(std::string_view key) const {
    const TomlValue* value = find(key);
    if (!value) failMissing(key, fmt::format("a table [{}]", joinPath(node_->path, key)));
    const auto* node = value->as<std::shared_ptr<TomlNode>>();
    if (!node) fail(key, "is " + describe(*value), "a table");
    return TomlTable(*node);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
    const TomlValue* value = find(key);
    if (!value) return {};
    const auto* array = value->as<TomlValue::Array>();
    if (!array) fail(key, "is " + describe(*value), fmt::format("tables [[{}]]", joinPath(node_->path, key)));
    std::vector<TomlTable> result;
    for (const TomlValue& element : *array) {
        const auto* node = element.as<std::shared_ptr<TomlNode>>();
        if (!node) fail(key, "holds " + describe(element), "tables");
        result.push_back(TomlTable(*node));
    }
    return result;
}

void TomlTable::finish() const {
    const std::vector<std::string> known(node_->known.begin(), node_->known.end());
    for (const auto& [name, value] : node_->values)
        if (!node_->known.contains(name)) fail(name, "unknown field", listOf(known), didYouMean(name, known));
}

} // namespace plumbline
