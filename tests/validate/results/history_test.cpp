// The history of a shader: records are written and read, and regressions are found.
#include "tests/errors.h"
#include "tests/validate/results/sample_results.h"
#include "validate/results/history_moves.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

HistoryRecord record(const std::string& label, std::map<std::string, double> figures) {
    HistoryRecord result;
    result.label = label;
    result.program = "plumbline 0.1.0";
    result.scene = "torus";
    result.sceneHash = "abc";
    result.base = "limit";
    result.techniques = {{"mine", std::move(figures), ""}};
    return result;
}

HistoryRecord failing(const std::string& label) {
    HistoryRecord result = record(label, {});
    result.techniques[0].error = "mine.glsl:3: undeclared 'x'";
    return result;
}

SceneMoves movesOf(const std::vector<HistoryRecord>& records,
                   const std::vector<std::string>& tolerances = {}) {
    const std::vector<SceneMoves> scenes = latestMoves(records, {}, Tolerances::parse(tolerances));
    EXPECT_EQ(scenes.size(), 1u);
    return scenes.at(0);
}

/// The verdict on one figure that changes from `before` to `after`.
Verdict verdictOf(const std::string& figure, double before, double after,
                  const std::vector<std::string>& tolerances = {}) {
    const SceneMoves scene =
        movesOf({record("a", {{figure, before}}), record("b", {{figure, after}})}, tolerances);
    EXPECT_EQ(scene.moves.size(), 1u);
    EXPECT_EQ(scene.hasRegression(), scene.moves.at(0).verdict == Verdict::Regression);
    return scene.moves.at(0).verdict;
}

TEST(HistoryFile, PooledFigures_AreKept) {
    const HistoryRecord kept = recordOf("results.json", toJson(sampleResults()), std::nullopt);
    EXPECT_EQ(kept.label, "plumbline 0.1.0");
    EXPECT_EQ(kept.scene, "painted");
    EXPECT_EQ(kept.sceneHash, "abc123");
    EXPECT_EQ(kept.certificate.at("error_px_p99"), 0.031);
    ASSERT_EQ(kept.techniques.size(), 2u);
    const auto& figures = kept.techniques[0].figures;
    EXPECT_EQ(figures.at("silhouette.missing_px"),
              4); // the column that the shifted square leaves (painted_frames.h)
    EXPECT_TRUE(figures.contains("shadow.sun.agreement"));
    EXPECT_EQ(figures.at("cost.ms_median"), 12.5);
    EXPECT_FALSE(figures.contains("relief_depth"));
    EXPECT_EQ(kept.techniques[1].error, "broken.glsl:3: undeclared 'x'");
    EXPECT_THAT(kept.techniques[1].figures, IsEmpty());
    EXPECT_TRUE(recordOf("r", toJson(sampleResultsOnBothBases()), "v2")
                    .techniques[0]
                    .figures.contains("against_proxy.shadow.sun.iou"));
}

// A light may have the name of a part of the results that contains no figures.
TEST(HistoryFile, AnyLightName_IsKept) {
    Results results = sampleResults();
    for (const char* name : {"notes", "objects", "absent"})
        copyLight(results.techniques[0].comparison.pooled, "sun", name);
    const auto figures = recordOf("r", toJson(results), {}).techniques.at(0).figures;
    for (const char* name : {"notes", "objects", "absent"})
        EXPECT_EQ(figures.at(std::string("shadow.") + name + ".agreement"),
                  figures.at("shadow.sun.agreement"));
}

TEST(HistoryFile, Lines_RoundTrip) {
    HistoryRecord first = recordOf("r", toJson(sampleResults("<b>\"x\"</b>")), "caf\xc3\xa9");
    const HistoryRecord second =
        record("b", {{"depth.bias", -1.25e-7}, {"depth.max", 0.1 + 0.2}, {"x", 1e300}});
    const std::string text = toLine(first) + "\r\n\n" + toLine(second);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
    EXPECT_THAT(readHistory("h", text), ElementsAre(first, second));
    EXPECT_EQ(toLine(readHistory("h", text)[0]), toLine(first));
}

TEST(HistoryFile, DamagedLine_IsNamed) {
    const std::string good = toLine(record("a", {{"silhouette.iou", 1}}));
    const auto errorOf = [&](const std::string& line) {
        return inputErrorOf([&] { readHistory("h.jsonl", good + line); });
    };
    EXPECT_THAT(errorOf("<<<<<<< HEAD\n"), HasSubstr("h.jsonl:2: is not valid JSON; expected a line that"));
    EXPECT_THAT(errorOf(good.substr(0, good.size() / 2)), HasSubstr("h.jsonl:2: is not valid JSON"));
    EXPECT_THAT(errorOf("[]\n"), HasSubstr("is not a JSON object"));
    EXPECT_THAT(errorOf("{}\n"), HasSubstr("has no schema"));
    const auto changed = [&](const std::string& from, const std::string& to) {
        const size_t at = good.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return std::string(good).replace(at, from.size(), to);
    };
    EXPECT_THAT(errorOf(changed("\"schema\":1", "\"schema\":2")), HasSubstr("schema is 2; expected 1"));
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    EXPECT_THAT(errorOf(changed("\"schema\":1", "\"schema\":" + deep)),
                HasSubstr("h.jsonl:2: has values more than 100 deep within each other; expected a few"));
    std::string nested = "{\"a\":";
    for (int k = 0; k < 16; ++k)
        nested += nested;
    EXPECT_THAT(errorOf(nested), HasSubstr("more than 100 deep"));
    EXPECT_THAT(errorOf(changed("iou\":1", "iou\":NaN")), HasSubstr("is not valid JSON"));
    EXPECT_THAT(errorOf(changed("iou\":1", "iou\":1e999")), HasSubstr("is not valid JSON"));
    EXPECT_THAT(errorOf(changed("iou\":1", "iou\":\"1\"")), HasSubstr("silhouette.iou is not a number"));
    EXPECT_THAT(errorOf(changed("\"techniques\":[", "\"other\":[")), HasSubstr("has no techniques"));
    EXPECT_THAT(errorOf(changed("\"torus\"", "3")), HasSubstr("scene.name is not a text"));
    EXPECT_THAT(errorOf(std::string(50, '[')), HasSubstr("is not valid JSON"));
    EXPECT_THAT(errorOf(std::string(200000, '[')), HasSubstr("more than 100 deep"));
}

TEST(HistoryFile, NoResults_AreRefused) {
    const std::string good = toJson(sampleResults());
    const auto errorOf = [&](const std::string& text) {
        return inputErrorOf([&] { recordOf("r.json", text, std::nullopt); });
    };
    EXPECT_THAT(errorOf("{\"schema\": 7}"), HasSubstr("r.json: schema is 7; expected 1"));
    EXPECT_THAT(errorOf(good.substr(0, 300)), HasSubstr("r.json: is not valid JSON"));
    Results none = sampleResults();
    none.techniques.clear();
    EXPECT_THAT(errorOf(toJson(none)), HasSubstr("contains no technique"));
    Results twice = sampleResults();
    twice.techniques[1] = twice.techniques[0];
    EXPECT_THAT(errorOf(toJson(twice)), HasSubstr("contains 'linear_binary' twice"));
}

TEST(HistoryMoves, FartherFromBest_IsWorse) {
    EXPECT_EQ(verdictOf("silhouette.iou", 0.9, 0.89), Verdict::Regression);
    EXPECT_EQ(verdictOf("silhouette.iou", 0.89, 0.9), Verdict::Better);
    EXPECT_EQ(verdictOf("depth.rmse", 0.1, 0.2), Verdict::Regression);
    EXPECT_EQ(verdictOf("depth.bias", 0.1, -0.05), Verdict::Better); // nearer to 0
    EXPECT_EQ(verdictOf("depth.bias", 0.1, -0.2), Verdict::Regression);
    EXPECT_EQ(verdictOf("shadow.my.sun.agreement", 0.9, 0.8), Verdict::Regression);
    EXPECT_EQ(verdictOf("against_proxy.shadow.sun.ber", 0.1, 0.2), Verdict::Regression);
    EXPECT_EQ(verdictOf("depth.domain_px", 900, 100), Verdict::Neutral);
    EXPECT_EQ(verdictOf("silhouette.missing_px", 1, 2),
              Verdict::Neutral); // its IoU is evaluated, with an interval
    EXPECT_EQ(verdictOf("silhouette.missing_px", 1, 2, {"all=1%"}), Verdict::Neutral);
    EXPECT_EQ(verdictOf("silhouette.missing_px", 1, 2, {"silhouette.missing_px=0.5"}), Verdict::Regression);
    EXPECT_EQ(verdictOf("silhouette.hausdorff95_px", 1, 2), Verdict::Regression); // a distance, not a count
    EXPECT_EQ(verdictOf("of.another.version", 1, 2), Verdict::Neutral);
}

TEST(HistoryMoves, ChangeWithinInterval_IsTolerated) {
    const auto scene = [](double after) {
        return movesOf(
            {record("a",
                    {{"silhouette.iou", 0.9}, {"silhouette.iou_low", 0.88}, {"silhouette.iou_high", 0.91}}),
             record("b",
                    {{"silhouette.iou", after}, {"silhouette.iou_low", 0.5}, {"silhouette.iou_high", 1}})});
    };
    ASSERT_EQ(scene(0.885).moves.size(), 1u); // the ends of the interval aren't evaluated
    EXPECT_EQ(scene(0.885).moves[0].verdict, Verdict::Tolerated);
    EXPECT_EQ(scene(0.875).moves[0].verdict, Verdict::Regression);
    EXPECT_EQ(scene(0.92).moves[0].verdict, Verdict::Better);
}

TEST(HistoryMoves, Tolerance_CoversFigureAndItsCounts) {
    EXPECT_EQ(verdictOf("depth.rmse", 1, 1.25, {"depth.rmse=0.25"}), Verdict::Tolerated); // exact in binary
    EXPECT_EQ(verdictOf("depth.rmse", 1, 1.26, {"depth.rmse=0.25"}), Verdict::Regression);
    EXPECT_EQ(verdictOf("depth.rmse", 4, 4.9, {"depth.rmse=25%"}), Verdict::Tolerated);
    EXPECT_EQ(verdictOf("depth.rmse", 4, 5.1, {"depth.rmse=25%"}), Verdict::Regression);
    EXPECT_EQ(verdictOf("depth.mae", 1, 1.2, {"depth.rmse=0.25"}), Verdict::Regression);
    EXPECT_EQ(verdictOf("depth.mae", 1, 1.2, {"all=25%"}), Verdict::Tolerated);
    EXPECT_EQ(verdictOf("depth.mae", 1, 1.2, {"all=25%", "depth.mae=0"}), Verdict::Regression);
    EXPECT_EQ(verdictOf("shadow.sun.ber", 0.1, 0.2, {"shadow.ber=1"}), Verdict::Tolerated);
    EXPECT_EQ(verdictOf("shadow.sun.ber", 0.1, 0.2, {"shadow.ber=1", "shadow.sun.ber=0"}),
              Verdict::Regression);
}

TEST(HistoryMoves, Cost_IsEvaluatedOnlyIfNamed) {
    EXPECT_EQ(verdictOf("cost.ms_median", 1, 100), Verdict::Neutral);
    EXPECT_EQ(verdictOf("cost.ms_median", 1, 100, {"all=0"}), Verdict::Neutral);
    EXPECT_EQ(verdictOf("cost.ms_median", 1, 100, {"cost.ms_median=50%"}), Verdict::Regression);
    EXPECT_EQ(verdictOf("cost.ms_median", 10, 14, {"cost.ms_median=50%"}), Verdict::Tolerated);
    EXPECT_EQ(verdictOf("cost.fetches_mean", 10, 9, {"cost.fetches_mean=0"}), Verdict::Better);
}

TEST(HistoryMoves, MalformedTolerance_IsRefused) {
    for (const char* bad : {"", "depth.rmse", "depth.rmse=", "=1", "depth.rmse=-1", "depth.rmse=nan",
                            "depth.rmse=inf", "depth.rmse=1e999", "depth.rmse=1x", "depth.rmse=%",
                            "depth.domain_px=1", "silhouette.iou_low=1", "depth.rsme=1"})
        EXPECT_THAT(inputErrorOf([&] { Tolerances::parse({bad}); }), HasSubstr("--tolerance")) << bad;
    EXPECT_THAT(inputErrorOf([] { Tolerances::parse({"depth.rsme=1"}); }),
                HasSubstr("did you mean 'depth.rmse'?"));
    EXPECT_THAT(inputErrorOf([] { Tolerances::parse({"all=1", "all=2"}); }), HasSubstr("given twice"));
}

TEST(HistoryMoves, VanishedFigure_IsRegressionIfEvaluated) {
    const SceneMoves scene =
        movesOf({record("a", {{"depth.rmse", 1}, {"depth.domain_px", 5}, {"cost.ms_median", 3}}),
                 record("b", {{"st.mean_texels", 1}})});
    std::map<std::string, Verdict> verdicts;
    for (const FigureMove& move : scene.moves)
        verdicts[move.figure] = move.verdict;
    EXPECT_EQ(verdicts, (std::map<std::string, Verdict>{{"depth.rmse", Verdict::Regression},
                                                        {"depth.domain_px", Verdict::Neutral},
                                                        {"cost.ms_median", Verdict::Neutral},
                                                        {"st.mean_texels", Verdict::Neutral}}));
}

TEST(HistoryMoves, Failure_IsRegressionOnce) {
    const HistoryRecord good = record("a", {{"silhouette.iou", 0.9}}),
                        worse = record("c", {{"silhouette.iou", 0.8}});
    EXPECT_THAT(movesOf({good, failing("b")}).failures,
                ElementsAre("mine fails: mine.glsl:3: undeclared 'x'"));
    EXPECT_TRUE(movesOf({good, failing("b")}).hasRegression());
    EXPECT_FALSE(movesOf({good, failing("b"), failing("c")}).hasRegression());
    const SceneMoves fixed = movesOf({good, failing("b"), worse});
    EXPECT_TRUE(fixed.hasRegression()); // compared with "a"
    EXPECT_THAT(fixed.notes,
                ElementsAre("mine works again", "mine is compared with 'a', where it last worked"));
    EXPECT_FALSE(movesOf({failing("a"), worse}).hasRegression());
}

TEST(HistoryMoves, OtherScenes_AreNotCompared) {
    HistoryRecord changed = record("b", {{"silhouette.iou", 0.1}}), proxy = changed, other = changed;
    const HistoryRecord first = record("a", {{"silhouette.iou", 0.9}});
    changed.sceneHash = "def";
    proxy.base = "proxy";
    other.scene = "plane";
    EXPECT_THAT(movesOf({first, changed}).notes,
                ElementsAre("not comparable with 'a': files or fields of the scene have changed"));
    EXPECT_THAT(movesOf({first, proxy}).notes, ElementsAre("not comparable with 'a': its base is different"));
    EXPECT_FALSE(movesOf({first, changed}).hasRegression());
    EXPECT_THAT(movesOf({first}).notes, ElementsAre("the first record of this scene"));
    // The original scene again: it is compared with the record of that scene.
    EXPECT_EQ(movesOf({first, changed, record("c", {{"silhouette.iou", 0.9}})}).before, "a");
    const auto both = latestMoves({first, other, first}, {}, {});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(latestMoves({first, other, first}, {first.scene}, {}).size(), 1u); // of that scene only
}

TEST(HistoryMoves, AddedAndRemovedTechniques_AreNotes) {
    HistoryRecord two = record("a", {{"silhouette.iou", 0.9}}), one = record("b", {{"silhouette.iou", 0.9}});
    two.techniques.push_back({"yours", {{"silhouette.iou", 0.5}}, ""});
    one.certificate = {{"error_px_p99", 1}};
    const SceneMoves scene = movesOf({two, one});
    EXPECT_FALSE(scene.hasRegression());
    ASSERT_EQ(scene.notes.size(), 2u);
    EXPECT_EQ(scene.notes[0], "yours is not in the latest record");
    EXPECT_THAT(scene.notes[1], HasSubstr("the reference's own error"));
    EXPECT_THAT(scene.moves, IsEmpty());
    EXPECT_EQ(scene.unmoved.at(0).second, 1u);
    EXPECT_THAT(movesOf({one, two}).notes, testing::Contains("yours is new"));
}

} // namespace
} // namespace plumbline::test
