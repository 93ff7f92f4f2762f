// TOML text and the tree of values it says. toml++ is included in toml_tree.cpp alone.
//
// Lines count from 1. Trees are shared: a table handed out (toml_table.h) remembers what was asked for in it.
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
    std::string changedBy; // empty: it is the file's own
    /// monostate: a date or time, which no field takes.
    std::variant<std::monostate, bool, int64_t, double, std::string, Array, std::shared_ptr<TomlNode>>
        content;

    template <class T>
    const T* as() const {
        return std::get_if<T>(&content);
    }
};

/// A table, where it stands, and what was asked for in it.
struct TomlNode {
    std::string file;
    std::string path; // "camera", "object.relief"; empty for the root
    int line = 1;
    std::map<std::string, TomlValue, std::less<>> values;
    std::set<std::string, std::less<>> known; // asked for, present or not
};

/// Throws InputError "FILE:LINE: is not valid TOML: …". `fileName` is for messages.
std::shared_ptr<TomlNode> parseToml(const std::string& fileName, const std::string& text);
/// One value, as TOML writes it behind `=`; tables in it get paths below `path`. Throws InputError about
/// `where`.
TomlValue parseTomlValue(const std::string& where, const std::string& path, const std::string& text);
/// A text in quotes with its escapes; nothing for bytes that aren't UTF-8.
std::optional<std::string> tomlText(const std::string& text);

/// "camera.width"; either may be empty.
std::string joinPath(const std::string& path, std::string_view key);
/// "3", "the text \"x\"", "a table": for messages.
std::string describe(const TomlValue& value);

} // namespace plumbline
