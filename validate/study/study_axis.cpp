#include "validate/study/study_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace plumbline {
namespace {

constexpr double kLargest = 1e12; // ends of a range; the fields of scenes have narrower limits
constexpr int kMaxSteps = 1000000;

bool isPathCharacter(unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
}

std::vector<std::string> valuesOfRange(const TomlTable& table) {
    const Vec2 range = table.vector2("range", -kLargest, kLargest);
    const int steps = table.integer("steps", 1, kMaxSteps);
    const bool log = table.choice("spacing", {"linear", "log"}, "linear") == "log";
    if (!(range.x < range.y))
        table.fail("range", fmt::format("[{}, {}] is empty", range.x, range.y), "[lowest, highest]");
    if (log && !(range.x > 0))
        table.fail("range", fmt::format("begins at {}", range.x), "above 0 with spacing \"log\"");
    if (steps == 1) table.fail("steps", "is 1", "at least 2, for both ends of the range");
    std::vector<std::string> values;
    for (int i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) / (steps - 1);
        const double value =
            log ? range.x * std::pow(range.y / range.x, t) : range.x + t * (range.y - range.x);
        values.push_back(fmt::format("{:.9g}", value)); // without rounding errors in the last digits
    }
    return values;
}

} // namespace

std::vector<std::string> readStudyValues(const TomlTable& table, const std::string& key, bool plain) {
    std::vector<std::string> values = table.scalars(key);
    if (values.empty()) table.fail(key, "is empty", "at least one value");
    if (plain)
        for (std::string& value : values)
            if (value.size() >= 2 && value.front() == '"') value = value.substr(1, value.size() - 2);
    return values;
}

StudyAxis readStudyAxis(const TomlTable& table, const std::string& name) {
    StudyAxis axis{name, {}, {}};
    if (table.has("field") == table.has("fields"))
        table.fail({}, table.has("field") ? "has both field and fields" : "changes nothing",
                   "field = \"camera.width\", or fields = […] that all get the same value");
    axis.fields =
        table.has("field") ? std::vector<std::string>{table.text("field")} : table.distinctTexts("fields");
    if (axis.fields.empty()) table.fail("fields", "is empty", "at least one");
    for (const std::string& field : axis.fields)
        if (field.empty() || !std::all_of(field.begin(), field.end(), isPathCharacter))
            table.fail(table.has("field") ? "field" : "fields",
                       fmt::format("has \"{}\"", field.substr(0, 64)),
                       "keys of the scene separated by dots, for example camera.width");
    if (table.has("values") == table.has("range"))
        table.fail({}, table.has("values") ? "has both values and range" : "has no values",
                   "values = […], or range = [lowest, highest] and steps");
    axis.values = table.has("values") ? readStudyValues(table, "values", false) : valuesOfRange(table);
    std::vector<std::string> sorted = axis.values;
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
        table.fail(table.has("values") ? "values" : "range", fmt::format("{} occurs twice", *twice),
                   "each once");
    table.finish();
    return axis;
}

} // namespace plumbline
