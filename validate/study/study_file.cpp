#include "scenes/core/data_folder.h"
#include "scenes/core/error.h"
#include "scenes/core/read_file.h"
#include "scenes/scene_file/scene_library.h"
#include "scenes/toml/toml_table.h"
#include "validate/study/study.h"
#include "validate/study/study_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace plumbline {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kStatistics{"median", "mean", "min", "max", "count"};
/// What rows can be grouped by, in addition to the axes.
const std::vector<std::string> kColumns{"scene", "technique"};

class StudyReader {
  public:
    explicit StudyReader(fs::path file) : file_(std::move(file)), root_(TomlTable::readFile(file_)) {}

    Study read() {
        study_.name = file_.stem().string();
        study_.title = root_.line("title");
        study_.purpose = root_.line("purpose");
        study_.memory = root_.text("memory", "1G");
        study_.errorPx = root_.text("error_px", "");
        study_.timeLimitSeconds = root_.integer("time_limit_seconds", 1, 86400, 60);
        for (const TomlTable& table : root_.tables("grid"))
            readGrid(table);
        if (study_.grids.empty()) root_.fail("grid", "is missing", "at least one [[grid]]");
        for (const TomlTable& table : root_.tables("table"))
            readTable(table);
        for (const TomlTable& table : root_.tables("plot"))
            readPlot(table);
        root_.finish();
        return std::move(study_);
    }

  private:
    void readGrid(const TomlTable& table) {
        StudyGrid grid;
        grid.name = table.name(gridNames_);
        grid.scenes = table.distinctTexts("scenes");
        if (grid.scenes.empty()) table.fail("scenes", "is empty", "at least one");
        for (const std::string& scene : grid.scenes)
            grid.sceneFiles.push_back(findSceneOf(table, scene));
        grid.sceneChanges = table.texts("scene_set", std::vector<std::string>{});
        grid.settings = table.texts("set", std::vector<std::string>{});
        grid.timingBudgetMs = table.number("timing_budget_ms", 0, 1e6, 0.0);
        std::set<std::string> axisNames(kColumns.begin(), kColumns.end());
        for (const TomlTable& axis : table.tables("axis"))
            addAxis(grid, axis, axis.name(axisNames));
        std::set<std::string> labels;
        for (const TomlTable& technique : table.tables("technique")) {
            StudyTechnique entry{technique.line("label"), technique.text("name")};
            if (entry.label == kAgainstReference || !labels.insert(entry.label).second)
                technique.fail("label", fmt::format("is \"{}\"", entry.label), "a unique text");
            technique.finish();
            grid.techniques.push_back(entry);
        }
        if (grid.techniques.empty()) table.fail("technique", "is missing", "at least one [[grid.technique]]");
        for (const TomlTable& pair : table.tables("pair")) {
            const std::vector<std::string> known(labels.begin(), labels.end());
            const StudyPair entry{pair.choice("first", known), pair.choice("second", known)};
            if (entry.first == entry.second) pair.fail("second", "is the same as first", "another technique");
            pair.finish();
            grid.pairs.push_back(entry);
        }
        table.finish();
        study_.grids.push_back(std::move(grid));
    }

    static void addAxis(StudyGrid& grid, const TomlTable& table, const std::string& name) {
        StudyAxis axis = readStudyAxis(table, name);
        const char* key = table.has("field") ? "field" : "fields";
        std::set<std::string> taken;
        for (const StudyAxis& other : grid.axes)
            taken.insert(other.fields.begin(), other.fields.end());
        for (const std::string& field : axis.fields)
            if (!taken.insert(field).second)
                table.fail(key, fmt::format("\"{}\" is set by two axes", field),
                           "each field on one axis only");
        grid.axes.push_back(std::move(axis));
    }

    /// In the folder of the study, otherwise in the library.
    fs::path findSceneOf(const TomlTable& table, const std::string& scene) const {
        fs::path beside = file_.parent_path() / scene;
        std::error_code error;
        if (fs::is_regular_file(beside, error)) return beside;
        try {
            return findScene(scene);
        } catch (const InputError& problem) {
            table.fail("scenes", problem.what());
        }
    }

    const StudyGrid& readGridName(const TomlTable& table) const {
        const std::vector<std::string> names(gridNames_.begin(), gridNames_.end());
        return gridNamed(study_, table.choice("grid", names, study_.grids.front().name));
    }

    /// Names by which the rows of a grid can be grouped.
    static std::vector<std::string> groupings(const StudyGrid& grid) {
        std::vector<std::string> names = kColumns;
        for (const StudyAxis& axis : grid.axes)
            names.push_back(axis.name);
        return names;
    }

    StudyRows readRows(const TomlTable& table, const StudyGrid& grid) const {
        StudyRows rows;
        rows.grid = grid.name;
        std::vector<std::string> against{kAgainstReference};
        for (const StudyPair& pair : grid.pairs)
            against.push_back(pair.first);
        rows.against = table.choice("against", against, kAgainstReference);
        rows.figure = table.text("figure");
        rows.statistic = table.choice("statistic", kStatistics, "median");
        if (!table.has("where")) return rows;
        const TomlTable where = table.table("where");
        for (const std::string& key : where.keys()) {
            const std::vector<std::string> names = groupings(grid);
            if (std::find(names.begin(), names.end(), key) == names.end())
                where.fail(key, "is not an axis of the grid", listOf(names), didYouMean(key, names));
            rows.where[key] = readStudyValues(where, key, key == "scene" || key == "technique");
            const std::vector<std::string> known = groupValues(grid, key);
            for (const std::string& value : rows.where[key])
                if (std::find(known.begin(), known.end(), value) == known.end())
                    where.fail(key, fmt::format("{} is not one of its values", value), listOf(known),
                               didYouMean(value, known));
        }
        where.finish();
        return rows;
    }

    void readTable(const TomlTable& table) {
        const StudyGrid& grid = readGridName(table);
        StudyTable entry{table.line("title"), table.choice("rows", groupings(grid)),
                         table.choice("columns", groupings(grid)), readRows(table, grid)};
        if (entry.rows == entry.columns) table.fail("columns", "is the same as rows", "another grouping");
        table.finish();
        study_.tables.push_back(std::move(entry));
    }

    void readPlot(const TomlTable& table) {
        const StudyGrid& grid = readGridName(table);
        StudyPlot plot;
        plot.name = table.name(plotNames_);
        plot.title = table.line("title");
        plot.x = table.choice("x", groupings(grid));
        plot.lines = table.choice("lines", groupings(grid), "technique");
        if (table.has("panels")) plot.panels = table.choice("panels", groupings(grid));
        plot.logX = table.boolean("log_x", false);
        plot.logY = table.boolean("log_y", false);
        plot.data = readRows(table, grid);
        table.finish();
        study_.plots.push_back(std::move(plot));
    }

    fs::path file_;
    TomlTable root_;
    Study study_{};
    std::set<std::string> gridNames_, plotNames_;
};

} // namespace

std::vector<std::string> groupValues(const StudyGrid& grid, const std::string& grouping) {
    if (grouping == "scene") return grid.scenes;
    std::vector<std::string> values;
    if (grouping == "technique")
        for (const StudyTechnique& technique : grid.techniques)
            values.push_back(technique.label);
    for (const StudyAxis& axis : grid.axes)
        if (axis.name == grouping) values = axis.values;
    return values;
}

const StudyGrid& gridNamed(const Study& study, const std::string& name) {
    return *std::find_if(study.grids.begin(), study.grids.end(),
                         [&](const StudyGrid& grid) { return grid.name == name; });
}

Study readStudy(const fs::path& file) {
    return StudyReader(file).read();
}

fs::path findStudy(const std::string& nameOrPath) {
    std::error_code error;
    if (fs::is_regular_file(nameOrPath, error)) return nameOrPath;
    const fs::path path(nameOrPath);
    if (path.has_parent_path() || path.extension() == ".toml")
        requireInputFile(path, "a study file, or the name of one in validate/studies/");
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(dataFolder() / "validate" / "studies"))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    if (std::find(names.begin(), names.end(), nameOrPath) != names.end())
        return dataFolder() / "validate" / "studies" / (nameOrPath + ".toml");
    throw InputError("study", fmt::format("neither a file nor a study is called '{}'", nameOrPath),
                     "a study file or " + listOf(names), didYouMean(nameOrPath, names));
}

} // namespace plumbline
