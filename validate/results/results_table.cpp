#include "validate/results/results.h"
#include "validate/results/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

std::string shown(const Figure& figure, const char* format) {
    return figure ? fmt::format(fmt::runtime(format), *figure) : std::string("-");
}

/// How far the true figure may be from the one shown, rounded up: never less than it is.
std::string shownReach(const Interval& interval, const Figure& figure, int decimals) {
    constexpr double kRounding =
        1e-6; // of the last place: 0.3 - 0.2 is 1e-17 above 0.1 and no reason for 0.11
    const Figure reach = interval.reach(figure);
    if (!reach) return "-";
    const double scale = std::pow(10.0, decimals);
    return fmt::format("{:.{}f}", std::ceil(*reach * scale - kRounding) / scale, decimals);
}

/// The light with the worst agreement stands for all; results.csv has each.
ShadowAgreement worstShadow(const MetricSet& metrics) {
    ShadowAgreement worst;
    for (const auto& [light, shadow] : metrics.shadow)
        if (shadow.agreement && (!worst.agreement || *shadow.agreement < *worst.agreement)) worst = shadow;
    return worst;
}

const std::vector<std::string> kMetricHeads{"IoU",    "±",      "miss", "extra", "RMSE rel", "p99 rel",
                                            "bad 5%", "shadow", "±",    "BER",   "normal"};

std::vector<std::string> metricCells(const MetricSet& metrics) {
    const SilhouetteIou& silhouette = metrics.silhouette;
    const ShadowAgreement shadow = worstShadow(metrics);
    return {shown(silhouette.iou, "{:.5f}"),
            shownReach(silhouette.iouRange, silhouette.iou, 5),
            std::to_string(silhouette.missingPx),
            std::to_string(silhouette.extraPx),
            shown(metrics.depth.relief.rmse, "{:.5f}"),
            shown(metrics.depth.relief.p99, "{:.5f}"),
            shown(metrics.depth.badpix5pct, "{:.4f}"),
            shown(shadow.agreement, "{:.4f}"),
            shownReach(shadow.agreementRange, shadow.agreement, 4),
            shown(shadow.ber, "{:.4f}"),
            shown(metrics.normal.meanDegrees, "{:.2f}")};
}

/// `cells` between a first and the last ones.
std::vector<std::string> joined(const std::string& first, std::vector<std::string> cells,
                                const std::vector<std::string>& last) {
    cells.insert(cells.begin(), first);
    cells.insert(cells.end(), last.begin(), last.end());
    return cells;
}

/// "2/2", or "1/2 FAILED".
std::string reached(const std::vector<RequirementResult>& requirements) {
    const auto passed = static_cast<size_t>(std::count_if(
        requirements.begin(), requirements.end(), [](const RequirementResult& each) { return each.passed; }));
    return fmt::format("{}/{}{}", passed, requirements.size(), passed < requirements.size() ? " FAILED" : "");
}

std::string proxyTable(const Results& results) {
    TextTable table(joined("against the proxy", kMetricHeads, {}));
    table.add(joined("(base gap)", metricCells(results.proxy->gap.pooled), {}));
    for (const TechniqueOutcome& technique : results.techniques)
        if (technique.againstProxy)
            table.add(joined(technique.name, metricCells(technique.againstProxy->pooled), {}));
    return table.text();
}

} // namespace

std::string toTable(const Results& results) {
    const bool required =
        std::any_of(results.techniques.begin(), results.techniques.end(),
                    [](const TechniqueOutcome& each) { return !each.requirements.empty(); });
    std::vector<std::string> costHeads{"fetches", "ms"};
    if (required) costHeads.push_back("require");
    TextTable table(joined("technique", kMetricHeads, costHeads));
    std::string errors;
    for (const TechniqueOutcome& technique : results.techniques) {
        if (technique.error) {
            errors += fmt::format("{}: failed: {}\n", technique.name, *technique.error);
            continue;
        }
        const MetricSet& pooled = technique.comparison.pooled;
        std::vector<std::string> costCells{shown(pooled.cost.mean, "{:.1f}"),
                                           shown(technique.msMedian, "{:.1f}")};
        if (required) costCells.push_back(reached(technique.requirements));
        table.add(joined(technique.name, metricCells(pooled), costCells));
    }
    std::string text = table.text() + errors;
    if (results.proxy)
        text += "\nTechniques held against the reference on the proxy. (base gap): that reference held "
                "against the one "
                "above, on the limit surface.\n" +
                proxyTable(results);
    return text;
}

} // namespace plumbline
