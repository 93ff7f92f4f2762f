#include "validate/results/requirement.h"

#include "scenes/core/error.h"
#include "scenes/core/numbers.h"
#include "validate/metrics/metric_registry.h"
#include "validate/results/results.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

const char* const kForm = "METRIC[@OBJECT] >= NUMBER, or with >, <=, <";

std::string trimmed(const std::string& text) {
    const size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
    return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

double parseBound(const std::string& text, const std::string& where) {
    const std::optional<double> bound = parseNumber<double>(text);
    if (!bound) throw InputError(where, fmt::format("'{}' is not a finite number", text), kForm);
    return *bound;
}

[[noreturn]] void refuseMetric(const Requirement& requirement) {
    std::vector<std::string> known;
    for (const MetricInfo& metric : metricTable())
        known.push_back(metric.scope == Scope::ObjectsByLight ? textOf({metric.key, requirement.light})
                                                              : metric.key);
    const std::string found = textOf({requirement.key, requirement.light});
    throw InputError(requirement.where, fmt::format("no metric is called '{}'", found),
                     "a key of 'plumbline list metrics'", didYouMean(found, known));
}

void requireName(const Requirement& requirement, const char* what, const std::string& name,
                 std::span<const std::string> names) {
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
    throw InputError(requirement.where, fmt::format("no {} is called '{}'", what, name),
                     names.empty() ? fmt::format("none, because there is no {}", what) : listOf(names),
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

bool isOfLights(const Requirement& requirement) {
    const MetricInfo* metric = findMetric(requirement.key);
    return metric && metric->scope == Scope::ObjectsByLight;
}

Figure figureOf(const TechniqueOutcome& technique, const Requirement& requirement, const std::string& light) {
    if (technique.error) return Figure::absent("the technique failed");
    const MetricSet* metrics = metricsOf(technique.comparison, requirement.object);
    if (!metrics) return Figure::absent("neither frame shows the object");
    if (isOfLights(requirement) && !metrics->lights().contains(light))
        return Figure::absent("neither frame has a channel " +
                              shadowChannel(light.empty() ? "<light>" : light));
    const MetricInfo* metric = findMetric(requirement.key);
    if (!metric) return Figure::absent("not among the results");
    return requirement.object.empty() ? pooledFigures(technique).figure(*metric, light)
                                      : metrics->figure(*metric, light);
}

/// The lights to which it applies; one without a name if there is no light.
std::vector<std::string> lightsOf(const TechniqueOutcome& technique, const Requirement& requirement) {
    if (!isOfLights(requirement) || !requirement.light.empty()) return {requirement.light};
    const std::set<std::string>& lights = technique.comparison.pooled.lights();
    return lights.empty() ? std::vector<std::string>{""} : std::vector(lights.begin(), lights.end());
}

std::string keyOf(const Requirement& requirement, const std::string& light) {
    const std::string key = textOf({requirement.key, light});
    return requirement.object.empty() ? key : key + "@" + requirement.object;
}

} // namespace

Requirement parseRequirement(const std::string& text, const std::string& where) {
    Requirement requirement;
    requirement.where = where;
    const size_t at = text.find_first_of("<>");
    if (at == std::string::npos)
        throw InputError(where, fmt::format("'{}' contains no comparison", text), kForm);
    const size_t length = at + 1 < text.size() && text[at + 1] == '=' ? 2 : 1;
    requirement.comparison = text.substr(at, length);
    const std::string bound = trimmed(text.substr(at + length));
    requirement.bound = parseBound(bound, where);
    requirement.key = trimmed(text.substr(0, at));
    if (const size_t object = requirement.key.find('@'); object != std::string::npos) {
        requirement.object = trimmed(requirement.key.substr(object + 1));
        requirement.key = trimmed(requirement.key.substr(0, object));
        if (requirement.object.empty()) throw InputError(where, "no object follows '@'", kForm);
    }
    requirement.text = fmt::format("{}{}{} {} {}", requirement.key, requirement.object.empty() ? "" : "@",
                                   requirement.object, requirement.comparison, bound);
    const FigureName name = parseFigureName(requirement.key);
    requirement.key = name.key;
    requirement.light = name.light;
    const MetricInfo* metric = findMetric(requirement.key);
    if (!metric) refuseMetric(requirement);
    if ((metric->scope == Scope::Image || metric->scope == Scope::Technique) && !requirement.object.empty())
        throw InputError(where, fmt::format("{} is not computed per object", requirement.key),
                         requirement.key + " without '@'");
    return requirement;
}

void checkNames(const Requirement& requirement, std::span<const std::string> lights,
                std::span<const std::string> objects) {
    requireName(requirement, "light", requirement.light, lights);
    requireName(requirement, "object", requirement.object, objects);
}

std::vector<RequirementResult> evaluateRequirements(std::span<const Requirement> requirements,
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
