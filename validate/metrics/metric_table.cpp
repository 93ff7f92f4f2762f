#include "validate/metrics/metric_table.h"

#include "validate/metrics/boundary_iou.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace plumbline {
namespace {

/// A metric without what all of its group have.
struct Row {
    std::string key, label, unit, best, better, meaning, formula = {}, source = {};
};

/// Of a group, in the order of results.csv.
struct Section {
    std::string group, domain;
    bool perObject;
    std::vector<Row> rows;
};

const char* const kShared = "pixels that show the same object in R and in T, with finite values in both";
const char* const kCovered = "pixels that T covers";

Section silhouette() {
    return {
        "silhouette",
        "all pixels; R and T: those that show the object in reference and test",
        true,
        {{"iou", "silhouette IoU", "1", "1", "high", "pixels that show the object in both frames / in either",
          "Σ|R∩T| / Σ|R∪T|, sums over the objects", "Jaccard 1901"},
         {"iou_low", "silhouette IoU, lowest", "1", "1", "high",
          "lowest iou that the reference's uncertain pixels leave open"},
         {"iou_high", "silhouette IoU, highest", "1", "1", "high", "highest one"},
         {"missing_px", "missing", "px", "0", "low", "pixels that should show the object and don't",
          "Σ|R∖T|"},
         {"extra_px", "extra", "px", "0", "low", "pixels that show the object and shouldn't", "Σ|T∖R|"},
         {"reference_px", "in the reference", "px", "", "", "pixels of the object in the reference", "Σ|R|"},
         {"test_px", "in the test", "px", "", "", "pixels of the object in the test", "Σ|T|"},
         {"intersection_px", "in both", "px", "", "", "numerator of iou", "Σ|R∩T|"},
         {"union_px", "in either", "px", "", "", "denominator of iou", "Σ|R∪T|"},
         {"uncertain_px", "uncertain", "px", "", "",
          "pixels at which the reference can't tell which object is seen"}}};
}

Section boundary() {
    Section section{"silhouette.boundary_iou",
                    "rims R_d, T_d: the object's pixels with one outside it, in the picture, at most d away",
                    true,
                    {}};
    for (const std::string width : kBoundaryWidths) {
        const std::string d = width == "2pct" ? "d = 2 % of the picture's diagonal, at least 1 px"
                                              : fmt::format("d = {} px", width.substr(0, width.find('p')));
        const std::string label = width == "2pct" ? "boundary IoU 2 %" : "boundary IoU " + width;
        section.rows.insert(
            section.rows.end(),
            {{width, label, "1", "1", "high", "iou of the rims of the two silhouettes, " + d,
              "Σ|R_d∩T_d| / Σ|R_d∪T_d|, sums over the objects", "Cheng et al. 2021, CVPR, Eq. 4"},
             {width + "_low", label + ", lowest", "1", "1", "high",
              "no true image that the reference's uncertain pixels leave open has a lower one"},
             {width + "_high", label + ", highest", "1", "1", "high", "none has a higher one"},
             {width + "_intersection_px", label + ", in both", "px", "", "", "its numerator", "Σ|R_d∩T_d|"},
             {width + "_union_px", label + ", in either", "px", "", "", "its denominator", "Σ|R_d∪T_d|"}});
    }
    return section;
}

Section contour() {
    return {
        "silhouette",
        "contours A of R, B of T: pixels with a 4-neighbour in the picture outside the silhouette",
        true,
        {{"contour_mean_px", "outline off, mean", "px", "0", "low",
          "mean distance of either outline's pixels to the other outline",
          "(Σ_a d(a,B) + Σ_b d(b,A)) / (|A| + |B|)", "Heimann et al. 2009, IEEE TMI 28(8)"},
         {"hausdorff95_px", "outline off, 95 %", "px", "0", "low",
          "95th percentile of it from one outline to the other: the larger of the two",
          "max(p95_a d(a,B), p95_b d(b,A))", "Huttenlocher et al. 1993, IEEE PAMI 15(9); Taha, Hanbury 2015"},
         {"contour_reference_px", "outline in the reference", "px", "", "",
          "pixels of the outline in the reference", "|A|"},
         {"contour_test_px", "outline in the test", "px", "", "", "pixels of the outline in the test",
          "|B|"}}};
}

Section depth() {
    const std::string relief = "relief depth", badPixel = "Scharstein, Szeliski 2002, IJCV 47";
    Section section{"depth", kShared, true, {}};
    std::vector<Row>& rows = section.rows;
    rows.push_back({"domain_px", "depth compared", "px", "", "", "pixels compared"});
    const std::vector<Row> errors{
        {"bias", "depth bias", "", "0", "low", "mean error; positive: too far away", "mean e, e = Z_T - Z_R"},
        {"mae", "depth MAE", "", "0", "low", "mean magnitude of the error", "mean |e|"},
        {"rmse", "depth RMSE", "", "0", "low", "root of the mean squared error", "√(mean e²)"},
        {"p50", "depth p50", "", "0", "low", "median magnitude of the error", "p50 |e|, nearest rank"},
        {"p95", "depth p95", "", "0", "low", "95th percentile of it", "p95 |e|, nearest rank"},
        {"p99", "depth p99", "", "0", "low", "99th percentile of it", "p99 |e|, nearest rank"},
        {"max", "depth max", "", "0", "low", "largest magnitude of the error", "max |e|"}};
    for (Row row : errors) {
        row.unit = "world";
        rows.push_back(row);
    }
    for (Row row : errors) {
        row.key += "_relief";
        row.label += ", relief";
        row.unit = relief;
        row.formula += "; e in relief depths of the pixel's object";
        rows.push_back(row);
    }
    for (const std::string percent : {"1", "5", "25"})
        rows.push_back({"badpix_" + percent + "pct", "off by > " + percent + " %", "1", "0", "low",
                        "share of the domain off by more than " + percent + " % of the relief depth",
                        "mean [ |e| > " + percent + " % of the relief depth ], strictly", badPixel});
    for (const std::string percent : {"1", "5", "25"})
        rows.push_back({"badpix_" + percent + "pct_px", "off by > " + percent + " %", "px", "0", "low",
                        "numerator of badpix_" + percent + "pct"});
    rows.insert(rows.end(), {{"only_reference_px", "only in the reference", "px", "0", "low",
                              "pixels only the reference covers with the object: not in the domain"},
                             {"only_test_px", "only in the test", "px", "0", "low",
                              "pixels only the test covers with it: not in the domain"},
                             {"invalid_px", "without depth", "px", "0", "low",
                              "shared pixels without a finite depth in both: not in the domain"},
                             {"uncertain_px", "uncertain", "px", "", "",
                              "pixels of the domain that may show another object in truth, or none"}});
    return section;
}

Section shadow() {
    return {
        "shadow",
        kShared,
        true,
        {{"domain_px", "shadow compared", "px", "", "",
          "pixels compared; in shadow: a value of 0.5 and more"},
         {"agreement", "shadow agreement", "1", "1", "high",
          "share of the domain where both are lit or both in shadow", "(TP + TN) / (TP + TN + FP + FN)"},
         {"agreement_low", "shadow agreement, lowest", "1", "1", "high",
          "lowest agreement that the reference's uncertain pixels leave open"},
         {"agreement_high", "shadow agreement, highest", "1", "1", "high", "highest one"},
         {"iou", "shadow IoU", "1", "1", "high", "in shadow in both / in either", "TP / (TP + FP + FN)",
          "Jaccard 1901"},
         {"iou_low", "shadow IoU, lowest", "1", "1", "high", "lowest iou that uncertain pixels leave open"},
         {"iou_high", "shadow IoU, highest", "1", "1", "high", "highest one"},
         {"f1", "shadow F1", "1", "1", "high", "harmonic mean of the test's precision and recall on shadow",
          "2 TP / (2 TP + FP + FN)", "Dice 1945"},
         {"f1_low", "shadow F1, lowest", "1", "1", "high", "lowest f1 that uncertain pixels leave open"},
         {"f1_high", "shadow F1, highest", "1", "1", "high", "highest one"},
         {"ber", "shadow error rate", "1", "0", "low",
          "balanced error rate: mean of the error rates on lit and on dark pixels",
          "½ (FP / (TN + FP) + FN / (TP + FN))"},
         {"false_shadow_px", "false shadow", "px", "0", "low", "lit in the reference, in shadow in the test",
          "FP"},
         {"false_lit_px", "false lit", "px", "0", "low", "in shadow in the reference, lit in the test", "FN"},
         {"both_shadow_px", "shadow in both", "px", "", "", "in shadow in both", "TP"},
         {"both_lit_px", "lit in both", "px", "", "", "lit in both", "TN"},
         {"invalid_px", "without shadow", "px", "0", "low",
          "shared pixels without a finite shadow value in both: not in the domain"},
         {"uncertain_px", "uncertain", "px", "", "",
          "pixels of the test whose shadow in the reference, or part in the domain, is uncertain"}}};
}

Section shadowKinds() {
    Section section{"shadow",
                    "of shadow's domain; N the reference's normal on the camera's side, L towards the light",
                    true,
                    {}};
    for (const auto& [kind, where] :
         {std::pair<std::string, std::string>("attached", "N·L <= 0"), {"cast", "N·L > 0"}})
        section.rows.insert(
            section.rows.end(),
            {{kind + "_domain_px", kind + " shadow compared", "px", "", "",
              kind == "attached" ? "pixels turned away from the light: dark in truth"
                                 : "pixels turned towards the light: every shadow there is cast",
              where},
             {kind + "_agreement", kind + " shadow agreement", "1", "1", "high",
              "share of them where both are lit or both in shadow", "agreement over " + where},
             {kind + "_false_shadow_px", kind + ", false shadow", "px", "0", "low",
              "of them, lit in the reference and in shadow in the test", "FP over " + where},
             {kind + "_false_lit_px", kind + ", false lit", "px", "0", "low",
              "of them, in shadow in the reference and lit in the test", "FN over " + where}});
    section.rows.push_back({"no_normal_px", "without normal", "px", "", "",
                            "pixels of shadow's domain where the reference has no normal: in neither part"});
    return section;
}

Section normal() {
    return {"normal",
            kShared,
            true,
            {{"domain_px", "normals compared", "px", "", "", "pixels compared"},
             {"mean_degrees", "normal, mean", "degrees", "0", "low", "mean angle between the normals",
              "mean atan2(|a×b|, a·b)", "Kahan, How Futile are Mindless Assessments of Roundoff, 2006"},
             {"p95_degrees", "normal, 95 %", "degrees", "0", "low", "95th percentile of the angle",
              "p95, nearest rank"},
             {"invalid_px", "without normal", "px", "0", "low",
              "shared pixels without a normal in both: not in the domain"}}};
}

Section st() {
    return {"st",
            kShared,
            true,
            {{"domain_px", "st compared", "px", "", "", "pixels compared"},
             {"mean_texels", "st, mean", "texels", "0", "low",
              "mean distance in the height map between the places seen",
              "mean |(Δs·W, Δt·H)|, modulo one tile along an axis that repeats"},
             {"p95_texels", "st, 95 %", "texels", "0", "low", "95th percentile of it", "p95, nearest rank"},
             {"invalid_px", "without st", "px", "0", "low",
              "shared pixels without a finite st in both: not in the domain"}}};
}

Section image() {
    return {
        "image",
        "all pixels of the picture, background included, with finite colours in both",
        false,
        {{"domain_px", "picture compared", "px", "", "", "pixels compared"},
         {"psnr_db", "PSNR", "dB", "", "high",
          "peak signal-to-noise ratio of the sRGB pictures; none where they are equal", "20 log10(1 / rmse)"},
         {"rmse", "picture RMSE", "1", "0", "low", "root of the mean squared difference of sRGB codes / 255",
          "√(mean ((c_T - c_R) / 255)²) over pixels and channels"},
         {"badpix_2codes", "off by > 2 codes", "1", "0", "low",
          "share of them a channel of which is off by more than 2 sRGB codes of 255",
          "mean [ max over channels |c_T - c_R| > 2 ]"},
         {"badpix_2codes_px", "off by > 2 codes", "px", "0", "low", "numerator of badpix_2codes"},
         {"invalid_px", "without colour", "px", "0", "low",
          "pixels without a finite colour in both frames: not in the domain"}}};
}

Section cost() {
    return {"cost",
            kCovered,
            true,
            {{"fetches_mean", "look-ups, mean", "look-ups", "", "low",
              "look-ups of height and baked maps a covered pixel"},
             {"fetches_p99", "look-ups, 99 %", "look-ups", "", "low", "99th percentile of it, nearest rank"},
             {"fetches_px", "look-ups counted", "px", "", "", "covered pixels counted"},
             {"fetches_height_mean", "height look-ups", "look-ups", "", "low", "those of the height map"},
             {"fetches_baked_mean", "baked look-ups", "look-ups", "", "low",
              "those of baked maps: cone ratios, distances, normals, bounds"},
             {"iterations_mean", "rounds, mean", "rounds", "", "low",
              "rounds of the search of a covered pixel's view ray"},
             {"iterations_p99", "rounds, 99 %", "rounds", "", "low", "99th percentile of it, nearest rank"},
             {"iterations_max", "rounds, most", "rounds", "", "low",
              "the most; iterations_histogram counts pixels by rounds"}}};
}

Section costOfRun() {
    return {"cost",
            "the technique in this run",
            false,
            {{"bake_ms", "bake time", "ms", "", "low",
              "time its baked maps took to make, now or when they came into the cache"},
             {"bake_bytes", "bake size", "bytes", "", "low", "size of its baked maps as held for drawing"},
             {"ms_median", "time", "ms", "", "low", "median time of one frame, warm"}}};
}

std::vector<MetricInfo> makeTable() {
    std::vector<MetricInfo> table;
    for (const Section& section : {silhouette(), boundary(), contour(), depth(), shadow(), shadowKinds(),
                                   normal(), st(), image(), cost(), costOfRun()})
        for (const Row& row : section.rows)
            table.push_back({section.group + "." + row.key, row.label, row.unit, row.best, row.better,
                             row.formula, section.domain, row.source, row.meaning, section.perObject});
    return table;
}

} // namespace

std::span<const MetricInfo> metricTable() {
    static const std::vector<MetricInfo> table = makeTable();
    return table;
}

const MetricInfo* findMetric(std::string_view key) {
    const auto table = metricTable();
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const MetricInfo& metric) { return metric.key == key; });
    return found == table.end() ? nullptr : &*found;
}

bool hasInterval(const MetricInfo& metric) {
    return findMetric(metric.key + "_low") != nullptr;
}

std::string describe(const MetricInfo& metric) {
    std::string text = fmt::format("{}  {}, {}", metric.key, metric.label,
                                   metric.unit == "1" ? "a ratio" : "in " + metric.unit);
    if (!metric.better.empty()) text += fmt::format(", {} is better", metric.better);
    if (!metric.best.empty()) text += ", best " + metric.best;
    text += "\n    " + metric.meaning + "\n";
    if (!metric.formula.empty()) text += "    formula: " + metric.formula + "\n";
    text += "    domain: " + metric.domain + "\n";
    text += metric.perObject ? "    of each object and pooled" : "    pooled only";
    text += hasInterval(metric) ? ", with an interval\n" : "\n";
    if (!metric.source.empty()) text += "    source: " + metric.source + "\n";
    return text;
}

} // namespace plumbline
