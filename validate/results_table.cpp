#include "results.h"

#include <fmt/format.h>

namespace plumbline {
namespace {

struct Column {
    std::string head;
    std::vector<std::string> cells;
};

std::string shown(const Figure& figure, const char* format) {
    return figure ? fmt::format(fmt::runtime(format), *figure) : std::string("-");
}

} // namespace

std::string toTable(const Results& results) {
    std::vector<Column> columns{{"technique", {}},  {"IoU", {}},         {"missing", {}},
                                {"extra", {}},      {"RMSE/relief", {}}, {"p99/relief", {}},
                                {"bad 5%", {}},     {"shadow agr.", {}}, {"BER", {}},
                                {"normal deg", {}}, {"look-ups", {}},    {"ms", {}}};
    std::string errors;
    for (const TechniqueOutcome& technique : results.techniques) {
        if (technique.error) {
            errors += fmt::format("{}: failed: {}\n", technique.name, *technique.error);
            continue;
        }
        const MetricSet& pooled = technique.comparison.pooled;
        // The light with the worst agreement stands for all; results.csv has each.
        ShadowAgreement shadow;
        for (const auto& [light, agreement] : pooled.shadow)
            if (agreement.agreement && (!shadow.agreement || *agreement.agreement < *shadow.agreement))
                shadow = agreement;
        const std::vector<std::string> cells{technique.name,
                                             shown(pooled.silhouette.iou, "{:.5f}"),
                                             std::to_string(pooled.silhouette.missingPx),
                                             std::to_string(pooled.silhouette.extraPx),
                                             shown(pooled.depth.relief.rmse, "{:.5f}"),
                                             shown(pooled.depth.relief.p99, "{:.5f}"),
                                             shown(pooled.depth.badpix5pct, "{:.4f}"),
                                             shown(shadow.agreement, "{:.4f}"),
                                             shown(shadow.ber, "{:.4f}"),
                                             shown(pooled.normal.meanDegrees, "{:.2f}"),
                                             shown(pooled.cost.mean, "{:.1f}"),
                                             shown(technique.msMedian, "{:.1f}")};
        for (size_t i = 0; i < columns.size(); ++i)
            columns[i].cells.push_back(cells[i]);
    }
    std::string table;
    const size_t rows = columns[0].cells.size();
    for (size_t row = 0; row <= rows; ++row) {
        for (size_t i = 0; i < columns.size(); ++i) {
            const Column& column = columns[i];
            size_t width = column.head.size();
            for (const std::string& cell : column.cells)
                width = std::max(width, cell.size());
            const std::string& text = row == 0 ? column.head : column.cells[row - 1];
            table += i == 0 ? fmt::format("{:<{}}", text, width) : fmt::format("  {:>{}}", text, width);
        }
        table += "\n";
    }
    return table + errors;
}

} // namespace plumbline
