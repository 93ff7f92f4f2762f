#include "validate/results/results.h"

#include <nlohmann/json.hpp>

namespace plumbline {
namespace {

using Json = nlohmann::ordered_json;

/// A group of the schema: counts, figures that are there, and the reasons of those that aren't.
class Group {
  public:
    void add(const MetricValues& values) {
        for (const MetricValue& entry : values) {
            if (const auto* count = std::get_if<uint64_t>(&entry.value))
                json_[entry.key] = *count;
            else if (const Figure& figure = std::get<Figure>(entry.value))
                json_[entry.key] = *figure;
            else
                absent_[entry.key] = figure.reason();
        }
    }
    void add(const std::string& key, const std::optional<std::string>& text, const std::string& reason) {
        if (text)
            json_[key] = *text;
        else
            absent_[key] = reason;
    }
    void add(const std::string& key, Json inner) { json_[key] = std::move(inner); }
    Json json() const {
        Json whole = json_;
        if (!absent_.empty()) whole["absent"] = absent_;
        return whole;
    }

  private:
    Json json_ = Json::object(), absent_ = Json::object();
};

Json toGroup(const MetricValues& values) {
    Group group;
    group.add(values);
    return group.json();
}

void addMetrics(Json& json, const MetricSet& metrics) {
    Group silhouette;
    silhouette.add(valuesOf(metrics.silhouette));
    silhouette.add("boundary_iou", toGroup(valuesOf(metrics.boundary)));
    silhouette.add(valuesOf(metrics.contour));
    json["silhouette"] = silhouette.json();
    json["depth"] = toGroup(valuesOf(metrics.depth));
    json["shadow"] = Json::object();
    for (const auto& [light, agreement] : metrics.shadow) {
        Group shadow;
        shadow.add(valuesOf(agreement));
        if (const auto kinds = metrics.shadowKinds.find(light); kinds != metrics.shadowKinds.end())
            shadow.add(valuesOf(kinds->second));
        json["shadow"][light] = shadow.json();
    }
    json["normal"] = toGroup(valuesOf(metrics.normal));
    json["st"] = toGroup(valuesOf(metrics.st));
}

void addPooled(Json& json, const Comparison& comparison) {
    json["pooled_objects"] = comparison.pooledObjects;
    addMetrics(json, comparison.pooled);
    json["image"] = toGroup(valuesOf(comparison.image));
}

void addCost(Json& json, const MetricSet& metrics, const MetricValues& more) {
    MetricValues values = valuesOf(metrics.cost);
    for (const MetricValues& further : {valuesOf(metrics.iterations), more})
        values.insert(values.end(), further.begin(), further.end());
    json["cost"] = toGroup(values);
    if (!metrics.iterations.histogram.empty())
        json["cost"]["iterations_histogram"] = metrics.iterations.histogram;
}

Json toJson(const ObjectComparison& object, bool withCost) {
    Json json{{"name", object.object.name}, {"id", object.object.id}};
    if (object.object.reliefDepth) json["relief_depth"] = *object.object.reliefDepth;
    addMetrics(json, object.metrics);
    if (withCost) addCost(json, object.metrics, {});
    return json;
}

/// Without cost: two references have none, and a technique's doesn't depend on what it is held against.
Json toJson(const Comparison& comparison) {
    Json json;
    addPooled(json, comparison);
    json["objects"] = Json::array();
    for (const ObjectComparison& object : comparison.objects)
        json["objects"].push_back(toJson(object, false));
    if (!comparison.notes.empty()) json["notes"] = comparison.notes;
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
    addPooled(json, technique.comparison);
    addCost(json, technique.comparison.pooled,
            {{"ms_median", technique.msMedian},
             {"bake_ms", technique.bakeMs},
             {"bake_bytes", wholeNumber(technique.bakeBytes)}});
    if (technique.msMedian) {
        json["cost"]["ms_runs"] = technique.msRuns;
        json["cost"]["timer"] = technique.timer;
    }
    json["objects"] = Json::array();
    for (const ObjectComparison& object : technique.comparison.objects)
        json["objects"].push_back(toJson(object, true));
    if (!technique.comparison.notes.empty()) json["notes"] = technique.comparison.notes;
    if (technique.againstProxy) json["against_proxy"] = toJson(*technique.againstProxy);
    json["error"] = nullptr;
    return json;
}

void addCertificate(Group& group, const CertificateSummary& certificate) {
    for (const CertificateFigure& entry : certificateFigures())
        group.add({{entry.key, certificate.*entry.figure}});
    group.add("error_limit", certificate.limit, certificate.limitReason);
    group.add({{"uncertain_pixels", wholeNumber(certificate.uncertainPixels)}});
    MetricValues byLight;
    for (const auto& [light, count] : certificate.uncertainShadowPixels)
        byLight.push_back({light, wholeNumber(count)});
    group.add("uncertain_shadow_pixels", toGroup(byLight));
    group.add({{"covered_pixels", wholeNumber(certificate.coveredPixels)}});
}

Json toJson(const ReferenceSummary& reference) {
    Group group;
    group.add({{"micro_triangles", wholeNumber(reference.microTriangles)}});
    addCertificate(group, reference.certificate);
    group.add({{"tessellate_ms", reference.tessellateMs},
               {"build_ms", reference.buildMs},
               {"trace_ms", reference.traceMs},
               {"peak_bytes", wholeNumber(reference.peakBytes)}});
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
    // A name that isn't UTF-8 becomes replacement characters instead of an exception.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace plumbline
