#include "validate/results/row_values.h"

#include "validate/results/results.h"

namespace plumbline {
namespace {

template <class Value>
Value ofLight(const std::map<std::string, Value>& byLight, const std::string& light) {
    const auto found = byLight.find(light);
    return found == byLight.end() ? Value{} : found->second;
}

MetricValues absentImage() {
    MetricValues values = valuesOf(ImageError{});
    for (MetricValue& entry : values)
        entry.value = Figure::absent("the picture is that of all objects");
    return values;
}

} // namespace

MetricValues rowValues(const MetricSet& metrics, const std::string& light, const ImageError* image,
                       const TechniqueOutcome* outcome) {
    MetricValues row;
    const auto add = [&](const std::string& group, const MetricValues& values) {
        for (const MetricValue& entry : values)
            row.push_back({group + "." + entry.key, entry.value});
    };
    add("silhouette", valuesOf(metrics.silhouette));
    add("silhouette.boundary_iou", valuesOf(metrics.boundary));
    add("silhouette", valuesOf(metrics.contour));
    add("depth", valuesOf(metrics.depth));
    add("shadow", valuesOf(ofLight(metrics.shadow, light)));
    add("shadow", valuesOf(ofLight(metrics.shadowKinds, light)));
    add("normal", valuesOf(metrics.normal));
    add("st", valuesOf(metrics.st));
    add("image", image ? valuesOf(*image) : absentImage());
    add("cost", valuesOf(metrics.cost));
    add("cost", valuesOf(metrics.iterations));
    const TechniqueOutcome& costs = outcome ? *outcome : TechniqueOutcome{};
    add("cost", {{"bake_ms", costs.bakeMs},
                 {"bake_bytes", wholeNumber(costs.bakeBytes)},
                 {"ms_median", costs.msMedian}});
    return row;
}

} // namespace plumbline
