#include "validate/compare/compare.h"

#include "validate/compare/frame_metadata.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <set>

namespace plumbline {
namespace {

std::set<std::string> lightsOf(const FramePair& pair) {
    std::set<std::string> lights;
    for (const Frame* frame : {&pair.reference(), &pair.test()})
        for (const std::string& light : frame->lightNames())
            lights.insert(light);
    return lights;
}

/// What metrics need beside the pair.
struct View {
    std::span<const float> referenceDepth, testDepth;
    std::string noDepthReason;
    std::vector<BoundaryRims> rims;
    std::vector<Light> lights; // those whose place is known
    const std::optional<Camera>& camera;

    std::optional<Light> light(const std::string& name) const {
        const auto found = std::find_if(lights.begin(), lights.end(),
                                        [&](const Light& light) { return light.name == name; });
        return found == lights.end() ? std::nullopt : std::optional(*found);
    }
};

MetricSet computeMetrics(const FramePair& pair, ObjectSelection selection, const View& view) {
    MetricSet metrics;
    tbb::parallel_invoke([&] { metrics.silhouette = computeSilhouetteIou(pair, selection); },
                         [&] { metrics.boundary = computeBoundaryIou(pair, selection, view.rims); },
                         [&] { metrics.contour = computeContourDistance(pair, selection); },
                         [&] {
                             metrics.depth = computeDepthError(pair, selection, view.referenceDepth,
                                                               view.testDepth, view.noDepthReason);
                         },
                         [&] {
                             for (const std::string& light : lightsOf(pair)) {
                                 metrics.shadow[light] = computeShadowAgreement(pair, selection, light);
                                 metrics.shadowKinds[light] = computeShadowKinds(
                                     pair, selection, light, view.light(light), view.camera);
                             }
                         },
                         [&] { metrics.normal = computeNormalAngle(pair, selection); },
                         [&] { metrics.st = computeStError(pair, selection); },
                         [&] {
                             metrics.cost = computeFetchCost(pair, selection);
                             metrics.iterations = computeSearchIterations(pair, selection);
                         });
    return metrics;
}

void noteMissing(const FramePair& pair, const View& view, std::vector<std::string>& notes) {
    if (!pair.objectsToldApart())
        notes.push_back(pair.missingChannel("id") + ": everything covered counts as one object");
    if (!view.noDepthReason.empty()) notes.push_back(view.noDepthReason + ": no depth figures");
    if (lightsOf(pair).empty())
        notes.push_back("neither frame has a channel shadow.<light>: no shadow figures");
    for (const std::string& light : lightsOf(pair))
        if (const std::string missing = pair.missingChannel(shadowChannel(light)); !missing.empty())
            notes.push_back(fmt::format("{}: no shadow figures for {}", missing, light));
    for (const std::string& light : lightsOf(pair))
        if (const std::string missing = pair.missingInReference(uncertainShadowChannel(light));
            !missing.empty() && pair.missingChannel(shadowChannel(light)).empty())
            notes.push_back(fmt::format("{}: no intervals of the shadow figures for {}", missing, light));
    if (const std::string missing = pair.missingInReference("uncertain"); !missing.empty())
        notes.push_back(missing + ": no intervals");
    if (!view.camera && !lightsOf(pair).empty())
        notes.push_back("the camera is not known: attached and cast shadows are not told apart");
    else
        for (const std::string& light : lightsOf(pair))
            if (!view.light(light) && pair.missingChannel(shadowChannel(light)).empty())
                notes.push_back(fmt::format("no frame's header says where the light {} is: attached and cast "
                                            "shadows are not told apart",
                                            light));
    for (const char* channel : {"N.X", "N.Y", "N.Z"})
        if (const std::string missing = pair.missingChannel(channel); !missing.empty()) {
            notes.push_back(missing + ": no normal figures");
            break;
        }
    for (const char* channel : {"st.S", "st.T"})
        if (const std::string missing = pair.missingChannel(channel); !missing.empty()) {
            notes.push_back(missing + ": no st figures");
            break;
        }
    for (const char* channel : {"R", "G", "B"})
        if (const std::string missing = pair.missingChannel(channel); !missing.empty()) {
            notes.push_back(missing + ": no figures of the picture");
            break;
        }
    for (const ObjectInfo& object : pair.objects())
        if (!object.reliefDepth)
            notes.push_back(fmt::format(
                "the relief depth of '{}' is not known: no depth figures relative to it", object.name));
}

} // namespace

PlanarDepth planarDepth(const Frame& frame, const char* which, const std::optional<Camera>& camera) {
    if (frame.has("Z")) {
        const auto plane = frame.channel("Z");
        return {{plane.begin(), plane.end()}, {}};
    }
    if (!frame.has("P.X") || !frame.has("P.Y") || !frame.has("P.Z"))
        return {{}, fmt::format("the {} frame has neither Z nor P.X P.Y P.Z", which)};
    if (!camera) return {{}, fmt::format("the {} frame has P but no Z, and the camera is not known", which)};
    const auto x = frame.channel("P.X"), y = frame.channel("P.Y"), z = frame.channel("P.Z");
    const CameraRays rays(*camera);
    PlanarDepth result;
    result.depth.resize(frame.pixelCount());
    for (size_t pixel = 0; pixel < result.depth.size(); ++pixel)
        result.depth[pixel] = static_cast<float>(rays.planarDepth(Vec3(x[pixel], y[pixel], z[pixel])));
    return result;
}

Comparison compareFrames(const Frame& reference, const Frame& test, const std::vector<ObjectInfo>& objects,
                         const std::optional<Camera>& camera) {
    const FramePair pair(reference, test, objects);
    Comparison comparison;
    PlanarDepth referenceDepth, testDepth;
    std::vector<BoundaryRims> rims;
    tbb::parallel_invoke([&] { rims = findBoundaryRims(pair); },
                         [&] { comparison.image = computeImageError(pair); },
                         [&] { referenceDepth = planarDepth(reference, "reference", camera); },
                         [&] { testDepth = planarDepth(test, "test", camera); });
    comparison.referenceDepth = std::move(referenceDepth.depth);
    comparison.testDepth = std::move(testDepth.depth);

    View view{comparison.referenceDepth,
              comparison.testDepth,
              referenceDepth.reason.empty() ? testDepth.reason : referenceDepth.reason,
              std::move(rims),
              lightsFromHeader(reference, "reference"),
              camera};
    for (const Light& light : lightsFromHeader(test, "test")) // in either header; the reference's goes first
        if (!view.light(light.name)) view.lights.push_back(light);

    const std::vector<size_t> relief = pair.reliefObjects();
    const bool several = relief.size() != 1; // pooled over one, figures are that one's
    std::vector<MetricSet> ofObjects(pair.objects().size());
    tbb::parallel_for(size_t(0), ofObjects.size() + several, [&](size_t index) {
        if (index == ofObjects.size())
            comparison.pooled = computeMetrics(pair, relief, view);
        else
            ofObjects[index] = computeMetrics(pair, std::span(&index, 1), view);
    });
    if (!several) comparison.pooled = ofObjects[relief[0]];
    for (const size_t index : relief)
        comparison.pooledObjects.push_back(pair.objects()[index].name);
    for (size_t index = 0; index < pair.objects().size(); ++index)
        comparison.objects.push_back({pair.objects()[index], std::move(ofObjects[index])});
    noteMissing(pair, view, comparison.notes);
    return comparison;
}

} // namespace plumbline
