#include "report_page.h"

#include "../scenes/data_folder.h"
#include "../scenes/error.h"
#include "output_files.h"
#include "pictures.h"

#include <fmt/format.h>
#include <kainjow/mustache.hpp>

#include <fstream>
#include <set>
#include <sstream>

namespace plumbline {
namespace {

using kainjow::mustache::data;

std::string readTemplate() {
    const std::filesystem::path file = dataFolder() / "validate" / "report" / "index.mustache";
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream)
        throw MachineError(file.string(), "the report's template can't be read", "an undamaged installation");
    return text.str();
}

/// Sets only what there is to say: an empty string would still open its section of the template.
void setIfAny(data& entry, const std::string& key, const std::string& text) {
    if (!text.empty()) entry.set(key, text);
}

data cell(const Figure& figure, const char* format) {
    data entry{data::type::object};
    entry.set("text", figure ? fmt::format(fmt::runtime(format), *figure) : std::string("–"));
    setIfAny(entry, "reason", figure.reason());
    return entry;
}

/// A figure with its interval below it.
data cell(const Figure& figure, const Interval& interval, const char* format) {
    data entry = cell(figure, format);
    if (interval.low)
        entry.set("interval", fmt::format("{}–{}", fmt::format(fmt::runtime(format), *interval.low),
                                          fmt::format(fmt::runtime(format), *interval.high)));
    return entry;
}

data cell(uint64_t count) {
    data entry{data::type::object};
    entry.set("text", std::to_string(count));
    return entry;
}

std::set<std::string> lightsOf(const Results& results) {
    std::set<std::string> lights;
    for (const TechniqueOutcome& technique : results.techniques)
        for (const auto& [light, shadow] : technique.comparison.pooled.shadow)
            lights.insert(light);
    return lights;
}

data metricCells(const MetricSet& metrics, const std::set<std::string>& lights, const Figure& milliseconds) {
    data cells{data::type::list};
    cells << cell(metrics.silhouette.iou, metrics.silhouette.iouRange, "{:.5f}")
          << cell(metrics.silhouette.missingPx) << cell(metrics.silhouette.extraPx)
          << cell(metrics.depth.relief.bias, "{:+.4f}") << cell(metrics.depth.relief.rmse, "{:.4f}")
          << cell(metrics.depth.relief.p99, "{:.4f}") << cell(metrics.depth.badpix5pct, "{:.4f}");
    for (const std::string& light : lights) {
        const auto found = metrics.shadow.find(light);
        const ShadowAgreement shadow = found == metrics.shadow.end() ? ShadowAgreement{} : found->second;
        cells << cell(shadow.agreement, shadow.agreementRange, "{:.4f}") << cell(shadow.ber, "{:.4f}");
    }
    cells << cell(metrics.normal.meanDegrees, "{:.2f}") << cell(metrics.st.meanTexels, "{:.2f}")
          << cell(metrics.cost.mean, "{:.1f}") << cell(milliseconds, "{:.1f}");
    return cells;
}

data headCells(const std::set<std::string>& lights) {
    data heads{data::type::list};
    const auto add = [&heads](const std::string& text, const std::string& unit) {
        data head{data::type::object};
        head.set("text", text);
        setIfAny(head, "unit", unit);
        heads << head;
    };
    add("silhouette IoU", "");
    add("missing", "px");
    add("extra", "px");
    add("depth bias", "relief depth");
    add("depth RMSE", "relief depth");
    add("depth p99", "relief depth");
    add("off by > 5 %", "share");
    for (const std::string& light : lights) {
        add("shadow agreement", light);
        add("shadow error rate", light + ", balanced");
    }
    add("normal", "mean, degrees");
    add("st", "mean, texels");
    add("look-ups", "a pixel");
    add("time", "ms");
    return heads;
}

std::string withThousands(double count) {
    std::string digits = fmt::format("{:.0f}", count);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<size_t>(at), " ");
    return digits;
}

/// What the reader must know about the reference before trusting it; a sentence each.
std::vector<std::string> referenceLimits(const ReferenceSummary& reference) {
    std::vector<std::string> limits;
    for (const ReferenceSummary::Object& object : reference.objects)
        if (object.rate < object.wantedRate)
            limits.push_back(
                fmt::format("{}: {} segments per control edge instead of the {} that half a texel and half a "
                            "pixel ask for; the memory or rate given didn't allow more.",
                            object.name, object.rate, object.wantedRate));
    for (const std::string& sentence : certificateSentences(reference.certificate))
        limits.push_back(sentence);
    limits.emplace_back("One sample a pixel, at its centre, without anti-aliasing.");
    return limits;
}

data listOfTexts(const std::vector<std::string>& texts) {
    data list{data::type::list};
    for (const std::string& text : texts)
        list << data(text);
    return list;
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

data paletteData() {
    data colors{data::type::object};
    for (const auto& [name, color] :
         {std::pair("nothing", palette::kNothing), std::pair("agree", palette::kAgree),
          std::pair("missing", palette::kMissing), std::pair("extra", palette::kExtra),
          std::pair("other", palette::kOther), std::pair("dark", palette::kBothDark),
          std::pair("invalid", palette::kInvalid)})
        colors.set(name, cssColor(color));
    std::string gradient;
    for (int i = -4; i <= 4; ++i)
        gradient += (i > -4 ? "," : "") + cssColor(divergingColor(i / 4.0));
    colors.set("gradient", gradient);
    return colors;
}

std::string parametersText(const std::map<std::string, std::string>& parameters) {
    std::string text;
    for (const auto& [key, value] : parameters)
        text += (text.empty() ? "" : ", ") + key + " = " + value;
    return text;
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
        picture.set("range", entry.range);
        picture.set("range_note", entry.rangeNote);
        pictures << picture;
    }
    return pictures;
}

data objectRows(const Comparison& comparison, const std::set<std::string>& lights) {
    data objects{data::type::list};
    for (const ObjectComparison& object : comparison.objects) {
        data row{data::type::object};
        row.set("object", object.object.name);
        row.set("object_cells",
                metricCells(object.metrics, lights, Figure::absent("time is measured for the whole frame")));
        objects << row;
    }
    return objects;
}

data techniqueSection(const TechniqueOutcome& technique, const std::set<std::string>& lights,
                      const std::vector<ReportPicture>& pictures) {
    data section{data::type::object};
    section.set("name", technique.name);
    section.set("anchor", safeFileName(technique.name));
    setIfAny(section, "parameters", parametersText(technique.parameters));
    if (!technique.renderer.empty())
        section.set("renderer", fmt::format("{}, {}", technique.renderer, technique.backend));
    if (technique.msMedian)
        section.set("timer", fmt::format("{:.1f} ms, median of {} ({})", *technique.msMedian,
                                         technique.msRuns, technique.timer));
    section.set("technique_limits", listOfTexts(technique.limits));
    if (technique.error) {
        section.set("error", *technique.error);
        return section;
    }
    const Comparison& comparison = technique.comparison;
    section.set("cells", metricCells(comparison.pooled, lights, technique.msMedian));
    section.set("objects", objectRows(comparison, lights));
    section.set("several_objects", comparison.objects.size() > 1);
    section.set("notes", listOfTexts(comparison.notes));
    section.set("pictures", pictureList(pictures));
    return section;
}

} // namespace

std::string reportPage(const Results& results, const ReportPictures& pictures) {
    const std::set<std::string> lights = lightsOf(results);
    data page{data::type::object};
    page.set("scene", results.scene.name);
    setIfAny(page, "purpose", results.scene.purpose);
    page.set("program", results.program);
    setIfAny(page, "hash", results.scene.hash);
    page.set("width", std::to_string(results.scene.width));
    page.set("height", std::to_string(results.scene.height));
    page.set("reference_picture", pictures.reference);
    page.set("reference", referenceData(results.reference));
    page.set("colors", paletteData());
    page.set("heads", headCells(lights));
    data sections{data::type::list};
    for (const TechniqueOutcome& technique : results.techniques) {
        const auto found = pictures.techniques.find(technique.name);
        sections << techniqueSection(technique, lights,
                                     found == pictures.techniques.end() ? std::vector<ReportPicture>{}
                                                                        : found->second);
    }
    page.set("techniques", sections);

    kainjow::mustache::mustache layout(readTemplate());
    if (!layout.is_valid())
        throw MachineError("validate/report/index.mustache", layout.error_message(), "a valid template");
    return layout.render(page);
}

} // namespace plumbline
