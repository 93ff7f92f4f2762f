#include "validate/metrics/metric_registry.h"
#include "validate/results/results.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace plumbline {
namespace {

using Json = nlohmann::ordered_json;

const std::string kCostGroup = "cost";

/// A group of the schema: figures, nested groups, and the reasons of absent figures.
class Group {
  public:
    void add(const std::string& key, const Figure& figure) {
        if (figure)
            json_[key] = *figure;
        else
            absent_[key] = figure.reason();
    }
    /// A figure that is an integer, written without a decimal point.
    void addCount(const std::string& key, const Figure& figure) {
        if (figure)
            json_[key] = static_cast<uint64_t>(*figure);
        else
            absent_[key] = figure.reason();
    }
    void add(const std::string& key, const std::optional<std::string>& text, const std::string& reason) {
        if (text)
            json_[key] = *text;
        else
            absent_[key] = reason;
    }
    /// Adds a value that is written after the figures and their reasons.
    void addLast(const std::string& key, Json value) { last_[key] = std::move(value); }
    /// The group of that name; a new one is written after what was added so far.
    Group& inner(const std::string& key) {
        std::unique_ptr<Group>& group = inner_[key];
        if (!group) {
            group = std::make_unique<Group>();
            json_[key] = nullptr; // reserves its position
        }
        return *group;
    }
    Json json() const {
        Json whole = json_;
        for (const auto& [key, group] : inner_)
            whole[key] = group->json();
        if (!absent_.empty()) whole["absent"] = absent_;
        for (const auto& [key, value] : last_.items())
            whole[key] = value;
        return whole;
    }

  private:
    Json json_ = Json::object(), absent_ = Json::object(), last_ = Json::object();
    std::map<std::string, std::unique_ptr<Group>> inner_;
};

/// The group of a metric. `path`: names of nested groups, separated by dots.
Group& groupOf(Group& root, const std::string& path) {
    const size_t dot = path.find('.');
    return dot == std::string::npos ? root.inner(path)
                                    : groupOf(root.inner(path.substr(0, dot)), path.substr(dot + 1));
}

/// In schema 1 the time of a frame comes before the other costs of a run.
std::vector<const MetricInfo*> inSchemaOrder(const std::vector<MetricInfo>& rows) {
    std::vector<const MetricInfo*> ordered;
    for (const MetricInfo& row : rows)
        ordered.push_back(&row);
    // clang 14 can't compile std::ranges::stable_partition with the headers of g++ 12.
    std::stable_partition(ordered.begin(), ordered.end(),
                          [](const MetricInfo* row) { return row->key == "cost.ms_median"; });
    return ordered;
}

void addMetric(Group& group, const Metric& metric, const MetricSet& metrics, const std::string& light) {
    for (const MetricInfo* row : inSchemaOrder(metric.rows)) {
        const std::string key = row->key.substr(metric.group.size() + 1);
        if (isWhole(row->unit))
            group.addCount(key, metrics.figure(*row, light));
        else
            group.add(key, metrics.figure(*row, light));
    }
    const auto& histogram = metrics.histogram(metric.group + "." + metric.histogram);
    if (!histogram.empty()) group.addLast(metric.histogram, histogram);
}

/// The figures of metrics whose scope is one of `scopes`.
Group metricGroups(const MetricSet& metrics, std::initializer_list<Scope> scopes) {
    Group root;
    for (const Metric& metric : metricRegistry()) {
        if (std::ranges::find(scopes, metric.scope) == scopes.end()) continue;
        Group& group = groupOf(root, metric.group);
        if (metric.scope != Scope::ObjectsByLight)
            addMetric(group, metric, metrics, "");
        else
            for (const std::string& light : metrics.lights())
                addMetric(group.inner(light), metric, metrics, light);
    }
    return root;
}

/// `withCost`: false for two references, which have no cost, and for a technique compared with the proxy,
/// whose cost is already written.
void addGroups(Json& json, const Group& groups, bool withCost) {
    const Json all = groups.json();
    for (const auto& [name, group] : all.items())
        if (withCost || name != kCostGroup) json[name] = group;
}

Json toJson(const ObjectComparison& object, bool withCost) {
    Json json{{"name", object.object.name}, {"id", object.object.id}};
    if (object.object.reliefDepth) json["relief_depth"] = *object.object.reliefDepth;
    addGroups(json, metricGroups(object.metrics, {Scope::Objects, Scope::ObjectsByLight}), withCost);
    return json;
}

void addObjectsAndNotes(Json& json, const Comparison& comparison, bool withCost) {
    json["objects"] = Json::array();
    for (const ObjectComparison& object : comparison.objects)
        json["objects"].push_back(toJson(object, withCost));
    if (!comparison.notes.empty()) json["notes"] = comparison.notes;
}

Json toJson(const Comparison& comparison) {
    Json json;
    json["pooled_objects"] = comparison.pooledObjects;
    addGroups(json, metricGroups(comparison.pooled, {Scope::Objects, Scope::ObjectsByLight, Scope::Image}),
              false);
    addObjectsAndNotes(json, comparison, false);
    return json;
}

Json toJson(const RequirementResult& result) {
    Json json{{"require", result.requirement}, {"key", result.key}};
    if (result.value)
        json["value"] = *result.value;
    else
        json["absent"] = result.value.reason();
    json["passed"] = result.passed;
    return json;
}

Json toJson(const TechniqueOutcome& technique) {
    Json json{{"name", technique.name}, {"parameters", technique.parameters}};
    if (technique.control) json["control"] = true;
    json["gl"] = {{"backend", technique.backend}, {"renderer", technique.renderer}};
    for (const RequirementResult& result : technique.requirements)
        json["requirements"].push_back(toJson(result));
    if (technique.error) {
        json["error"] = *technique.error;
        return json;
    }
    json["pooled_objects"] = technique.comparison.pooledObjects;
    Group groups = metricGroups(pooledFigures(technique),
                                {Scope::Objects, Scope::ObjectsByLight, Scope::Image, Scope::Technique});
    if (technique.cost.msMedian) {
        groups.inner(kCostGroup).addLast("ms_runs", technique.msRuns);
        groups.inner(kCostGroup).addLast("timer", technique.timer);
    }
    addGroups(json, groups, true);
    addObjectsAndNotes(json, technique.comparison, true);
    if (technique.againstProxy) json["against_proxy"] = toJson(*technique.againstProxy);
    json["error"] = nullptr;
    return json;
}

void addCertificate(Group& group, const CertificateSummary& certificate) {
    for (const CertificateRow& row : certificateTable())
        group.add(std::string(row.key), certificate.figure(row));
    group.add(std::string(kCertificateLimitKey), certificate.error.limit,
              certificate.reasonWithout(kCertificateLimitKey));
    group.addCount("uncertain_pixels", certificate.uncertainPixels);
    Group& byLight = group.inner("uncertain_shadow_pixels");
    for (const auto& [light, count] : certificate.uncertainShadowPixels)
        byLight.addCount(light, count);
    group.addCount("covered_pixels", certificate.coveredPixels);
}

Json toJson(const ReferenceSummary& reference) {
    Group group;
    group.addCount("micro_triangles", reference.microTriangles);
    addCertificate(group, reference.certificate);
    group.add("tessellate_ms", reference.tessellateMs);
    group.add("build_ms", reference.buildMs);
    group.add("trace_ms", reference.traceMs);
    group.addCount("peak_bytes", reference.peakBytes);
    Json json = group.json();
    json["objects"] = Json::array();
    for (const ReferenceSummary::Object& object : reference.objects)
        json["objects"].push_back({{"name", object.name},
                                   {"rate", object.rate},
                                   {"wanted_rate", object.wantedRate},
                                   {"micro_triangles", object.microTriangles}});
    return json;
}

} // namespace

std::string toJson(const Results& results) {
    const SceneSummary& scene = results.scene;
    Json json{{"schema", kResultsSchema}, {"program", results.program}};
    json["scene"] = {{"name", scene.name},
                     {"purpose", scene.purpose},
                     {"hash", scene.hash},
                     {"width", scene.width},
                     {"height", scene.height}};
    if (!scene.changes.empty()) json["scene"]["changes"] = scene.changes;
    if (results.proxy)
        json["base"] = "both";
    else
        json["base"] = results.base.empty() ? Json(nullptr) : Json(results.base);
    json["reference"] = toJson(results.reference);
    if (results.proxy) {
        json["reference_proxy"] = toJson(results.proxy->summary);
        json["base_gap"] = toJson(results.proxy->gap);
    }
    json["techniques"] = Json::array();
    for (const TechniqueOutcome& technique : results.techniques)
        json["techniques"].push_back(toJson(technique));
    // ASCII, so that no character of a name acts on a terminal. A name that isn't UTF-8 becomes replacement
    // characters instead of an exception.
    return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

} // namespace plumbline
