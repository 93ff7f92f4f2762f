#include "validate/report/report_data.h"

#include "validate/report/colors.h"
#include "validate/report/failing_pixels.h"
#include "validate/results/metric_table_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace plumbline::report {
namespace {

using Json = nlohmann::ordered_json;

Json colorsJson() {
    Json json;
    for (const auto& [name, color] : palette::all())
        json["palette"][name] = cssColor(color);
    for (const ColorMap& map : colormap::all()) {
        Json& entry = json["maps"][std::string(map.name)];
        entry["low"] = map.low;
        for (const Rgb& stop : map.stops)
            entry["stops"].push_back(cssColor(stop));
    }
    return json;
}

Json toJson(const FrameEntry& frame) {
    Json json{{"id", frame.id},
              {"name", frame.name},
              {"kind", frame.kind},
              {"file", frame.file},
              {"layers", frame.layers}};
    if (frame.curves) {
        json["badpix"] = frame.curves->badpix;
        json["histogram"] = {
            {"counts", frame.curves->counts}, {"below", frame.curves->below}, {"above", frame.curves->above}};
    }
    return json;
}

Json toJson(const ObjectInfo& object) {
    const bool known = object.reliefDepth && *object.reliefDepth > 0;
    return {{"id", object.id},
            {"name", object.name},
            {"relief_depth", known ? Json(*object.reliefDepth) : Json(nullptr)}};
}

} // namespace

DepthRange depthRange(const Comparison& comparison) {
    double deepest = 0;
    for (const ObjectComparison& object : comparison.objects)
        if (object.object.reliefDepth) deepest = std::max(deepest, *object.object.reliefDepth);
    if (deepest > 0) return {0.25 * deepest, "a quarter of the relief depth"};
    const Figure& p95 = comparison.pooled.figure("depth.p95");
    if (p95 && *p95 > 0) return {*p95, "the 95th percentile of the shared pixels"};
    return {1, "neither a relief depth nor an error is known"};
}

std::string scriptSafe(std::string json) {
    // In JSON a '<' occurs only in strings.
    size_t at = 0;
    while ((at = json.find('<', at)) != std::string::npos)
        json.replace(at, 1, "\\u003c");
    return json;
}

std::string reportDataJson(const Results& results, const ReportData& data) {
    Json json{{"schema", 1},
              {"width", results.scene.width},
              {"height", results.scene.height},
              {"results", Json::parse(plumbline::toJson(results))},
              {"metrics", Json::parse(metricTableJson())}};
    json["frames"] = Json::array();
    for (const FrameEntry& frame : data.frames)
        json["frames"].push_back(toJson(frame));
    json["objects"] = Json::array();
    for (const ObjectInfo& object : data.objects)
        json["objects"].push_back(toJson(object));
    json["depth_range"] = {{"world", data.depthRange.worldUnits}, {"note", data.depthRange.note}};
    json["failing"] = {{"of", data.failingOf}, {"meaning", FailingPixels::meaning()}};
    json["curves"] = {
        {"thresholds", badpixThresholds()}, {"named", kNamedThresholds}, {"edges", histogramEdges()}};
    json["colors"] = colorsJson();
    json["shadow_threshold"] = kShadowThreshold;
    return scriptSafe(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

} // namespace plumbline::report
