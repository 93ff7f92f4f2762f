// The tables of a TOML file as toml_file.cpp and toml_change.cpp hold them.
#pragma once

#include "scenes/toml/toml_file.h"

#include <toml++/toml.h>

#include <cstdint>
#include <map>
#include <set>
#include <variant>

namespace plumbline {

/// A value of the file in our own terms.
struct TomlValue {
    using Array = std::vector<TomlValue>;
    int line = 0;
    std::string changedBy; // empty: it is the file's own
    /// Nothing stands for dates and times, which no field of ours takes.
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

/// Throws InputError for dotted keys that make more tables within each other than a stack holds of a parser's
/// steps, also through inline tables; nested values the parser limits itself.
void checkKeyDepth(const std::string& where, std::string_view text);

/// "camera.width"; either may be empty.
std::string joinPath(const std::string& path, std::string_view key);
TomlValue convertValue(const toml::node& node, const std::string& file, const std::string& path);
/// "3", "the text \"x\"", "a table": for messages.
std::string describe(const TomlValue& value);

} // namespace plumbline
