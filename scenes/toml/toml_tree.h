// Parses TOML text to a tree of values. Only toml_tree.cpp includes toml++.
//
// Lines count from 1. Nodes are shared, because each records which of its fields were read through TomlTable
// (toml_table.h).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace plumbline {

struct TomlNode;

struct TomlValue {
    using Array = std::vector<TomlValue>;
    int line = 0;
    std::string changedBy; // empty: the value in the file
    /// monostate: a date or time, which no field takes.
    std::variant<std::monostate, bool, int64_t, double, std::string, Array, std::shared_ptr<TomlNode>>
        content;

    template <class T>
    const T* as() const {
        return std::get_if<T>(&content);
    }
};

/// A table, its location, and the fields that were read from it.
struct TomlNode {
    std::string file;
    std::string path; // "camera", "object.relief"; empty for the root
    int line = 1;
    std::map<std::string, TomlValue, std::less<>> values;
    std::set<std::string, std::less<>> known; // fields read, whether present or not
};

/// Throws InputError "FILE:LINE: is not valid TOML: …". `fileName` is used in messages.
std::shared_ptr<TomlNode> parseToml(const std::string& fileName, const std::string& text);
/// Parses one value in TOML syntax; tables in it get paths below `path`. Throws InputError about `where`.
TomlValue parseTomlValue(const std::string& where, const std::string& path, const std::string& text);
/// The text as a TOML string with quotes and escapes; nothing if it isn't UTF-8.
std::optional<std::string> tomlText(const std::string& text);

/// "camera.width"; either may be empty.
std::string joinPath(const std::string& path, std::string_view key);
/// "3", "the string \"x\"", "a table": for messages.
std::string describe(const TomlValue& value);

} // namespace plumbline
