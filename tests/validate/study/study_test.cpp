// Studies: the file, its cases, and the rows of results.
#include "scenes/core/data_folder.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"
#include "validate/study/study_plot.h"
#include "validate/study/study_report.h"

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <set>

namespace plumbline {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

const char* const kStudy = R"(title = "A <study>"
purpose = "For tests"

[[grid]]
name = "main"
scenes = ["small_torus"]
scene_set = ["camera.width=64"]
set = ["linear_steps=8"]
[[grid.axis]]
name = "depth"
field = "object.torus.relief.depth"
values = [0.02, 0.5]
[[grid.axis]]
name = "size"
fields = ["camera.height", "camera.width"]
range = [10, 1000]
steps = 3
spacing = "log"
[[grid.technique]]
label = "A"
name = "linear"
[[grid.technique]]
label = "B"
name = "linear_binary"
[[grid.pair]]
first = "A"
second = "B"

[[table]]
title = "T"
rows = "technique"
columns = "depth"
figure = "silhouette.iou"

[[plot]]
name = "p"
title = "P"
x = "depth"
panels = "size"
figure = "silhouette.iou"
where = { size = [10, 100] }
)";

class StudyFile : public testing::Test {
  protected:
    Study read(const std::string& text) {
        writeFile(folder_ / "mine.toml", text);
        return readStudy(folder_ / "mine.toml");
    }
    /// The message without the folder of the file.
    std::string messageFor(const std::string& from, const std::string& to) {
        std::string text = kStudy;
        const size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        const std::string message = inputErrorOf([&] { read(text); });
        const std::string prefix = folder_.path().string() + "/";
        return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
    }
    std::vector<StudyCase> cases(const Study& study, const std::string& techniques = "t") {
        return casesOf(study, [&](const StudyGrid&) { return techniques; });
    }

    TemporaryFolder folder_;
};

TEST_F(StudyFile, ValidStudy_IsRead) {
    const Study study = read(kStudy);
    EXPECT_EQ(study.name, "mine");
    ASSERT_EQ(study.grids.size(), 1u);
    const StudyGrid& grid = study.grids[0];
    EXPECT_EQ(grid.sceneFiles[0], dataFolder() / "scenes" / "library" / "small_torus.toml");
    EXPECT_THAT(grid.axes[0].values, ElementsAre("0.02", "0.5"));
    EXPECT_THAT(grid.axes[1].values, ElementsAre("10", "100", "1000")); // equidistant logarithms
    EXPECT_THAT(grid.axes[1].fields, ElementsAre("camera.height", "camera.width"));
    EXPECT_EQ(study.tables[0].data.grid, "main");
    EXPECT_EQ(study.plots[0].lines, "technique");
    EXPECT_EQ(caseCount(study), 6u);
}

TEST_F(StudyFile, Mistakes_NameTheirLine) {
    EXPECT_EQ(messageFor("scene_set", "scenes_set"), "mine.toml:7: grid.scenes_set: unknown field; expected "
                                                     "axis, name, pair, scene_set, scenes, set, technique or "
                                                     "timing_budget_ms; did you mean 'scene_set'?");
    EXPECT_EQ(messageFor("[0.02, 0.5]", "[]"),
              "mine.toml:12: grid.axis.values: is empty; expected at least one value");
    EXPECT_EQ(messageFor("[0.02, 0.5]", "[0.5, 0.5]"),
              "mine.toml:12: grid.axis.values: 0.5 occurs twice; expected each once");
    EXPECT_EQ(messageFor("[10, 1000]", "[10, 10]"),
              "mine.toml:16: grid.axis.range: [10, 10] is empty; expected [lowest, highest]");
    EXPECT_EQ(messageFor("[10, 1000]", "[0, 10]"),
              "mine.toml:16: grid.axis.range: begins at 0; expected above 0 with spacing \"log\"");
    EXPECT_EQ(messageFor("steps = 3", "steps = 1"),
              "mine.toml:17: grid.axis.steps: is 1; expected at least 2, for both ends of the range");
    EXPECT_EQ(messageFor("range = [10, 1000]\n", ""), "mine.toml:13: grid.axis: has no values; expected "
                                                      "values = […], or range = [lowest, highest] and steps");
    EXPECT_EQ(messageFor("name = \"size\"", "name = \"depth\""),
              "mine.toml:14: grid.axis.name: \"depth\" is taken already; expected another one");
    EXPECT_EQ(messageFor("name = \"size\"", "name = \"scene\""),
              "mine.toml:14: grid.axis.name: \"scene\" is taken already; expected another one");
    EXPECT_EQ(messageFor("label = \"B\"", "label = \"A\""),
              "mine.toml:23: grid.technique.label: is \"A\"; expected a unique text");
    EXPECT_EQ(messageFor("first = \"A\"", "first = \"C\""),
              "mine.toml:26: grid.pair.first: is the string \"C\"; expected A or B");
    EXPECT_EQ(
        messageFor("columns = \"depth\"", "columns = \"deep\""),
        "mine.toml:32: table.columns: is the string \"deep\"; expected scene, technique, depth or size");
    EXPECT_EQ(messageFor("size = [10, 100]", "size = 11"),
              "mine.toml:41: plot.where.size: 11 is not one of its values; expected 10, 100 or 1000; did you "
              "mean '10'?");
    EXPECT_EQ(
        messageFor("size = [10, 100]", "sise = 10"),
        "mine.toml:41: plot.where.sise: is not an axis of the grid; expected scene, technique, depth or "
        "size; did you mean 'size'?");
    EXPECT_THAT(messageFor("small_torus", "small_tours"), HasSubstr("did you mean 'small_torus'?"));
}

/// The outcome of a case: IoU `a` for A, `b` for B, PSNR 30 between them.
json outcome(double a, double b) {
    const auto result = [](double iou) {
        return json{{"name", "x"},
                    {"silhouette", {{"iou", iou}}},
                    {"image", {{"psnr_db", 30}}},
                    {"objects", {{{"iou", 7}}}},
                    {"error", nullptr}};
    };
    return {
        {"error", nullptr},
        {"reference", {{"error_px_p99", 0.25}, {"objects", json::array()}}},
        {"techniques",
         {{{"name", "linear"}, {"result", result(a)}}, {{"name", "linear_binary"}, {"result", result(b)}}}},
        {"pairs", {{{"first", "linear"}, {"second", "linear_binary"}, {"result", result(0.5)}}}}};
}

/// Cases in order get IoU 1/8, 2/8, … for A and 1/16 more for B.
std::vector<StudyRow> sampleRows(const std::vector<StudyCase>& cases) {
    std::vector<StudyRow> rows;
    for (size_t i = 0; i < cases.size(); ++i)
        for (StudyRow& row : rowsOf(cases[i], outcome(0.125 * static_cast<double>(i + 1),
                                                      0.125 * static_cast<double>(i + 1) + 0.0625)))
            rows.push_back(row);
    return rows;
}

TEST_F(StudyFile, MisleadingStudy_IsRefused) {
    EXPECT_EQ(messageFor("label = \"A\"", "label = \"reference\""),
              "mine.toml:20: grid.technique.label: is \"reference\"; expected a unique text");
    EXPECT_EQ(messageFor("label = \"A\"", "label = \"A\\n\""),
              "mine.toml:20: grid.technique.label: has a control character; expected a single-line string");
    EXPECT_EQ(messageFor("second = \"B\"", "second = \"A\""),
              "mine.toml:27: grid.pair.second: is the same as first; expected another technique");
    EXPECT_EQ(messageFor("rows = \"technique\"", "rows = \"depth\""),
              "mine.toml:32: table.columns: is the same as rows; expected another grouping");
    EXPECT_EQ(
        messageFor("\"camera.height\", \"camera.width\"", "\"camera.height\", \"object.torus.relief.depth\""),
        "mine.toml:15: grid.axis.fields: \"object.torus.relief.depth\" is set by two axes; expected each "
        "field on one axis only");
    EXPECT_EQ(messageFor("\"camera.height\"", "\"camera.height=5 #\""),
              "mine.toml:15: grid.axis.fields: has \"camera.height=5 #\"; expected keys of the scene "
              "separated by dots, for example camera.width");
}

TEST_F(StudyFile, PlotTexts_AreEscaped) {
    std::string text = kStudy;
    text.replace(text.find("title = \"P\""), 11, "title = \"it's `date` $(x) \\\\ {/Bold b} @a\"");
    const Study study = read(text);
    EXPECT_THAT(gnuplotScript(study, study.plots[0], sampleRows(cases(study))),
                HasSubstr("'it''s `date` $(x) \\ {/Bold b} @a' at screen"));
}

TEST_F(StudyFile, CaseKey_FollowsInputs) {
    const Study study = read(kStudy);
    const std::vector<StudyCase> all = cases(study);
    std::set<std::string> ids;
    for (const StudyCase& each : all)
        ids.insert(each.id);
    EXPECT_EQ(ids.size(), 6u);
    // The last axis changes fastest.
    EXPECT_EQ(all[1].values, (std::map<std::string, std::string>{{"depth", "0.02"}, {"size", "100"}}));
    EXPECT_THAT(all[1].changes, ElementsAre("camera.width=64", "object.torus.relief.depth=0.02",
                                            "camera.height=100", "camera.width=100"));
    // An extended study reuses its cases; other techniques or another scene give other cases.
    std::string grown = kStudy;
    grown.replace(grown.find("[0.02, 0.5]"), 11, "[0.02, 0.1, 0.5]");
    const Study larger = read(grown);
    size_t known = 0;
    for (const StudyCase& each : cases(larger))
        known += ids.contains(each.id);
    EXPECT_EQ(known, 6u);
    for (const StudyCase& each : cases(study, "others"))
        EXPECT_FALSE(ids.contains(each.id));
    Study patient = study;
    patient.timeLimitSeconds = 61;
    for (const StudyCase& each : cases(patient))
        EXPECT_FALSE(ids.contains(each.id));
    std::string wider = kStudy;
    wider.replace(wider.find("camera.width=64"), 15, "camera.width=65");
    for (const StudyCase& each : cases(read(wider)))
        EXPECT_FALSE(ids.contains(each.id));
}

TEST_F(StudyFile, FilesInValues_CountByContent) {
    writeFile(
        folder_ / "scene.toml",
        "purpose = \"x\"\n[camera]\nposition = [0, 0, 3]\n[[object]]\nname = \"torus\"\nmesh = \"a.obj\"\n");
    writeFile(folder_ / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::string text = kStudy;
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"\"small_torus\"", "\"scene.toml\""},
          {"scene_set = [\"camera.width=64\"]", "scene_set = [\"object.torus.mesh='b.obj'\"]"}})
        text.replace(text.find(from), from.size(), to);
    const Study study = read(text);
    writeFile(folder_ / "b.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    const std::string before = cases(study)[0].id;
    EXPECT_EQ(cases(study)[0].id, before);
    writeFile(folder_ / "b.obj", "v 0 0 0\nv 1 0 0\nv 0 3 0\nf 1 2 3\n");
    EXPECT_NE(cases(study)[0].id, before);
}

TEST_F(StudyFile, OverflowingCaseCount_Saturates) {
    Study study = read(kStudy);
    const StudyAxis wide{"a", {"camera.width"}, std::vector<std::string>(1000000, "1")};
    study.grids[0].axes = {wide, wide, wide};
    EXPECT_EQ(caseCount(study), 1000000000000000000u);
    study.grids[0].axes.push_back(wide);
    EXPECT_EQ(caseCount(study), std::numeric_limits<uint64_t>::max());
    study.grids.push_back(study.grids[0]);
    EXPECT_EQ(caseCount(study), std::numeric_limits<uint64_t>::max());
}

TEST_F(StudyFile, Rows_ContainEveryFigure) {
    const Study study = read(kStudy);
    const std::vector<StudyRow> rows = rowsOf(cases(study)[0], outcome(0.9, 0.8));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].technique, "A");
    EXPECT_EQ(rows[1].technique, "B");
    EXPECT_EQ(rows[1].figures.at("silhouette.iou"), 0.8);
    EXPECT_EQ(rows[1].figures.at("reference.error_px_p99"), 0.25);
    EXPECT_FALSE(rows[1].figures.contains("objects.iou"));
    EXPECT_EQ(rows[2].technique, "B");
    EXPECT_EQ(rows[2].against, "A");
    const std::string csv = studyCsv(rows);
    EXPECT_THAT(csv, HasSubstr("case,grid,scene,depth,size,technique,against,image.psnr_db,reference.error_"
                               "px_p99,silhouette.iou,error\r\n"));
    EXPECT_THAT(csv, HasSubstr(",main,small_torus,0.02,10,B,A,30,0.25,0.5,\r\n"));
}

TEST_F(StudyFile, FailedCase_IsRowWithError) {
    const Study study = read(kStudy);
    const std::vector<StudyRow> rows = rowsOf(cases(study)[0], {{"error", "no, \"really\""}});
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_THAT(studyCsv(rows), HasSubstr("small_torus,0.02,10,,,\"no, \"\"really\"\"\"\r\n"));
    StudyRows choice;
    choice.grid = "main";
    EXPECT_FALSE(isChosen(rows[0], choice));
}

TEST_F(StudyFile, Cells_AreStatisticsOfGroup) {
    const Study study = read(kStudy);
    const std::vector<StudyRow> rows = sampleRows(cases(study));
    StudyRows choice{"main", "reference", {}, "silhouette.iou", "median"};
    const auto cell = [&](const std::string& technique, const std::string& depth) {
        return cellsOf(rows, choice, "technique", "depth").values.at({technique, depth});
    };
    EXPECT_EQ(cell("A", "0.02"), 0.25);  // median of 1/8 2/8 3/8
    EXPECT_EQ(cell("B", "0.5"), 0.6875); // median of 4/8 5/8 6/8, plus 1/16
    choice.statistic = "max";
    EXPECT_EQ(cell("A", "0.02"), 0.375);
    choice.statistic = "mean";
    EXPECT_EQ(cell("A", "0.5"), 0.625);
    choice.statistic = "median";
    choice.where["size"] = {"10", "100"};
    EXPECT_EQ(cell("A", "0.02"), 0.1875); // an even number of values: the mean of the middle two
    choice.against = "A";
    EXPECT_EQ(cell("B", "0.5"), 0.5);
    choice.figure = "silhouette.ion";
    EXPECT_EQ(inputErrorOf([&] { cellsOf(rows, choice, "technique", "depth"); }),
              "figure: no result has 'silhouette.ion'; expected a column of results.csv; did you mean "
              "'silhouette.iou'?");
}

TEST_F(StudyFile, Plots_HavePanelAndLinePerGroup) {
    const Study study = read(kStudy);
    const std::string script = gnuplotScript(study, study.plots[0], sampleRows(cases(study)));
    EXPECT_THAT(script, HasSubstr("$p0l0 << EOD\n0.02 0.125\n0.5 0.5\nEOD\n"));     // size 10, A
    EXPECT_THAT(script, HasSubstr("$p1l1 << EOD\n0.02 0.3125\n0.5 0.6875\nEOD\n")); // size 100, B
    EXPECT_THAT(script, HasSubstr("set title 'size 100'"));
    EXPECT_EQ(script.find("p2l"), std::string::npos); // size 1000 isn't selected
    EXPECT_EQ(gnuplotScript(study, study.plots[0], {}), "");
}

TEST_F(StudyFile, PlotOfUnknownFigure_IsRefused) {
    Study study = read(kStudy);
    study.plots[0].data.figure = "silhouette.ion";
    EXPECT_THAT(inputErrorOf([&] { gnuplotScript(study, study.plots[0], sampleRows(cases(study))); }),
                HasSubstr("did you mean 'silhouette.iou'?"));
}

TEST_F(StudyFile, FailedPair_IsReported) {
    const Study study = read(kStudy);
    json failed = outcome(0.9, 0.8);
    failed["pairs"][0]["result"] = {{"error", "no frame"}};
    const std::vector<StudyRow> rows = rowsOf(cases(study)[0], failed);
    EXPECT_EQ(rows[2].error, "no frame");
    EXPECT_EQ(rows[1].error, "");
}

TEST_F(StudyFile, ReportText_IsEscaped) {
    const Study study = read(kStudy);
    if (std::system("gnuplot --version >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "gnuplot isn't installed (package gnuplot-nox)";
    std::vector<StudyRow> rows = sampleRows(cases(study));
    rows.push_back(rowsOf(cases(study)[0], {{"error", "<script>"}})[0]);
    writeStudyReport(study, rows, 7, 2, folder_ / "report");
    const std::string page = readFile(folder_ / "report/index.html");
    EXPECT_THAT(page, HasSubstr("A &lt;study&gt;"));
    EXPECT_THAT(page, HasSubstr("1 × &lt;script&gt;"));
    EXPECT_THAT(page, HasSubstr("2 cases have no results yet"));
    EXPECT_THAT(page, HasSubstr("<th scope=\"row\">B</th><td>0.3125</td><td>0.6875</td>"));
    EXPECT_THAT(readFile(folder_ / "report/tables.md"),
                HasSubstr("| technique \\ depth | 0.02 | 0.5 |\n|---|--:|--:|\n| A | 0.25 | 0.625 |\n"));
    EXPECT_THAT(readFile(folder_ / "report/p.svg"), HasSubstr("</svg>"));
}

TEST_F(StudyFile, FolderOfOtherStudy_IsRefused) {
    const Study study = read(kStudy);
    const std::vector<StudyCase> all = cases(study);
    const StudyFolder folder(folder_ / "out", study);
    EXPECT_FALSE(folder.outcomeOf(all[0]));
    folder.store(all[0], outcome(0.5, 0.5));
    folder.store(all[1], {{"error", "gone soon"}, {"again", true}});
    folder.store(all[2], {{"error", "wrong"}});
    writeFile(folder_ / "out" / "cases" / (all[3].id + ".json"), "{\"error\": nul"); // a truncated file
    EXPECT_TRUE(folder.outcomeOf(all[0]));
    EXPECT_FALSE(folder.outcomeOf(all[1]));
    EXPECT_TRUE(folder.outcomeOf(all[2]));
    for (const char* damaged :
         {"{\"error\": nul", "", "[]", "{\"error\": 3}", "{\"error\": null}",
          "{\"error\": null, \"techniques\": [3], \"pairs\": []}",
          "{\"error\": null, \"techniques\": [{\"name\": \"q\", \"result\": null}], \"pairs\": []}"}) {
        writeFile(folder_ / "out" / "cases" / (all[3].id + ".json"), damaged);
        EXPECT_FALSE(folder.outcomeOf(all[3])) << damaged;
    }

    Study other = study;
    other.name = "another";
    const std::string where = (folder_ / "out").string();
    EXPECT_EQ(inputErrorOf([&] { StudyFolder(folder_ / "out", other); }),
              where +
                  ": contains the results of study 'mine'; expected those of 'another', or an empty folder; "
                  "choose another with -o");
    EXPECT_EQ(inputErrorOf([&] { StudyFolder(folder_.path(), study); }),
              folder_.path().string() +
                  ": contains files that don't belong to a study; expected an empty folder, or a new one");
    EXPECT_THAT(inputErrorOf([&] { StudyFolder::open(folder_ / "none", study); }),
                HasSubstr("contains no results of a study"));
}

} // namespace
} // namespace plumbline
