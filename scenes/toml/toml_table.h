// Strict reader for all TOML files of the project: scenes, studies and manifests. The caller reads every
// field by name and type, and a field that was not read is an error.
//
//     TomlTable root = TomlTable::readFile("stone.toml");
//     const std::string purpose = root.text("purpose");
//     const int width = root.integer("width", 1, 4096, 800);   // with a default
//     root.finish();                                           // throws for fields that were not read
//
// Every failure is an InputError "file:line: field: what; expected …; did you mean …?".
#pragma once

#include "scenes/core/math.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline {

class ContentHash;
struct TomlNode; // toml_tree.h
struct TomlValue;

class TomlTable {
  public:
    static TomlTable readFile(const std::filesystem::path& file);
    /// `fileName` is used in messages.
    static TomlTable parse(const std::string& fileName, const std::string& text);

    /// Overrides or adds the field at `path`, for example "camera.width" or "object.torus.relief.depth", with
    /// `value` in TOML syntax. An element of [[tables]] is identified by its `name` or its index from 0. The
    /// tables along the path must exist. Messages about the new value begin with `where`, as does the
    /// InputError thrown for an invalid path or value.
    void change(const std::string& where, const std::string& path, const std::string& value);

    /// Adds the table's values to the hash, except for the field `except`. The hash doesn't depend on the
    /// order of fields, comments, whitespace or the notation of tables.
    void addTo(ContentHash& hash, std::string_view except) const;

    bool has(std::string_view key) const;
    std::vector<std::string> keys() const;

    // The field is required if there is no fallback. Numbers must be finite and within [low, high].
    std::string text(std::string_view key, std::optional<std::string> fallback = {}) const;
    /// A non-empty single-line string, for use in tables, pages and plots.
    std::string line(std::string_view key) const;
    bool boolean(std::string_view key, std::optional<bool> fallback = {}) const;
    int integer(std::string_view key, int low, int high, std::optional<int> fallback = {}) const;
    double number(std::string_view key, double low, double high, std::optional<double> fallback = {}) const;
    Vec2 vector2(std::string_view key, double low, double high, std::optional<Vec2> fallback = {}) const;
    Vec3 vector3(std::string_view key, double low, double high, std::optional<Vec3> fallback = {}) const;
    Vec2i integers2(std::string_view key, int low, int high, std::optional<Vec2i> fallback = {}) const;
    /// An array of any length.
    std::vector<int> integers(std::string_view key, int low, int high) const;
    /// One of `choices`.
    std::string choice(std::string_view key, const std::vector<std::string>& choices,
                       std::optional<std::string> fallback = {}) const;
    /// The field `name`: 1 to 64 of the characters a-z A-Z 0-9 _ -, because names become parts of channels,
    /// files and columns. It must not be in `taken`, to which it is added.
    std::string name(std::set<std::string>& taken) const;
    /// An array of strings.
    std::vector<std::string> texts(std::string_view key,
                                   std::optional<std::vector<std::string>> fallback = {}) const;
    /// An array of distinct non-empty strings.
    std::vector<std::string> distinctTexts(std::string_view key,
                                           std::optional<std::vector<std::string>> fallback = {}) const;
    /// An array of distinct elements of `choices`.
    std::vector<std::string> someOf(std::string_view key, const std::vector<std::string>& choices,
                                    std::optional<std::vector<std::string>> fallback = {}) const;
    /// A string or an array of strings.
    std::vector<std::string> textOrTexts(std::string_view key) const;
    /// A number, string or boolean, or an array of them, each in TOML syntax ("0.5", "\"text\"").
    std::vector<std::string> scalars(std::string_view key) const;
    /// `[key]` or `key = { … }`.
    TomlTable table(std::string_view key) const;
    /// `[[key]]` or `key = [{ … }, …]`, in file order; empty if there is none.
    std::vector<TomlTable> tables(std::string_view key) const;

    /// Throws if a field of this table was not read. Must be called for every table.
    void finish() const;

    /// The location of a field of this table, "file:line: path", or of the table itself if `key` is empty.
    std::string where(std::string_view key) const;
    /// Throws InputError about a field of this table, or about the table itself if `key` is empty.
    [[noreturn]] void fail(std::string_view key, std::string_view what, std::string_view expected = {},
                           std::string_view hint = {}) const;

  private:
    explicit TomlTable(std::shared_ptr<TomlNode> node);
    const TomlValue* find(std::string_view key) const;
    std::string where(std::string_view key, const TomlValue* value) const;
    /// Throws about an element of the array `key`, with the element's line.
    [[noreturn]] void failElement(std::string_view key, const TomlValue& element, std::string_view what,
                                  std::string_view expected, std::string_view hint = {}) const;
    [[noreturn]] void failMissing(std::string_view key, std::string_view expected) const;

    std::shared_ptr<TomlNode> node_;
};

} // namespace plumbline
