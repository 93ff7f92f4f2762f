#include "results.h"

#include <nlohmann/json.hpp>

namespace plumbline {
namespace {

using Json = nlohmann::ordered_json;

/// A group of the schema: counts, figures that are there, and the reasons of those that aren't.
Json toGroup(const MetricValues& values) {
    Json group = Json::object(), absent = Json::object();
    for (const MetricValue& entry : values) {
        if (const auto* count = std::get_if<uint64_t>(&entry.value))
            group[entry.key] = *count;
        else if (const Figure& figure = std::get<Figure>(entry.value))
            group[entry.key] = *figure;
        else
            absent[entry.key] = figure.reason();
    }
    if (!absent.empty()) group["absent"] = std::move(absent);
    return group;
}

void addMetrics(Json& json, const MetricSet& metrics, MetricValues cost) {
    json["silhouette"] = toGroup(valuesOf(metrics.silhouette));
    json["depth"] = toGroup(valuesOf(metrics.depth));
    json["shadow"] = Json::object();
    for (const auto& [light, agreement] : metrics.shadow)
        json["shadow"][light] = toGroup(valuesOf(agreement));
    json["normal"] = toGroup(valuesOf(metrics.normal));
    json["st"] = toGroup(valuesOf(metrics.st));
    MetricValues all = valuesOf(metrics.cost);
    all.insert(all.end(), cost.begin(), cost.end());
    json["cost"] = toGroup(all);
}

Json toJson(const ObjectComparison& object) {
    Json json{{"name", object.object.name}, {"id", object.object.id}};
    if (object.object.reliefDepth) json["relief_depth"] = *object.object.reliefDepth;
    addMetrics(json, object.metrics, {});
    return json;
}

Json toJson(const TechniqueOutcome& technique) {
    Json json{{"name", technique.name}, {"parameters", technique.parameters}};
    json["gl"] = {{"backend", technique.backend}, {"renderer", technique.renderer}};
    if (technique.error) {
        json["error"] = *technique.error;
        return json;
    }
    json["pooled_objects"] = technique.comparison.pooledObjects;
    addMetrics(json, technique.comparison.pooled, {{"ms_median", technique.msMedian}});
    if (technique.msMedian) {
        json["cost"]["ms_runs"] = technique.msRuns;
        json["cost"]["timer"] = technique.timer;
    }
    json["objects"] = Json::array();
    for (const ObjectComparison& object : technique.comparison.objects)
        json["objects"].push_back(toJson(object));
    if (!technique.comparison.notes.empty()) json["notes"] = technique.comparison.notes;
    json["error"] = nullptr;
    return json;
}

Json toJson(const ReferenceSummary& reference) {
    const Figure notYet = Figure::absent("the reference's own error is not bounded by this version");
    Json json = toGroup({{"micro_triangles", wholeNumber(reference.microTriangles)},
                         {"error_px_p99", notYet},
                         {"uncertain_pixels", notYet},
                         {"tessellate_ms", reference.tessellateMs},
                         {"build_ms", reference.buildMs},
                         {"trace_ms", reference.traceMs},
                         {"peak_bytes", wholeNumber(reference.peakBytes)}});
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
    json["reference"] = toJson(results.reference);
    json["techniques"] = Json::array();
    for (const TechniqueOutcome& technique : results.techniques)
        json["techniques"].push_back(toJson(technique));
    // A name that isn't UTF-8 becomes replacement characters instead of an exception.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace plumbline
