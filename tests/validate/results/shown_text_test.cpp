// Figures, names and file names as results show them.
#include "scenes/frame/frame.h"
#include "tests/temporary_folder.h"
#include "tests/validate/results/sample_results.h"
#include "validate/report/report.h"
#include "validate/report/report_page.h"
#include "validate/results/csv_text.h"
#include "validate/results/number_text.h"
#include "validate/results/text_table.h"
#include "validate/results/unique_file_names.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(NumberText, NumberThatRoundsToZero_HasNoMinus) {
    EXPECT_EQ(numberText("{:.4f}", -0.0), "0.0000");
    EXPECT_EQ(numberText("{:.4f}", -0.00004), "0.0000");
    EXPECT_EQ(numberText("{:.4f}", -0.00006), "-0.0001");
    EXPECT_EQ(numberText("{:+.4f}", -0.00001), "+0.0000");
    EXPECT_EQ(numberText("{:.0f}", -0.4), "0");
    EXPECT_EQ(numberText("{:.4g}", -0.0), "0");
    EXPECT_EQ(numberText("{:.4g}", -1e-300), "-1e-300");
    EXPECT_EQ(numberText("{:.2f}", -10.0), "-10.00");
}

/// Results whose figures are all -0, or round to it.
Results negativeZeros(double value) {
    Results results = sampleResults();
    for (const MetricInfo& metric : metricTable())
        results.techniques[0].comparison.pooled.set(
            metric, metric.scope == Scope::ObjectsByLight ? "sun" : "", value);
    return results;
}

TEST(ResultsTable, NoFigure_IsMinusZero) {
    const Results zeros = negativeZeros(-0.0), tiny = negativeZeros(-1e-12);
    for (const Results& results : {zeros, tiny}) {
        EXPECT_THAT(toTable(results), Not(HasSubstr("-0.0")));
        EXPECT_THAT(toTable(results), Not(HasSubstr(" -0 ")));
        EXPECT_THAT(reportPage(results, {}, {}), Not(HasSubstr("-0.00")));
    }
    EXPECT_THAT(toCsv(zeros), Not(HasSubstr(",-0,")));
    EXPECT_THAT(toJson(zeros), Not(HasSubstr("-0.0")));
    // An image without uncertain pixels: the interval is the figure.
    const Frame reference = sampleReference();
    Frame certain = reference;
    for (const char* channel : {"uncertain", "uncertain.shadow.sun"})
        std::ranges::fill(certain.channel(channel), 0.0f);
    Results results = sampleResults();
    results.techniques[0].comparison = compareFrames(certain, shiftedRight(reference), {}, std::nullopt);
    EXPECT_THAT(toTable(results), Not(HasSubstr("-0.0")));
}

bool actsOnTerminal(const std::string& text, const char* allowed) {
    return std::ranges::any_of(text,
                               [&](unsigned char c) {
                                   return (c < 0x20 && std::string_view(allowed).find(char(c)) ==
                                                           std::string_view::npos) ||
                                          c == 0x7f;
                               }) ||
           text.find("\u009b") != std::string::npos || text.find("\u202e") != std::string::npos;
}

TEST(Names, ActingCharacters_ReachNoOutput) {
    const std::string hostile = "a\x1b]0;x\x07\n|b\u009b1m\u202e\x7f";
    Results results = sampleResults(hostile);
    results.scene.name = hostile;
    results.techniques[0].comparison.objects[0].object.name = hostile;
    results.techniques[1].name = hostile;
    results.techniques[1].error = hostile;
    copyLight(results.techniques[0].comparison.pooled, "sun", hostile);
    const std::string table = toTable(results), csv = toCsv(results), json = toJson(results);
    EXPECT_FALSE(actsOnTerminal(table, "\n")) << table;
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'),
              std::ranges::count(toTable(sampleResults()), '\n'));
    EXPECT_FALSE(actsOnTerminal(csv, "\r\n")) << csv;
    EXPECT_FALSE(actsOnTerminal(json, "\n")) << json;
    EXPECT_EQ(nlohmann::json::parse(json)["scene"]["name"], hostile); // JSON keeps it, escaped
    EXPECT_EQ(csvCell("a\nb,c"), "\"a b,c\"");
    const std::string page = reportPage(results, {}, {});
    EXPECT_THAT(page, Not(HasSubstr("\x1b")));
    EXPECT_THAT(page, Not(HasSubstr("\u202e")));
}

TEST(UniqueFileNames, EqualNamesInAnyCase_GetNumbers) {
    UniqueFileNames names;
    EXPECT_EQ(names.add("a_b"), "a_b");
    EXPECT_EQ(names.add("a_b"), "a_b_2");
    EXPECT_EQ(names.add("A_B"), "A_B_3");
    EXPECT_EQ(names.add("a_b_2"), "a_b_2_2");
    EXPECT_EQ(names.add("c"), "c");
}

TEST(ReportFiles, LightsOfLikeNames_HaveOwnPictures) {
    const TemporaryFolder folder;
    Frame reference = sampleReference();
    const std::string longName(120, 'x');
    for (const std::string& light :
         {std::string("a b"), std::string("a_b"), std::string("A_b"), longName + "1", longName + "2"})
        std::ranges::copy(reference.channel("shadow.sun"), reference.add(shadowChannel(light)).begin());
    TechniqueOutcome technique;
    technique.name = "mine";
    technique.comparison = compareFrames(reference, reference, {}, std::nullopt);
    Report report(folder.path(), {.interactive = false, .singleFile = false});
    report.addTechnique(technique, reference, reference);
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        std::string name = entry.path().filename().string();
        std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
        if (name.find("_shadow_") != std::string::npos) names.insert(name);
    }
    EXPECT_EQ(names.size(), 6u); // with the sun's
}

} // namespace
} // namespace plumbline
