#include "report.h"

#include "../../scenes/image_file.h"
#include "../../scenes/replace_file.h"
#include "../output_files.h"
#include "pictures.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

using Kind = ReportPicture::Kind;

} // namespace

DepthRange depthRange(const Comparison& comparison) {
    double deepest = 0;
    for (const ObjectComparison& object : comparison.objects)
        if (object.object.reliefDepth) deepest = std::max(deepest, *object.object.reliefDepth);
    if (deepest > 0) return {0.25 * deepest, "a quarter of the relief depth"};
    const Figure& p95 = comparison.pooled.depth.world.p95;
    if (p95 && *p95 > 0) return {*p95, "95 % of the shared pixels lie within"};
    return {1, "no relief depth known, no error to scale by"};
}

std::string Report::save(const std::string& stem, const std::string& what, const Picture& picture) const {
    // Each part by itself: a long name must not cost what tells its pictures apart.
    const std::string file = safeFileName(stem) + (what.empty() ? "" : safeFileName(what)) + ".png";
    writePng(folder_ / file, picture.width, picture.height, picture.rgb);
    return file;
}

void Report::addReference(const Frame& reference) {
    pictures_.reference = save("reference", "", colorPicture(reference));
}

std::vector<ReportPicture> Report::saveDifferences(const std::string& stem, const Comparison& comparison,
                                                   const Frame& reference, const Frame& test) const {
    std::vector<ObjectInfo> objects;
    for (const ObjectComparison& object : comparison.objects)
        objects.push_back(object.object);
    const FramePair pair(reference, test, objects);

    std::vector<ReportPicture> entries;
    entries.push_back({save(stem, "_color", colorPicture(test)), "Colour", Kind::Color});
    entries.push_back(
        {save(stem, "_silhouette", silhouettePicture(pair)), "Silhouette difference", Kind::Silhouette});
    if (!comparison.referenceDepth.empty() && !comparison.testDepth.empty()) {
        const DepthRange range = depthRange(comparison);
        const Picture picture =
            depthErrorPicture(pair, comparison.referenceDepth, comparison.testDepth, range.worldUnits);
        entries.push_back({save(stem, "_depth", picture), "Depth error, signed", Kind::DepthError,
                           fmt::format("{:.3g}", range.worldUnits), range.note});
    }
    for (const auto& [light, agreement] : comparison.pooled.shadow)
        if (pair.missingChannel(shadowChannel(light)).empty())
            entries.push_back({save(stem, "_shadow_" + light, shadowPicture(pair, light)),
                               "Shadow difference, light " + light, Kind::Shadow});
    const SearchIterations& iterations = comparison.pooled.iterations;
    if (iterations.most && *iterations.most > 0 && test.has("id")) {
        // By the 99th percentile, or a few pixels would leave the rest pale.
        const double most = std::max(*iterations.p99, 1.0);
        entries.push_back({save(stem, "_iterations", iterationsPicture(test, most)),
                           "Iterations of the search", Kind::Iterations, fmt::format("{:.0f}", most), "",
                           iterations.histogram});
    }
    return entries;
}

/// Fig. 5.28 of Watt and Policarpo (2005), chapter 5: one picture along s and one along t, at one range; the cross term where a base has
/// one.
void Report::saveCurvature(const std::string& stem, const Frame& test,
                           std::vector<ReportPicture>& entries) const {
    const std::vector<std::pair<std::string, std::string>> channels{
        {"curvature.a", "Base's curvature along s: A"},
        {"curvature.b", "Base's curvature along t: B"},
        {"curvature.cross", "Base's cross term C"}};
    double range = 0;
    for (const auto& [channel, caption] : channels) {
        if (!test.has(channel) || !test.has("id")) return;
        range = std::max(range, curvatureRange(test, channel));
    }
    if (!(range > 0)) return; // no base is bent
    for (const auto& [channel, caption] : channels)
        if (channel != "curvature.cross" || curvatureRange(test, channel) > 0)
            entries.push_back({save(stem, "_" + channel, curvaturePicture(test, channel, range)), caption,
                               Kind::Curvature, fmt::format("{:.3g}", range)});
}

void Report::addTechnique(const TechniqueOutcome& technique, const Frame& reference, const Frame& test) {
    // The number keeps names apart that safeFileName makes equal.
    const std::string stem = fmt::format("{}_{}", pictures_.techniques.size() + 1, technique.name);
    std::vector<ReportPicture>& entries = pictures_.techniques[technique.name];
    entries = saveDifferences(stem, technique.comparison, reference, test);
    saveCurvature(stem, test, entries);
}

void Report::addBaseGap(const Comparison& gap, const Frame& reference, const Frame& proxyReference) {
    pictures_.baseGap = saveDifferences("base_gap", gap, reference, proxyReference);
}

void Report::write(const Results& results) const {
    replaceFile(folder_ / "index.html", reportPage(results, pictures_));
}

} // namespace plumbline
