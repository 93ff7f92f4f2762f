#include "validate/results/requirement.h"

#include "scenes/core/error.h"
#include "validate/metrics/metric_table.h"
#include "validate/results/results.h"
#include "validate/results/row_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace plumbline {
namespace {

const char* const kForm = "METRIC[@OBJECT] >= NUMBER, or with >, <=, <";
const std::string kShadow = "shadow.";

std::string trimmed(const std::string& text) {
    const size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
    return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

double parseBound(const std::string& text, const std::string& where) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw InputError(where, fmt::format("'{}' is no finite number", text), kForm);
    return value;
}

/// Splits "shadow.<light>.<key>" unless that is a key by itself.
void splitLight(Requirement& requirement) {
    const std::string whole = requirement.key;
    const size_t last = whole.rfind('.');
    if (findMetric(whole) || !whole.starts_with(kShadow) || last < kShadow.size()) return;
    requirement.light = whole.substr(kShadow.size(), last - kShadow.size());
    requirement.key = kShadow + whole.substr(last + 1);
}

[[noreturn]] void refuseMetric(const Requirement& requirement) {
    const std::string infix = requirement.light.empty() ? "" : requirement.light + ".";
    std::vector<std::string> known;
    for (const MetricInfo& metric : metricTable())
        known.push_back(metric.key.starts_with(kShadow) ? kShadow + infix + metric.key.substr(kShadow.size())
                                                        : metric.key);
    const std::string found = requirement.light.empty()
                                  ? requirement.key
                                  : kShadow + infix + requirement.key.substr(kShadow.size());
    throw InputError(requirement.where, fmt::format("no metric is called '{}'", found),
                     "a key of 'plumbline list metrics'", didYouMean(found, known));
}

void requireName(const Requirement& requirement, const char* what, const std::string& name,
                 std::span<const std::string> names) {
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
    throw InputError(requirement.where, fmt::format("no {} is called '{}'", what, name),
                     names.empty() ? fmt::format("none: there is no {}", what) : listOf(names),
                     didYouMean(name, names));
}

bool reaches(double value, const Requirement& requirement) {
    if (requirement.comparison == ">=") return value >= requirement.bound;
    if (requirement.comparison == ">") return value > requirement.bound;
    if (requirement.comparison == "<=") return value <= requirement.bound;
    return value < requirement.bound;
}

/// The object's figures or the pooled ones; nullptr if no object has that name.
const MetricSet* metricsOf(const Comparison& comparison, const std::string& object) {
    if (object.empty()) return &comparison.pooled;
    const auto found =
        std::find_if(comparison.objects.begin(), comparison.objects.end(),
                     [&](const ObjectComparison& entry) { return entry.object.name == object; });
    return found == comparison.objects.end() ? nullptr : &found->metrics;
}

Figure figureOf(const TechniqueOutcome& technique, const Requirement& requirement, const std::string& light) {
    if (technique.error) return Figure::absent("the technique failed");
    const Comparison& comparison = technique.comparison;
    const MetricSet* metrics = metricsOf(comparison, requirement.object);
    if (!metrics) return Figure::absent("neither frame shows the object");
    const bool ofLight = requirement.key.starts_with(kShadow);
    if (ofLight && !metrics->shadow.contains(light))
        return Figure::absent(light.empty() ? "neither frame has a channel shadow.<light>"
                                            : "neither frame has a channel " + kShadow + light);
    for (const MetricValue& entry :
         rowValues(*metrics, light, requirement.object.empty() ? &comparison.image : nullptr, &technique)) {
        if (entry.key != requirement.key) continue;
        if (const auto* count = std::get_if<uint64_t>(&entry.value)) return {static_cast<double>(*count)};
        return std::get<Figure>(entry.value);
    }
    return Figure::absent("not among the results");
}

/// The lights it is about; one without a name where none is known.
std::vector<std::string> lightsOf(const TechniqueOutcome& technique, const Requirement& requirement) {
    if (!requirement.key.starts_with(kShadow) || !requirement.light.empty()) return {requirement.light};
    std::vector<std::string> lights;
    for (const auto& [light, shadow] : technique.comparison.pooled.shadow)
        lights.push_back(light);
    return lights.empty() ? std::vector<std::string>{""} : lights;
}

std::string keyOf(const Requirement& requirement, const std::string& light) {
    const std::string key =
        light.empty() ? requirement.key : kShadow + light + "." + requirement.key.substr(kShadow.size());
    return requirement.object.empty() ? key : key + "@" + requirement.object;
}

} // namespace

Requirement parseRequirement(const std::string& text, const std::string& where) {
    Requirement requirement;
    requirement.where = where;
    const size_t at = text.find_first_of("<>");
    if (at == std::string::npos)
        throw InputError(where, fmt::format("'{}' compares with nothing", text), kForm);
    const size_t length = at + 1 < text.size() && text[at + 1] == '=' ? 2 : 1;
    requirement.comparison = text.substr(at, length);
    const std::string bound = trimmed(text.substr(at + length));
    requirement.bound = parseBound(bound, where);
    requirement.key = trimmed(text.substr(0, at));
    if (const size_t object = requirement.key.find('@'); object != std::string::npos) {
        requirement.object = trimmed(requirement.key.substr(object + 1));
        requirement.key = trimmed(requirement.key.substr(0, object));
        if (requirement.object.empty()) throw InputError(where, "nothing follows '@'", kForm);
    }
    requirement.text = fmt::format("{}{}{} {} {}", requirement.key, requirement.object.empty() ? "" : "@",
                                   requirement.object, requirement.comparison, bound);
    splitLight(requirement);
    const MetricInfo* metric = findMetric(requirement.key);
    if (!metric) refuseMetric(requirement);
    if (!metric->perObject && !requirement.object.empty())
        throw InputError(where, fmt::format("no object has a {} of its own", requirement.key),
                         requirement.key + " without '@'");
    return requirement;
}

void checkNames(const Requirement& requirement, std::span<const std::string> lights,
                std::span<const std::string> objects) {
    requireName(requirement, "light", requirement.light, lights);
    requireName(requirement, "object", requirement.object, objects);
}

std::vector<RequirementResult> holdAgainst(std::span<const Requirement> requirements,
                                           const TechniqueOutcome& technique) {
    std::vector<RequirementResult> results;
    for (const Requirement& requirement : requirements)
        for (const std::string& light : lightsOf(technique, requirement)) {
            const Figure value = figureOf(technique, requirement, light);
            results.push_back(
                {requirement.text, keyOf(requirement, light), value, value && reaches(*value, requirement)});
        }
    return results;
}

} // namespace plumbline
