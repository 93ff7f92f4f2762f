// Results of a small run, created without rendering.
#pragma once

#include "tests/validate/metrics/painted_frames.h"
#include "validate/metrics/metric_registry.h"
#include "validate/results/results.h"

namespace plumbline::test {

inline Frame sampleReference() {
    Frame frame = emptyFrame(8, 6);
    paintRectangle(frame, 1, 1, 4, 5, 1, 2.0f);
    paintRectangle(frame, 4, 1, 7, 5, 2, 2.5f);
    set(frame, "shadow.sun", 2, 2, 1);
    for (const char* color : {"R", "G", "B"})
        set(frame, color, 5, 2, 1);
    addUncertainty(frame);
    set(frame, "uncertain", 0, 0, 1); // empty in both frames; may be a missing pixel
    set(frame, "uncertain.shadow.sun", 2, 2, 1);
    return frame;
}

inline CertificateSummary sampleCertificate() {
    CertificateSummary certificate;
    certificate.error.pxP50 = 0.004;
    certificate.error.pxP99 = 0.031;
    certificate.error.pxMax = 0.4;
    certificate.error.pxAim = 0.05;
    certificate.error.worldP50 = 1e-6;
    certificate.error.worldP99 = 1.2e-5;
    certificate.error.worldMax = 2.5e-4;
    certificate.error.limit = "";
    certificate.coveredPixels = 215000;
    certificate.uncertainPixels = 134;
    certificate.uncertainShadowPixels = {{"sun", 420}, {"lamp", 7}};
    return certificate;
}

inline void setFigure(MetricSet& metrics, const char* key, double value, const std::string& light = {}) {
    metrics.set(*findMetric(key), light, value);
}

/// Copies the figures of one light to another.
inline void copyLight(MetricSet& metrics, const std::string& from, const std::string& to) {
    for (const MetricInfo& metric : metricTable())
        if (metric.scope == Scope::ObjectsByLight) metrics.set(metric, to, metrics.figure(metric, from));
}

inline Results sampleResults(const std::string& techniqueName = "linear_binary") {
    const Frame reference = sampleReference(), test = shiftedRight(reference);
    Results results;
    results.program = "plumbline 0.1.0";
    results.scene = {"painted", "A scene <of> paint & \"quotes\"", "abc123", {}, 8, 6};
    results.reference.microTriangles = 1234567;
    results.reference.tessellateMs = 1.5;
    results.reference.buildMs = 2.5;
    results.reference.traceMs = 3.5;
    results.reference.peakBytes = 1e9;
    results.reference.certificate = sampleCertificate();
    results.reference.objects = {{"object 1", 8, 16, 1234567}};
    TechniqueOutcome good;
    good.name = techniqueName;
    good.parameters = {{"linear_steps", "32"}};
    good.backend = "egl";
    good.renderer = "llvmpipe";
    good.cost.msMedian = 12.5;
    good.msRuns = 5;
    good.timer = "wall clock around glFinish";
    good.comparison =
        compareFrames(reference, test, {objectWithRelief(1, 0.1), objectWithRelief(2, 0)}, std::nullopt);
    TechniqueOutcome bad;
    bad.name = "broken";
    bad.error = "broken.glsl:3: undeclared 'x'";
    results.techniques = {good, bad};
    return results;
}

/// The same with a second reference on the proxy, in which object 1 has two columns instead of three.
inline Results sampleResultsOnBothBases() {
    Results results = sampleResults();
    const Frame reference = sampleReference(), test = shiftedRight(reference);
    Frame proxy = sampleReference();
    for (int y = 1; y < 5; ++y)
        set(proxy, "id", 1, y, 0);
    const std::vector<ObjectInfo> objects{objectWithRelief(1, 0.1), objectWithRelief(2, 0)};
    results.base = "limit";
    results.proxy = ProxyReference{results.reference, compareFrames(reference, proxy, objects, std::nullopt)};
    results.proxy->summary.certificate.error.limit = "--memory 1 MB";
    results.techniques[0].againstProxy = compareFrames(proxy, test, objects, std::nullopt);
    return results;
}

} // namespace plumbline::test
