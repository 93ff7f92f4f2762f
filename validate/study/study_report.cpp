#include "validate/study/study_report.h"

#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/core/program_name.h"
#include "scenes/core/replace_file.h"
#include "validate/report/page_template.h"
#include "validate/report/report_cells.h"
#include "validate/results/number_text.h"
#include "validate/results/output_files.h"
#include "validate/study/study_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace plumbline {
namespace {

namespace fs = std::filesystem;
using report::data, report::listOfTexts, report::setIfAny;

/// The texts of a table: head and rows. The first cell of each is the name of the group.
struct TableTexts {
    std::string title, note;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

/// Returns the result of `action`; prefixes an InputError with `context`.
template <class Action>
auto inContext(const std::string& context, const Action& action) {
    try {
        return action();
    } catch (const InputError& error) {
        throw InputError(context, error.what());
    }
}

std::string describeWhere(const StudyRows& choice) {
    std::string text = fmt::format("{} of {}", choice.statistic, choice.figure);
    if (choice.against != kAgainstReference) text += ", compared with " + choice.against;
    for (const auto& [key, values] : choice.where)
        text += fmt::format("; {} {}", key, fmt::join(values, ", "));
    return text;
}

TableTexts textsOf(const Study& study, const StudyTable& table, const std::vector<StudyRow>& rows) {
    const StudyGrid& grid = gridNamed(study, table.data.grid);
    const StudyCells cells = inContext("table '" + table.title + "'",
                                       [&] { return cellsOf(rows, table.data, table.rows, table.columns); });
    const auto used = [&](const std::string& grouping, auto part) {
        std::vector<std::string> values = groupValues(grid, grouping);
        std::erase_if(values, [&](const std::string& value) {
            return std::none_of(cells.values.begin(), cells.values.end(),
                                [&](const auto& cell) { return cell.first.*part == value; });
        });
        return values;
    };
    using Names = std::pair<std::string, std::string>;
    const std::vector<std::string> columns = used(table.columns, &Names::second);
    TableTexts texts{table.title, describeWhere(table.data), {table.rows + " \\ " + table.columns}, {}};
    texts.head.insert(texts.head.end(), columns.begin(), columns.end());
    for (const std::string& name : used(table.rows, &Names::first)) {
        std::vector<std::string> line{name};
        for (const std::string& column : columns) {
            const auto found = cells.values.find({name, column});
            line.push_back(found == cells.values.end() ? "–" : numberText("{:.4g}", found->second));
        }
        texts.rows.push_back(std::move(line));
    }
    return texts;
}

std::string markdownOf(const TableTexts& table) {
    const auto cell = [](const std::string& unsafe) {
        std::string text = printable(unsafe);
        for (size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
            text.insert(at, "\\");
        for (size_t at = 0; (at = text.find('<', at)) != std::string::npos; at += 4)
            text.replace(at, 1, "&lt;");
        return text;
    };
    const auto line = [&](const std::vector<std::string>& texts) {
        std::string result = "|";
        for (const std::string& text : texts)
            result += " " + cell(text) + " |";
        return result + "\n";
    };
    std::string text =
        fmt::format("### {}\n\n{}.\n\n", cell(table.title), cell(table.note)) + line(table.head) + "|";
    for (size_t i = 0; i < table.head.size(); ++i)
        text += i == 0 ? "---|" : "--:|";
    text += "\n";
    for (const auto& row : table.rows)
        text += line(row);
    return text + "\n";
}

data dataOf(const TableTexts& table) {
    data entry{data::type::object};
    entry.set("title", table.title);
    entry.set("note", table.note);
    entry.set("head", listOfTexts(table.head));
    data rows{data::type::list};
    for (const auto& row : table.rows) {
        data line{data::type::object};
        line.set("name", row.front());
        line.set("cells", listOfTexts({row.begin() + 1, row.end()}));
        rows << line;
    }
    entry.set("rows", rows);
    return entry;
}

/// Distinct errors, each with its number of occurrences.
std::vector<std::string> errorsOf(const std::vector<StudyRow>& rows) {
    std::map<std::string, size_t> counts;
    for (const StudyRow& row : rows)
        if (!row.error.empty()) ++counts[errorOf(row)];
    std::vector<std::string> texts;
    for (const auto& [error, count] : counts)
        texts.push_back(fmt::format("{} × {}", count, error));
    return texts;
}

} // namespace

void writeStudyReport(const Study& study, const std::vector<StudyRow>& rows, size_t cases, size_t missing,
                      const fs::path& folder) {
    if (!study.plots.empty()) requireGnuplot();
    requireWritableFolder(folder);
    data page{data::type::object};
    page.set("title", study.title);
    page.set("purpose", study.purpose);
    page.set("program", programName());
    page.set("cases", std::to_string(cases));
    setIfAny(page, "missing", missing > 0 ? std::to_string(missing) : "");
    page.set("errors", listOfTexts(errorsOf(rows)));

    data plots{data::type::list}, tables{data::type::list};
    for (const StudyPlot& plot : study.plots) {
        const std::string file = plot.name + ".svg";
        if (!inContext("plot '" + plot.name + "'",
                       [&] { return drawPlot(study, plot, rows, folder / file); }))
            continue;
        data entry{data::type::object};
        entry.set("title", plot.title);
        entry.set("note", describeWhere(plot.data));
        entry.set("file", file);
        plots << entry;
    }
    std::string markdown;
    for (const StudyTable& table : study.tables) {
        const TableTexts texts = textsOf(study, table, rows);
        if (texts.rows.empty()) continue;
        markdown += markdownOf(texts);
        tables << dataOf(texts);
    }
    page.set("plots", plots);
    page.set("tables", tables);
    replaceFile(folder / "tables.md", markdown);
    replaceFile(folder / "index.html", report::renderTemplate("study.mustache", page));
}

} // namespace plumbline
