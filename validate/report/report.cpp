#include "report.h"

#include "../../scenes/error.h"
#include "../../scenes/image_file.h"
#include "../../scenes/read_file.h"
#include "../../scenes/replace_file.h"
#include "../output_files.h"
#include "layer_packing.h"
#include "page_bundle.h"
#include "pictures.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline {
namespace {

using Kind = ReportPicture::Kind;

FramePair pairOf(const Comparison& comparison, const Frame& reference, const Frame& test) {
    std::vector<ObjectInfo> objects;
    for (const ObjectComparison& object : comparison.objects)
        objects.push_back(object.object);
    return {reference, test, objects};
}

} // namespace

Report::Report(std::filesystem::path folder, ReportOptions options)
    : folder_(std::move(folder)), options_(options) {
    if (!options_.interactive || options_.singleFile) return;
    requireWritableFolder(folder_ / "data");
    replaceFile(folder_ / "report.js", report::pageScript());
}

std::string Report::save(const std::string& stem, const std::string& what, const Picture& picture) const {
    // Each part by itself: a long name must not cost what tells its pictures apart.
    const std::string file = safeFileName(stem) + (what.empty() ? "" : safeFileName(what)) + ".png";
    writePng(folder_ / file, picture.width, picture.height, picture.rgb);
    if (!options_.singleFile) return file;
    const std::string bytes = readWholeFile(folder_ / file);
    std::filesystem::remove(folder_ / file);
    return "data:image/png;base64," +
           report::base64({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
}

void Report::saveFrame(report::FrameEntry entry, const report::FrameData& frame) {
    entry.layers = frame.layers;
    if (options_.singleFile)
        embedded_.emplace_back(entry.file, frame.json);
    else
        replaceFile(folder_ / entry.file, report::frameScript(entry.file, frame));
    data_.frames.push_back(std::move(entry));
}

void Report::addReference(const Frame& reference) {
    pictures_.reference = save("reference", "", colorPicture(reference));
}

std::vector<ReportPicture> Report::saveDifferences(const std::string& stem, const Comparison& comparison,
                                                   const FramePair& pair) const {
    const Frame& test = pair.test();
    std::vector<ReportPicture> entries;
    entries.push_back({save(stem, "_color", colorPicture(test)), "Colour", Kind::Color});
    entries.push_back(
        {save(stem, "_silhouette", silhouettePicture(pair)), "Silhouette difference", Kind::Silhouette});
    if (!comparison.referenceDepth.empty() && !comparison.testDepth.empty()) {
        const report::DepthRange range = report::depthRange(comparison);
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

/// The planes of a frame held against the reference; before the first one those of the reference, since only a pair
/// knows whether objects are told apart and where depth comes from.
void Report::saveTest(const std::string& stem, report::FrameEntry entry, const Comparison& comparison,
                      const FramePair& pair) {
    if (data_.frames.empty()) {
        data_.objects = pair.objects();
        data_.depthRange = report::depthRange(comparison);
        saveFrame({.name = "reference", .kind = "reference", .file = "data/reference.js", .layers = {}},
                  report::packReference(pair, comparison.referenceDepth));
    }
    entry.file = fmt::format("data/{}.js", safeFileName(stem));
    entry.curves = report::errorCurves(pair, comparison);
    saveFrame(std::move(entry), report::packTest(pair, comparison.testDepth));
}

void Report::addTechnique(const TechniqueOutcome& technique, const Frame& reference, const Frame& test) {
    // The number keeps names apart that safeFileName makes equal.
    const std::string stem = fmt::format("{}_{}", pictures_.techniques.size() + 1, technique.name);
    const FramePair pair = pairOf(technique.comparison, reference, test);
    std::vector<ReportPicture>& entries = pictures_.techniques[technique.name];
    if (options_.interactive) {
        failing_.add(pair, technique.comparison);
        saveTest(stem, {.name = technique.name, .kind = "technique", .file = {}, .layers = {}},
                 technique.comparison, pair);
    } else {
        entries = saveDifferences(stem, technique.comparison, pair);
    }
    saveCurvature(stem, test, entries);
}

void Report::addBaseGap(const Comparison& gap, const Frame& reference, const Frame& proxyReference) {
    const FramePair pair = pairOf(gap, reference, proxyReference);
    if (options_.interactive)
        saveTest("reference_proxy",
                 {.name = "reference on the proxy", .kind = "proxy", .file = {}, .layers = {}}, gap, pair);
    else
        pictures_.baseGap = saveDifferences("base_gap", gap, pair);
}

void Report::write(const Results& results) const {
    if (!options_.interactive) {
        replaceFile(folder_ / "index.html", reportPage(results, pictures_, {}));
        return;
    }
    report::ReportData data = data_;
    PageScripts scripts;
    if (options_.singleFile) scripts.script = std::string(report::pageScript());
    if (failing_.techniques() > 0) {
        data.failingOf = failing_.techniques();
        const report::FrameData summary = report::packCounts("failing", failing_.counts());
        data.frames.push_back({.name = "all techniques",
                               .kind = "summary",
                               .file = "data/failing.js",
                               .layers = summary.layers});
        if (options_.singleFile)
            scripts.frames.emplace_back(data.frames.back().file, summary.json);
        else
            replaceFile(folder_ / data.frames.back().file,
                        report::frameScript(data.frames.back().file, summary));
    }
    scripts.data = report::reportDataJson(results, data);
    scripts.frames.insert(scripts.frames.end(), embedded_.begin(), embedded_.end());
    replaceFile(folder_ / "index.html", reportPage(results, pictures_, scripts));
}

} // namespace plumbline
