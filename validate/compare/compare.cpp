#include "validate/compare/compare.h"

#include "scenes/frame/frame_header.h"
#include "validate/metrics/hit_faults.h"
#include "validate/metrics/metric_registry.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace plumbline {
namespace {

void noteObjects(const FramePair& pair, std::vector<std::string>& notes) {
    if (!pair.hasObjectIds())
        notes.push_back(pair.missingChannel("id") + ": all covered pixels count as one object");
}

void noteDepth(const MetricInput& input, std::vector<std::string>& notes) {
    if (const std::string& reason = input.noDepthReason(); !reason.empty())
        notes.push_back(reason + ": no depth figures");
}

void noteShadows(const FramePair& pair, const std::vector<std::string>& lights,
                 std::vector<std::string>& notes) {
    if (lights.empty()) notes.push_back("neither frame has a channel shadow.<light>: no shadow figures");
    for (const std::string& light : lights)
        if (const std::string missing = pair.missingChannel(shadowChannel(light)); !missing.empty())
            notes.push_back(fmt::format("{}: no shadow figures for {}", missing, light));
}

void noteIntervals(const FramePair& pair, const std::vector<std::string>& lights,
                   std::vector<std::string>& notes) {
    for (const std::string& light : lights)
        if (const std::string missing = pair.missingInReference(uncertainShadowChannel(light));
            !missing.empty() && pair.missingChannel(shadowChannel(light)).empty())
            notes.push_back(fmt::format("{}: no intervals of the shadow figures for {}", missing, light));
    if (const std::string missing = pair.missingInReference("uncertain"); !missing.empty())
        notes.push_back(missing + ": no intervals");
}

void noteShadowKinds(const MetricInput& input, const std::vector<std::string>& lights,
                     std::vector<std::string>& notes) {
    if (!input.camera && !lights.empty()) {
        notes.emplace_back("the camera is not known: attached and cast shadows are not separated");
        return;
    }
    for (const std::string& light : lights)
        if (!input.light(light) && input.pair.missingChannel(shadowChannel(light)).empty())
            notes.push_back(fmt::format(
                "neither header contains the direction or position of the light {}: attached and cast "
                "shadows are not separated",
                light));
}

/// Metrics that can't be computed because a channel is missing.
void noteMetrics(const FramePair& pair, std::vector<std::string>& notes) {
    for (const Metric& metric : metricRegistry())
        if (const std::string missing = pair.missingChannel(metric.channels); !missing.empty())
            notes.push_back(fmt::format("{}: no {}", missing, metric.figuresName));
}

void noteReliefs(const FramePair& pair, std::vector<std::string>& notes) {
    for (const ObjectInfo& object : pair.objects())
        if (!object.reliefDepth)
            notes.push_back(fmt::format(
                "the relief depth of '{}' is not known: no depth figures relative to it", object.name));
}

/// Where the reference shows back sides, and whether the test does.
void noteBackSides(const std::vector<ObjectComparison>& objects, std::vector<std::string>& notes) {
    for (const auto& [object, metrics] : objects) {
        const Figure& back = metrics.figure("silhouette.back_px");
        if (back && *back > 0)
            notes.push_back(
                fmt::format("the reference shows the back side of '{}' in {} pixels; {} of them are missing",
                            object.name, *back, *metrics.figure("silhouette.missing_back_px")));
    }
}

/// What is missing and which figures need it.
std::vector<std::string> notesOn(const MetricInput& input) {
    const std::vector<std::string> lights = input.lightNames();
    std::vector<std::string> notes;
    noteObjects(input.pair, notes);
    noteDepth(input, notes);
    noteShadows(input.pair, lights, notes);
    noteIntervals(input.pair, lights, notes);
    noteShadowKinds(input, lights, notes);
    noteMetrics(input.pair, notes);
    noteReliefs(input.pair, notes);
    return notes;
}

/// Lights of both headers; if both have one of the same name, the reference's.
std::vector<Light> placedLights(const Frame& reference, const Frame& test) {
    std::vector<Light> lights = lightsFromHeader(reference, "reference");
    for (const Light& light : lightsFromHeader(test, "test"))
        if (std::ranges::find(lights, light.name, &Light::name) == lights.end()) lights.push_back(light);
    return lights;
}

/// Runs each index as a separate task, because their durations range from microseconds to tens of
/// milliseconds.
template <class Run>
void runAll(size_t count, const Run& run) {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, count, 1),
        [&](const tbb::blocked_range<size_t>& range) {
            for (size_t i = range.begin(); i != range.end(); ++i)
                run(i);
        },
        tbb::simple_partitioner());
}

/// A metric, for one light if it has figures for every light.
struct PreparedMetric {
    const Metric* metric;
    std::string light;
    std::function<Measured(ObjectSelection)> measure = {};
};

/// All metrics, with the work done that their selections share.
std::vector<PreparedMetric> prepareMetrics(const MetricInput& input) {
    std::vector<PreparedMetric> prepared;
    for (const Metric& metric : metricRegistry()) {
        if (metric.scope == Scope::Technique) continue;
        if (metric.scope != Scope::ObjectsByLight)
            prepared.push_back({&metric, ""});
        else
            for (const std::string& light : input.lightNames())
                prepared.push_back({&metric, light});
    }
    runAll(prepared.size(),
           [&](size_t i) { prepared[i].measure = prepared[i].metric->prepare(input, prepared[i].light); });
    return prepared;
}

/// A metric over one selection.
struct Measurement {
    const PreparedMetric* metric;
    ObjectSelection selection;
    MetricSet* set; // receives the result
    Measured result = {};
};

/// Computes every metric per object and pooled, into comparison.objects and comparison.pooled.
void measureAll(const MetricInput& input, Comparison& comparison) {
    const std::vector<PreparedMetric> metrics = prepareMetrics(input);
    std::vector<size_t> all(comparison.objects.size());
    std::iota(all.begin(), all.end(), size_t(0));
    const std::vector<size_t> relief = input.pair.reliefObjects();
    const bool several = relief.size() != 1; // pooled figures of one object are its own
    std::vector<Measurement> measurements;
    for (const PreparedMetric& metric : metrics) {
        const bool ofImage = metric.metric->scope == Scope::Image;
        if (ofImage || several) measurements.push_back({&metric, relief, &comparison.pooled});
        if (ofImage) continue;
        for (const size_t index : all)
            measurements.push_back(
                {&metric, std::span(all).subspan(index, 1), &comparison.objects[index].metrics});
    }
    runAll(measurements.size(), [&](size_t i) {
        measurements[i].result = measurements[i].metric->measure(measurements[i].selection);
    });
    for (Measurement& each : measurements)
        each.set->add(*each.metric->metric, each.metric->light, std::move(each.result));
    if (!several) comparison.pooled.add(comparison.objects[relief[0]].metrics);
}

} // namespace

Comparison compareFrames(const Frame& reference, const Frame& test, const std::vector<ObjectInfo>& objects,
                         const std::optional<Camera>& camera) {
    MetricInput input(reference, test, objects, camera, placedLights(reference, test));
    Comparison comparison;
    for (const ObjectInfo& object : input.pair.objects())
        comparison.objects.push_back({object, {}});
    for (const size_t index : input.pair.reliefObjects())
        comparison.pooledObjects.push_back(input.pair.objects()[index].name);
    measureAll(input, comparison);
    comparison.notes = notesOn(input);
    noteBackSides(comparison.objects, comparison.notes);
    for (const std::string& sentence : faultSentences(test))
        comparison.notes.push_back(sentence);
    comparison.referenceDepth = std::move(input.referenceDepth.depth);
    comparison.testDepth = std::move(input.testDepth.depth);
    return comparison;
}

} // namespace plumbline
