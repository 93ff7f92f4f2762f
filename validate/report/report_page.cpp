#include "validate/report/report_page.h"

#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "validate/metrics/search_iterations.h"
#include "validate/report/colors.h"
#include "validate/report/page_bundle.h"
#include "validate/report/page_template.h"
#include "validate/report/report_cells.h"
#include "validate/report/report_data.h"
#include "validate/results/output_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace plumbline {
namespace {

using namespace report;

std::string withThousands(double count) {
    std::string digits = fmt::format("{:.0f}", count);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<size_t>(at), " ");
    return digits;
}

/// Limitations of the reference, a sentence each.
std::vector<std::string> referenceLimits(const ReferenceSummary& reference) {
    std::vector<std::string> limits;
    for (const ReferenceSummary::Object& object : reference.objects)
        if (object.rate < object.wantedRate)
            limits.push_back(fmt::format(
                "{}: {} segments per control edge instead of the {} needed for the requested error, because "
                "of the limit on memory or the given rate.",
                object.name, object.rate, object.wantedRate));
    for (const std::string& sentence : certificateSentences(reference.certificate))
        limits.push_back(sentence);
    limits.emplace_back("One sample per pixel, at its center, without anti-aliasing.");
    return limits;
}

data referenceData(const ReferenceSummary& reference) {
    data entry{data::type::object};
    if (reference.microTriangles) {
        data counted{data::type::object};
        counted.set("count", withThousands(*reference.microTriangles));
        counted.set("tessellate", cell(reference.tessellateMs, "{:.0f}"));
        counted.set("build", cell(reference.buildMs, "{:.0f}"));
        counted.set("trace", cell(reference.traceMs, "{:.0f}"));
        entry.set("counted", counted);
    }
    data objects{data::type::list};
    for (const ReferenceSummary::Object& object : reference.objects) {
        data row{data::type::object};
        row.set("name", object.name);
        row.set("rate", std::to_string(object.rate));
        row.set("wanted", std::to_string(object.wantedRate));
        row.set("triangles", withThousands(static_cast<double>(object.microTriangles)));
        objects << row;
    }
    entry.set("has_objects",
              data(reference.objects.empty() ? data::type::bool_false : data::type::bool_true));
    entry.set("objects", objects);
    entry.set("limits", listOfTexts(referenceLimits(reference)));
    return entry;
}

/// The colors of the palette, and color maps as stops of a CSS gradient.
data colorsData() {
    data colors{data::type::object};
    for (const auto& [name, color] : palette::all())
        colors.set(name, cssColor(color));
    for (const ColorMap& map : colormap::all()) {
        std::vector<std::string> stops;
        for (const Rgb& stop : map.stops)
            stops.push_back(cssColor(stop));
        colors.set(std::string(map.name), fmt::format("{}", fmt::join(stops, ",")));
    }
    return colors;
}

std::string parametersText(const std::map<std::string, std::string>& parameters) {
    std::string text;
    for (const auto& [key, value] : parameters)
        text += (text.empty() ? "" : ", ") + key + " = " + value;
    return text;
}

/// Bars of an SVG 100 wide and 30 high: pixels by number of iterations, the tallest bar at full height.
data histogramBars(const std::vector<uint64_t>& histogram) {
    data bars{data::type::list};
    uint64_t tallest = 1;
    for (const uint64_t count : histogram)
        tallest = std::max(tallest, count);
    const double width = 100.0 / static_cast<double>(std::max<size_t>(histogram.size(), 1));
    for (size_t iterations = 0; iterations < histogram.size(); ++iterations) {
        const double height =
            30.0 * static_cast<double>(histogram[iterations]) / static_cast<double>(tallest);
        const bool open = iterations == SearchIterations::kHistogramEnd;
        data bar{data::type::object};
        bar.set("x", fmt::format("{:.3f}", width * static_cast<double>(iterations)));
        bar.set("y", fmt::format("{:.3f}", 30.0 - height));
        bar.set("width", fmt::format("{:.3f}", 0.9 * width));
        bar.set("height", fmt::format("{:.3f}", height));
        bar.set("bar_title",
                fmt::format("{}{}: {} px", iterations, open ? " or more" : "", histogram[iterations]));
        bars << bar;
    }
    return bars;
}

data pictureList(const std::vector<ReportPicture>& entries) {
    data pictures{data::type::list};
    for (const ReportPicture& entry : entries) {
        data picture{data::type::object};
        picture.set("file", entry.file);
        picture.set("caption", entry.caption);
        picture.set("is_silhouette", entry.kind == ReportPicture::Kind::Silhouette);
        picture.set("is_depth", entry.kind == ReportPicture::Kind::DepthError);
        picture.set("is_shadow", entry.kind == ReportPicture::Kind::Shadow);
        picture.set("is_iterations", entry.kind == ReportPicture::Kind::Iterations);
        picture.set("is_curvature", entry.kind == ReportPicture::Kind::Curvature);
        picture.set("bars", histogramBars(entry.histogram));
        picture.set("range", entry.range);
        picture.set("range_note", entry.rangeNote);
        pictures << picture;
    }
    return pictures;
}

data objectRows(const TechniqueOutcome& technique, const std::vector<Column>& columns) {
    data objects{data::type::list};
    for (const ObjectComparison& object : technique.comparison.objects) {
        data row{data::type::object};
        row.set("object", object.object.name);
        row.set("object_cells", objectCells(columns, technique, object));
        objects << row;
    }
    return objects;
}

/// The requirements that the technique doesn't reach, a sentence each.
std::vector<std::string> missedRequirements(const TechniqueOutcome& technique) {
    std::vector<std::string> missed;
    for (const RequirementResult& each : technique.requirements) {
        if (each.passed) continue;
        const bool named =
            each.requirement.starts_with(each.key + " "); // otherwise it applies to every light
        missed.push_back(fmt::format("Required {}, found {}{}", each.requirement,
                                     each.value ? fmt::format("{}", *each.value)
                                                : "no figure (" + each.value.reason() + ")",
                                     named ? "" : " in " + each.key));
    }
    return missed;
}

/// `number`: from 1, in the order of the results.
data techniqueSection(size_t number, const TechniqueOutcome& technique, const std::vector<Column>& columns,
                      const std::vector<std::optional<double>>& best,
                      const std::vector<ReportPicture>& pictures) {
    data section{data::type::object};
    section.set("name", technique.name);
    section.set("anchor", fmt::format("technique-{}", number));
    setIfAny(section, "parameters", parametersText(technique.parameters));
    if (!technique.renderer.empty())
        section.set("renderer", fmt::format("{}, {}", technique.renderer, technique.backend));
    if (technique.cost.msMedian)
        section.set("timer", fmt::format("{:.1f} ms, median of {} ({})", *technique.cost.msMedian,
                                         technique.msRuns, technique.timer));
    const std::vector<std::string> missed = missedRequirements(technique);
    section.set("missed", listOfTexts(missed));
    if (!missed.empty())
        section.set("missed_text",
                    fmt::format("misses {} of {} required", missed.size(), technique.requirements.size()));
    section.set("technique_limits", listOfTexts(technique.limits));
    if (technique.error) {
        section.set("error", *technique.error);
        return section;
    }
    const Comparison& comparison = technique.comparison;
    section.set("cells", techniqueCells(columns, technique, best));
    section.set("objects", objectRows(technique, columns));
    section.set("several_objects", comparison.objects.size() > 1);
    section.set("notes", listOfTexts(comparison.notes));
    section.set("pictures", pictureList(pictures));
    return section;
}

data gapRow(const std::string& name, const Comparison& comparison, const std::vector<Column>& columns) {
    data row{data::type::object};
    row.set("row", name);
    row.set("gap_cells", cellsOf(columns, comparison.pooled));
    return row;
}

/// The gap between the two references, and each technique compared with the one on the proxy.
data baseGapData(const Results& results, const std::vector<Column>& columns, const ReportPictures& pictures) {
    data section{data::type::object};
    section.set("name", "the reference on the proxy");
    section.set("gap_heads", headsOf(columns));
    data rows{data::type::list};
    rows << gapRow("the base gap", results.proxy->gap, columns);
    for (const TechniqueOutcome& technique : results.techniques)
        if (technique.againstProxy) rows << gapRow(technique.name, *technique.againstProxy, columns);
    section.set("rows", rows);
    section.set("pictures", pictureList(pictures.baseGap));
    section.set("gap_limits", listOfTexts(referenceLimits(results.proxy->summary)));
    return section;
}

/// The page's data and, if all is one file, its frames and script: too large to go through a template.
std::string scriptElements(const PageScripts& scripts) {
    std::string text =
        fmt::format("<script type=\"application/json\" id=\"report-data\">{}</script>\n", scripts.data);
    for (const auto& [file, json] : scripts.frames)
        text += fmt::format("<script type=\"application/json\" data-file=\"{}\">{}</script>\n", file,
                            scriptSafe(json));
    if (!scripts.script.empty()) text += fmt::format("<script>{}</script>\n", scripts.script);
    return text;
}

} // namespace

std::string reportPage(const Results& results, const ReportPictures& pictures, const PageScripts& scripts) {
    const std::set<std::string> lights = lightsOf(results);
    const std::vector<Column> columns = techniqueColumns(lights);
    const auto best = bestOf(columns, results);
    data page{data::type::object};
    page.set("scene", results.scene.name);
    setIfAny(page, "purpose", results.scene.purpose);
    page.set("program", results.program);
    setIfAny(page, "hash", results.scene.hash);
    setIfAny(page, "changes", fmt::format("{}", fmt::join(results.scene.changes, ", ")));
    page.set("width", std::to_string(results.scene.width));
    page.set("height", std::to_string(results.scene.height));
    page.set("certificate", certificateLine(results.reference.certificate));
    page.set("reference_picture", pictures.reference);
    page.set("reference", referenceData(results.reference));
    page.set("colors", colorsData());
    page.set("style", std::string(pageStyle()));
    const bool interactive = !scripts.data.empty();
    page.set("interactive", interactive);
    if (!interactive) setIfAny(page, "plain_reason", std::string(plainReportReason()));
    page.set("script_beside", interactive && scripts.script.empty());
    page.set("heads", headsOf(columns));
    page.set("columns", std::to_string(columns.size()));
    page.set("has_best",
             std::any_of(best.begin(), best.end(), [](const auto& value) { return value.has_value(); }));
    data sections{data::type::list};
    size_t number = 0;
    bool missed = false;
    for (const TechniqueOutcome& technique : results.techniques) {
        missed |= std::any_of(technique.requirements.begin(), technique.requirements.end(),
                              [](const RequirementResult& each) { return !each.passed; });
        const auto found = pictures.techniques.find(technique.name);
        sections << techniqueSection(++number, technique, columns, best,
                                     found == pictures.techniques.end() ? std::vector<ReportPicture>{}
                                                                        : found->second);
    }
    page.set("has_missed", missed);
    page.set("techniques", sections);
    if (results.proxy) page.set("base_gap", baseGapData(results, metricColumns(lights), pictures));
    std::string pictureLayout = readTemplate("pictures.mustache");
    page.set("picture_list", data(kainjow::mustache::partial([&] { return pictureLayout; })));

    std::string text = renderTemplate("index.mustache", page);
    const size_t end = text.rfind("</body>");
    if (interactive && end != std::string::npos) text.insert(end, scriptElements(scripts));
    return text;
}

} // namespace plumbline
