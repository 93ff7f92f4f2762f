// A manifest's TOML table field by field: each is asked for by name and type, what is wrong is told with its
// line, and what nobody asked for is an error.
#pragma once

#include "realtime/gl/gl_program.h"
#include "realtime/technique/manifest.h"
#include "scenes/core/error.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <set>

namespace plumbline {

/// A TOML table that remembers which of its keys were asked for.
class Fields {
  public:
    Fields(const std::filesystem::path& file, const toml::table& table, std::string prefix)
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
    const std::filesystem::path& file_;
    const toml::table& table_;
    std::string prefix_;
    std::set<std::string> known_;
};

/// Throws InputError with the line.
inline toml::table parseFile(const std::filesystem::path& file) {
    const std::string text = readText(file);
    try {
        return toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}:{}", file.string(), error.source().begin.line), error.description());
    }
}

/// The list `parameter` of a manifest, if there is one. Throws InputError.
void readParameters(const std::filesystem::path& file, Fields& fields, Manifest& manifest);

} // namespace plumbline
