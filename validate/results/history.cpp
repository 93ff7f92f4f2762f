#include "validate/results/history.h"

#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "validate/results/flat_figures.h"
#include "validate/results/json_text.h"
#include "validate/results/results.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace plumbline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kResultsExpected = "results.json of validate or compare";
constexpr const char* kRecordExpected = "a line that plumbline history wrote";

/// A JSON file, or a line of one. Fields are read by name; errors give their path.
class Source {
  public:
    Source(std::string where, const char* expected, const std::string& text)
        : where_(std::move(where)), expected_(expected) {
        json_ = parseJson(where_, text);
        if (json_.is_discarded()) fail("is not valid JSON");
        if (!json_.is_object()) fail("is not a JSON object");
    }

    [[noreturn]] void fail(const std::string& what) const { throw InputError(where_, what, expected_); }

    void requireSchema(int schema) const {
        const json& found = field(json_, "schema", "");
        if (!found.is_number_integer() || found != schema)
            throw InputError(
                where_, fmt::format("schema is {}", found.is_number() ? found.dump() : found.type_name()),
                fmt::format("{}", schema), "another version of the program wrote the file");
    }

    const json& field(const json& object, const char* key, const std::string& path) const {
        const auto found = object.is_object() ? object.find(key) : object.end();
        if (!object.is_object() || found == object.end()) fail(fmt::format("has no {}{}", path, key));
        return *found;
    }
    /// `orNull`: null is accepted and read as an empty text.
    std::string text(const json& object, const char* key, const std::string& path,
                     bool orNull = false) const {
        const json& found = field(object, key, path);
        if (orNull && found.is_null()) return {};
        if (!found.is_string()) fail(fmt::format("{}{} is not a text", path, key));
        return printable(found.get<std::string>());
    }
    std::map<std::string, double> numbers(const json& object, const char* key,
                                          const std::string& path) const {
        const json& found = field(object, key, path);
        std::map<std::string, double> result;
        if (!found.is_object()) fail(fmt::format("{}{} is not an object", path, key));
        for (const auto& [name, number] : found.items()) {
            if (!number.is_number()) fail(fmt::format("{}{}.{} is not a number", path, key, name));
            result[name] = number.get<double>();
        }
        return result;
    }
    const json& root() const { return json_; }

    /// `read`: reads the figures of an element, given its path.
    template <class Read>
    std::vector<HistoryTechnique> techniques(const Read& read) const {
        const json& found = field(json_, "techniques", "");
        if (!found.is_array() || found.empty()) fail("contains no technique");
        std::vector<HistoryTechnique> result;
        std::set<std::string> names;
        for (const json& element : found) {
            const std::string path = fmt::format("techniques[{}].", result.size());
            HistoryTechnique technique;
            technique.name = text(element, "name", path);
            technique.error = text(element, "error", path, true);
            if (!names.insert(technique.name).second)
                fail(fmt::format("contains '{}' twice", technique.name));
            if (technique.error.empty()) technique.figures = read(element, path);
            result.push_back(std::move(technique));
        }
        return result;
    }

  private:
    std::string where_;
    const char* expected_;
    json json_;
};

/// Integers are written without a decimal point, because most figures are counts of pixels.
ordered_json numberJson(double number) {
    constexpr double kExact = 1e15; // every integer up to this one is exact in double
    if (std::floor(number) == number && std::abs(number) < kExact) return static_cast<int64_t>(number);
    return number;
}

ordered_json numbersJson(const std::map<std::string, double>& numbers) {
    ordered_json result = ordered_json::object();
    for (const auto& [name, number] : numbers)
        result[name] = numberJson(number);
    return result;
}

HistoryRecord readRecord(const Source& source) {
    source.requireSchema(kHistorySchema);
    HistoryRecord record;
    record.label = source.text(source.root(), "label", "");
    record.program = source.text(source.root(), "program", "");
    const json& scene = source.field(source.root(), "scene", "");
    record.scene = source.text(scene, "name", "scene.");
    record.sceneHash = source.text(scene, "hash", "scene.");
    record.base = source.text(source.root(), "base", "", true);
    record.certificate = source.numbers(source.root(), "reference", "");
    record.techniques = source.techniques([&](const json& technique, const std::string& path) {
        return source.numbers(technique, "figures", path);
    });
    return record;
}

} // namespace

HistoryRecord recordOf(const std::string& where, const std::string& resultsJson,
                       const std::optional<std::string>& label) {
    const Source source(where, kResultsExpected, resultsJson);
    source.requireSchema(kResultsSchema);
    HistoryRecord record;
    record.program = source.text(source.root(), "program", "");
    record.label = label.value_or(record.program);
    const json& scene = source.field(source.root(), "scene", "");
    record.scene = source.text(scene, "name", "scene.");
    record.sceneHash = source.text(scene, "hash", "scene.");
    record.base = source.text(source.root(), "base", "", true);
    for (const auto& [key, value] : source.field(source.root(), "reference", "").items())
        if (key.starts_with("error_") && value.is_number()) record.certificate[key] = value.get<double>();
    record.techniques = source.techniques([&](const json& technique, const std::string& path) {
        source.field(technique, "silhouette", path); // fails for a technique without figures
        std::map<std::string, double> figures;
        addFlatFigures(technique, "", figures);
        return figures;
    });
    return record;
}

std::string toLine(const HistoryRecord& record) {
    ordered_json line{{"schema", kHistorySchema}, {"label", record.label}, {"program", record.program}};
    line["scene"] = {{"name", record.scene}, {"hash", record.sceneHash}};
    line["base"] = record.base.empty() ? ordered_json(nullptr) : ordered_json(record.base);
    line["reference"] = numbersJson(record.certificate);
    line["techniques"] = ordered_json::array();
    for (const HistoryTechnique& technique : record.techniques) {
        ordered_json entry{{"name", technique.name}};
        if (technique.error.empty()) entry["figures"] = numbersJson(technique.figures);
        entry["error"] = technique.error.empty() ? ordered_json(nullptr) : ordered_json(technique.error);
        line["techniques"].push_back(std::move(entry));
    }
    return line.dump(-1, ' ', true, ordered_json::error_handler_t::replace) + "\n";
}

std::vector<HistoryRecord> readHistory(const std::string& where, const std::string& text) {
    std::vector<HistoryRecord> records;
    int number = 0;
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        ++number;
        begin = end + 1;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        records.push_back(readRecord(Source(fmt::format("{}:{}", where, number), kRecordExpected, line)));
    }
    return records;
}

} // namespace plumbline
