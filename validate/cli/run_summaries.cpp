#include "validate/cli/run_summaries.h"

#include <sys/resource.h>

namespace plumbline {
namespace {

CertificateSummary summaryOf(const Certificate& certificate, const Frame& frame) {
    CertificateSummary summary;
    summary.pxP50 = certificate.pxP50;
    summary.pxP99 = certificate.pxP99;
    summary.pxMax = certificate.pxMax;
    summary.pxAim = certificate.aimPx;
    summary.worldP50 = certificate.worldP50;
    summary.worldP99 = certificate.worldP99;
    summary.worldMax = certificate.worldMax;
    summary.limit = certificate.limit;
    // An aim is always above 0: a certificate without one was never filled in.
    if (!(certificate.aimPx > 0)) setAbsent(summary, "the reference didn't measure it");
    countPixels(frame, summary);
    return summary;
}

} // namespace

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
