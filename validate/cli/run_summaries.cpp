#include "validate/cli/run_summaries.h"

#include <sys/resource.h>

namespace plumbline {
SceneSummary summaryOf(const Scene& scene) {
    return {scene.name, scene.purpose, scene.hash, scene.changes, scene.camera.width, scene.camera.height};
}

ReferenceSummary summaryOf(const ReferenceStats& stats, const Frame& frame) {
    ReferenceSummary summary;
    summary.microTriangles = static_cast<double>(stats.microTriangles);
    summary.tessellateMs = stats.tessellateMs;
    summary.buildMs = stats.buildMs;
    summary.traceMs = stats.traceMs;
    summary.peakBytes = static_cast<double>(peakBytes());
    summary.certificate = summaryOf(stats.certificate, frame);
    for (const ReferenceStats::Object& object : stats.objects)
        summary.objects.push_back({object.name, object.rate, object.wantedRate, object.microTriangles});
    return summary;
}

uint64_t peakBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<uint64_t>(usage.ru_maxrss) * 1024; // Linux counts in KiB
}

} // namespace plumbline
