// TOML files read strictly, all of the project's: scenes, studies, manifests. Every field is asked for by
// name and type, and what nobody asked for is an error.
//
//     TomlTable root = TomlTable::readFile("stone.toml");
//     const std::string purpose = root.text("purpose");
//     const int width = root.integer("width", 1, 4096, 800);   // with a default
//     root.finish();                                           // throws for fields not asked for
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
    /// `fileName` is for messages.
    static TomlTable parse(const std::string& fileName, const std::string& text);

    /// Puts `value`, as TOML writes it, in the place of a field, or adds the field: "camera.width",
    /// "object.torus.relief.depth". An element of [[tables]] goes by its `name` or its number from 0; the
    /// tables on the way must be there. Messages about what was put there begin with `where`. Throws
    /// InputError that begins so.
    void change(const std::string& where, const std::string& path, const std::string& value);

    /// Adds what the table says, all but the field `except`: neither the order of fields matters nor what is
    /// no value (comments, blanks, how a table is written).
    void addTo(ContentHash& hash, std::string_view except) const;

    bool has(std::string_view key) const;
    std::vector<std::string> keys() const;

    // Without a fallback the field is required. Numbers must be finite and within [low, high].
    std::string text(std::string_view key, std::optional<std::string> fallback = {}) const;
    /// A text of one line, not empty: it ends up in tables, pages and plots.
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
    /// The field `name`: 1 to 64 of the letters a-z A-Z 0-9 _ -, none of those in `taken`, to which it is
    /// added. Names become parts of channels, files and columns.
    std::string name(std::set<std::string>& taken) const;
    /// An array of texts.
    std::vector<std::string> texts(std::string_view key,
                                   std::optional<std::vector<std::string>> fallback = {}) const;
    /// An array of texts, none of them empty, each once.
    std::vector<std::string> distinctTexts(std::string_view key,
                                           std::optional<std::vector<std::string>> fallback = {}) const;
    /// An array of some of `choices`, each once.
    std::vector<std::string> someOf(std::string_view key, const std::vector<std::string>& choices,
                                    std::optional<std::vector<std::string>> fallback = {}) const;
    /// A text or an array of texts.
    std::vector<std::string> textOrTexts(std::string_view key) const;
    /// A number, text or boolean, or an array of them: each as TOML writes it ("0.5", "\"text\"").
    std::vector<std::string> scalars(std::string_view key) const;
    /// `[key]` or `key = { … }`.
    TomlTable table(std::string_view key) const;
    /// `[[key]]` or `key = [{ … }, …]`, in the order of the file; empty if there is none.
    std::vector<TomlTable> tables(std::string_view key) const;

    /// Throws for a field of this table nobody asked for. Call it for every table.
    void finish() const;

    /// Where a field of this table stands, "file:line: path", or the table itself if `key` is empty.
    std::string where(std::string_view key) const;
    /// Throws InputError about a field of this table, or about the table itself if `key` is empty.
    [[noreturn]] void fail(std::string_view key, std::string_view what, std::string_view expected = {},
                           std::string_view hint = {}) const;

  private:
    explicit TomlTable(std::shared_ptr<TomlNode> node);
    const TomlValue* find(std::string_view key) const;
    std::string where(std::string_view key, const TomlValue* value) const;
    /// About an element of the array `key`: on its own line.
    [[noreturn]] void failElement(std::string_view key, const TomlValue& element, std::string_view what,
                                  std::string_view expected, std::string_view hint = {}) const;
    [[noreturn]] void failMissing(std::string_view key, std::string_view expected) const;

    std::shared_ptr<TomlNode> node_;
};

} // namespace plumbline
