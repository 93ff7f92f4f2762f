#include "validate/report/report.h"

#include "scenes/core/error.h"
#include "scenes/core/read_file.h"
#include "scenes/core/replace_file.h"
#include "scenes/image/image_file.h"
#include "validate/report/layer_packing.h"
#include "validate/report/page_bundle.h"
#include "validate/report/pictures.h"
#include "validate/results/output_files.h"

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

/// Removes the frames of an earlier run. They are recognized by their beginning, because the folder may
/// contain other files.
void removeOldFrames(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (!entry.is_regular_file() || entry.path().extension() != ".js") continue;
        std::string beginning(report::kFrameScriptBeginning.size(), ' ');
        InputFile(entry.path()).read(beginning);
        std::error_code ignored; // the page doesn't show files that remain
        if (beginning == report::kFrameScriptBeginning) std::filesystem::remove(entry.path(), ignored);
    }
}

} // namespace

Report::Report(std::filesystem::path folder, ReportOptions options)
    : folder_(std::move(folder)), options_(options) {
    if (!options_.interactive || options_.singleFile) return;
    requireWritableFolder(folder_ / "data");
    removeOldFrames(folder_ / "data");
    replaceFile(folder_ / "report.js", report::pageScript());
}

std::string Report::save(const std::string& stem, const std::string& what, const Picture& picture) {
    // The parts are shortened separately, so that the images of a technique with a long name keep different
    // names.
    std::string file =
        pictureNames_.add(safeFileName(stem) + (what.empty() ? "" : safeFileName(what))) + ".png";
    writePng(folder_ / file, picture.width, picture.height, picture.rgb);
    if (!options_.singleFile) return file;
    const std::string bytes = readWholeFile(folder_ / file);
    std::filesystem::remove(folder_ / file);
    return "data:image/png;base64," +
           report::base64({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
}

/// Replaces an earlier frame with the same id.
void Report::saveFrame(report::FrameEntry entry, const report::FrameData& frame) {
    entry.layers = frame.layers;
    if (options_.singleFile)
        embedded_[entry.file] = frame.json;
    else
        replaceFile(folder_ / entry.file, report::frameScript(entry.file, frame));
    const auto found = std::find_if(data_.frames.begin(), data_.frames.end(),
                                    [&](const report::FrameEntry& each) { return each.id == entry.id; });
    if (found != data_.frames.end())
        *found = std::move(entry);
    else
        data_.frames.push_back(std::move(entry));
}

void Report::saveReference(const FramePair& pair, std::span<const float> depth) {
    saveFrame(
        {.id = "r", .name = "reference", .kind = "reference", .file = "data/reference.js", .layers = {}},
        report::packReference(pair, depth));
}

void Report::addReference(const Frame& reference) {
    pictures_.reference = save("reference", "", colorPicture(reference));
    if (!options_.interactive) return;
    const FramePair alone(reference, reference, {});
    data_.objects = alone.objects();
    saveReference(alone, reference.has("Z") ? reference.channel("Z") : std::span<const float>());
}

std::vector<ReportPicture> Report::saveDifferences(const std::string& stem, const Comparison& comparison,
                                                   const FramePair& pair) {
    const Frame& test = pair.test();
    std::vector<ReportPicture> entries;
    entries.push_back({save(stem, "_color", colorPicture(test)), "Color", Kind::Color});
    entries.push_back(
        {save(stem, "_silhouette", silhouettePicture(pair)), "Silhouette difference", Kind::Silhouette});
    if (!comparison.referenceDepth.empty() && !comparison.testDepth.empty()) {
        const report::DepthRange range = report::depthRange(comparison);
        const Picture picture =
            depthErrorPicture(pair, comparison.referenceDepth, comparison.testDepth, range.worldUnits);
        entries.push_back({save(stem, "_depth", picture), "Depth error, signed", Kind::DepthError,
                           fmt::format("{:.3g}", range.worldUnits), range.note});
    }
    for (const std::string& light : comparison.pooled.lights())
        if (pair.missingChannel(shadowChannel(light)).empty())
            entries.push_back({save(stem, "_shadow_" + light, shadowPicture(pair, light)),
                               "Shadow difference, light " + light, Kind::Shadow});
    const Figure &largest = comparison.pooled.figure("cost.iterations_max"),
                 &p99 = comparison.pooled.figure("cost.iterations_p99");
    if (largest && *largest > 0 && test.has("id")) {
        // Scaled by the 99th percentile, because the maximum of a few pixels would make all others pale.
        const double darkest = std::max(*p99, 1.0);
        entries.push_back({save(stem, "_iterations", iterationsPicture(test, darkest)),
                           "Iterations of the search", Kind::Iterations, fmt::format("{:.0f}", darkest), "",
                           comparison.pooled.histogram("cost.iterations_histogram")});
    }
    return entries;
}

/// Fig. 5.28 of Watt and Policarpo (2005), chapter 5: an image of the curvature along s and one along t with
/// the same range, and one of the cross term if a base has one.
void Report::saveCurvature(const std::string& stem, const Frame& test, std::vector<ReportPicture>& entries) {
    const std::vector<std::pair<std::string, std::string>> channels{
        {"curvature.a", "Base's curvature along s: A"},
        {"curvature.b", "Base's curvature along t: B"},
        {"curvature.cross", "Base's cross term C"}};
    double range = 0;
    for (const auto& [channel, caption] : channels) {
        if (!test.has(channel) || !test.has("id")) return;
        range = std::max(range, curvatureRange(test, channel));
    }
    if (!(range > 0)) return; // no base is curved
    for (const auto& [channel, caption] : channels)
        if (channel != "curvature.cross" || curvatureRange(test, channel) > 0)
            entries.push_back({save(stem, "_" + channel, curvaturePicture(test, channel, range)), caption,
                               Kind::Curvature, fmt::format("{:.3g}", range)});
}

/// Saves the planes of a frame that is compared with the reference. The first pair determines what depends on
/// two frames: the objects, whether both frames distinguish them, and the source of depth.
void Report::saveTest(const std::string& stem, report::FrameEntry entry, const Comparison& comparison,
                      const FramePair& pair) {
    if (data_.frames.size() == 1) {
        data_.objects = pair.objects();
        data_.depthRange = report::depthRange(comparison);
        if (!pair.hasObjectIds() || !pair.reference().has("Z"))
            saveReference(pair, comparison.referenceDepth);
    }
    entry.file = fmt::format("data/{}.js", safeFileName(stem));
    entry.curves = report::errorCurves(pair, comparison);
    saveFrame(std::move(entry), report::packTest(pair, comparison.testDepth));
}

void Report::addTechnique(const TechniqueOutcome& technique, const Frame& reference, const Frame& test) {
    // The number distinguishes names that safeFileName makes equal.
    const std::string stem = fmt::format("{}_{}", pictures_.techniques.size() + 1, technique.name);
    const FramePair pair = pairOf(technique.comparison, reference, test);
    std::vector<ReportPicture>& entries = pictures_.techniques[technique.name];
    if (options_.interactive) {
        if (!technique.control) failing_.add(pair, technique.comparison);
        saveTest(stem,
                 {.id = fmt::format("t{}", pictures_.techniques.size()),
                  .name = technique.name,
                  .kind = "technique",
                  .file = {},
                  .layers = {}},
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
                 {.id = "p", .name = "reference on the proxy", .kind = "proxy", .file = {}, .layers = {}},
                 gap, pair);
    else
        pictures_.baseGap = saveDifferences("base_gap", gap, pair);
}

void Report::write(const Results& results, bool last) {
    if (!options_.interactive) {
        if (last || !options_.singleFile)
            replaceFile(folder_ / "index.html", reportPage(results, pictures_, {}));
        return;
    }
    if (failing_.techniques() > 0) {
        data_.failingOf = failing_.techniques();
        saveFrame(
            {.id = "s", .name = "all techniques", .kind = "summary", .file = "data/failing.js", .layers = {}},
            report::packCounts("failing", failing_.counts()));
    }
    if (options_.singleFile && !last)
        return; // rewriting the whole file each time would take longer than the run
    PageScripts scripts;
    scripts.data = report::reportDataJson(results, data_);
    if (options_.singleFile) {
        scripts.script = report::pageScript();
        scripts.frames = embedded_;
    }
    replaceFile(folder_ / "index.html", reportPage(results, pictures_, scripts));
}

} // namespace plumbline
