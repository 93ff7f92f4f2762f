#include "tests/validate/results/sample_results.h"
#include "validate/metrics/metric_registry.h"
#include "validate/results/metric_table_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <gmock/gmock.h>
#include <limits>
#include <set>
#include <sstream>

namespace plumbline {
namespace {

using namespace test;
using nlohmann::json;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Figure, Value_IsNumberOrReason) {
    EXPECT_EQ(*Figure(0.5), 0.5);
    EXPECT_FALSE(Figure());
    EXPECT_FALSE(Figure(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(Figure(std::numeric_limits<double>::infinity()));
    EXPECT_EQ(Figure::ratio(0, 0, "empty").reason(), "empty");
    EXPECT_EQ(*Figure::ratio(0, 4, "empty"), 0);
}

TEST(ResultsJson, FullResults_HaveEveryKey) {
    const json results = json::parse(toJson(sampleResults()));
    EXPECT_EQ(results.at("schema"), 1);
    EXPECT_EQ(results.at("program"), "plumbline 0.1.0");
    EXPECT_EQ(results.at("scene").at("name"), "painted");
    for (const char* key : {"micro_triangles", "tessellate_ms", "build_ms", "trace_ms", "peak_bytes"})
        EXPECT_TRUE(results.at("reference").at(key).is_number()) << key;
    for (const char* key : {"error_px_p50", "error_px_p99", "error_px_max", "error_px_aim", "error_world_p50",
                            "error_world_p99", "error_world_max", "uncertain_pixels", "covered_pixels"})
        EXPECT_TRUE(results.at("reference").at(key).is_number()) << key;

    const json& technique = results.at("techniques").at(0);
    for (const char* key : {"name", "parameters", "gl", "silhouette", "depth", "shadow", "normal", "st",
                            "image", "cost", "objects", "error"})
        EXPECT_TRUE(technique.contains(key)) << key;
    for (const char* key : {"iou", "iou_low", "iou_high", "missing_px", "extra_px", "uncertain_px",
                            "contour_mean_px", "hausdorff95_px", "contour_reference_px", "contour_test_px"})
        EXPECT_TRUE(technique["silhouette"].contains(key)) << key;
    for (const char* key : {"1px", "2px", "4px", "2pct", "1px_low", "2pct_high", "4px_intersection_px"})
        EXPECT_TRUE(technique["silhouette"]["boundary_iou"].at(key).is_number()) << key;
    for (const char* key : {"domain_px", "bias", "mae", "rmse", "p50", "p95", "p99", "max", "rmse_relief",
                            "badpix_1pct", "badpix_5pct", "badpix_25pct", "uncertain_px"})
        EXPECT_TRUE(technique["depth"].at(key).is_number()) << key;
    for (const char* key :
         {"domain_px", "agreement", "agreement_low", "agreement_high", "iou", "iou_low", "iou_high", "f1",
          "f1_low", "f1_high", "ber", "false_shadow_px", "false_lit_px", "uncertain_px"})
        EXPECT_TRUE(technique["shadow"]["sun"].contains(key)) << key;
    EXPECT_TRUE(technique["normal"].contains("mean_degrees"));
    EXPECT_TRUE(technique["st"].contains("mean_texels"));
    for (const char* key :
         {"domain_px", "psnr_db", "rmse", "badpix_2codes", "badpix_2codes_px", "invalid_px"})
        EXPECT_TRUE(technique["image"].contains(key)) << key;
    EXPECT_FALSE(technique["objects"][0].contains("image"));
    EXPECT_EQ(technique["cost"].at("ms_median"), 12.5);
    EXPECT_EQ(technique["cost"].at("timer"), "wall clock around glFinish");
    EXPECT_TRUE(technique["error"].is_null());
    EXPECT_EQ(technique["objects"].size(), 2u);
    EXPECT_EQ(technique["pooled_objects"], json::array({"object 1"})); // object 2 has no relief
}

// sampleReference: object 1 covers columns 1 2 3 of rows 1 … 4. Shifted right by one, two of four columns are
// shared. One empty pixel may show the object: IoU at least 8/17. The only shadow of the reference, at (2,
// 2), is uncertain; that of the test is at (3, 2), lit in the reference: agreement 6/8, at most 7/8. The
// contour is the object without the two inner pixels. Its distance to the moved one is 1 for column 1 and for
// the two pixels of column 3 that aren't corners, 0 for the others: 6 of 10, and the same in the other
// direction.
TEST(ResultsJson, Comparison_NumbersAreKept) {
    const json technique = json::parse(toJson(sampleResults())).at("techniques").at(0);
    EXPECT_EQ(technique["silhouette"]["iou"], 8.0 / 16.0);
    EXPECT_EQ(technique["silhouette"]["iou_low"], 8.0 / 17.0);
    EXPECT_EQ(technique["silhouette"]["iou_high"], 8.0 / 16.0);
    EXPECT_EQ(technique["silhouette"]["uncertain_px"], 1);
    EXPECT_EQ(technique["shadow"]["sun"]["agreement"], 6.0 / 8.0);
    EXPECT_EQ(technique["shadow"]["sun"]["agreement_low"], 6.0 / 8.0);
    EXPECT_EQ(technique["shadow"]["sun"]["agreement_high"], 7.0 / 8.0);
    EXPECT_EQ(technique["depth"]["uncertain_px"], 0);
    EXPECT_EQ(technique["image"]["domain_px"], 48);
    EXPECT_EQ(technique["image"]["badpix_2codes_px"],
              2); // the white pixel of the reference, and its new position
    EXPECT_EQ(technique["silhouette"]["missing_px"], 4);
    EXPECT_EQ(technique["silhouette"]["contour_mean_px"], 12.0 / 20.0);
    EXPECT_EQ(technique["silhouette"]["hausdorff95_px"], 1.0);
    EXPECT_EQ(technique["silhouette"]["contour_reference_px"], 10);
    EXPECT_EQ(technique["silhouette"]["contour_test_px"], 10);
    EXPECT_EQ(technique["depth"]["domain_px"], 8);
    EXPECT_EQ(technique["depth"]["max"], 0.0);
}

TEST(ResultsJson, Certificate_IsKept) {
    const json reference = json::parse(toJson(sampleResults())).at("reference");
    EXPECT_EQ(reference["error_px_p50"], 0.004);
    EXPECT_EQ(reference["error_px_p99"], 0.031);
    EXPECT_EQ(reference["error_px_max"], 0.4);
    EXPECT_EQ(reference["error_px_aim"], 0.05);
    EXPECT_EQ(reference["error_world_p50"], 1e-6);
    EXPECT_EQ(reference["error_world_p99"], 1.2e-5);
    EXPECT_EQ(reference["error_world_max"], 2.5e-4);
    EXPECT_EQ(reference["error_limit"], "");
    EXPECT_EQ(reference["uncertain_pixels"], 134);
    EXPECT_EQ(reference["uncertain_shadow_pixels"], (json{{"sun", 420}, {"lamp", 7}}));
    EXPECT_FALSE(reference.contains("absent"));
}

TEST(ResultsJson, UnknownCertificate_HasReason) {
    Results results = sampleResults();
    setAbsent(results.reference.certificate, "it came from afar");
    results.reference.certificate.uncertainShadowPixels["sun"] = Figure::absent("no channel");
    const json reference = json::parse(toJson(results)).at("reference");
    for (const char* key : {"error_px_p50", "error_world_max", "error_limit"}) {
        EXPECT_FALSE(reference.contains(key)) << key;
        EXPECT_EQ(reference["absent"].at(key), "it came from afar") << key;
    }
    EXPECT_EQ(reference["uncertain_shadow_pixels"], (json{{"lamp", 7}, {"absent", {{"sun", "no channel"}}}}));
}

TEST(ResultsJson, AbsentFigures_HaveReason) {
    const json technique = json::parse(toJson(sampleResults())).at("techniques").at(0);
    EXPECT_FALSE(technique["cost"].contains("fetches_mean"));
    EXPECT_THAT(technique["cost"]["absent"]["fetches_mean"].get<std::string>(), HasSubstr("cost.fetches"));
    const json& plain = technique["objects"][1]; // without a relief
    EXPECT_FALSE(plain["depth"].contains("rmse_relief"));
    EXPECT_THAT(plain["depth"]["absent"]["rmse_relief"].get<std::string>(), HasSubstr("no relief"));
}

// Object 1 covers columns 1 2 3 of four rows in the limit reference, 2 3 in the proxy's and in the shifted
// test: 8/12 and 8/8. Test compared with proxy: 8 pixels of columns 2 3 are shared and the 4 of column 4
// (object 2 in the proxy's frame) are extra: 8/12.
TEST(ResultsJson, BothBases_AreKept) {
    const json results = json::parse(toJson(sampleResultsOnBothBases()));
    EXPECT_EQ(results["base"], "both");
    EXPECT_EQ(results["reference_proxy"]["error_limit"], "--memory 1 MB");
    const json &gap = results["base_gap"], &technique = results["techniques"][0];
    EXPECT_EQ(gap["silhouette"]["iou"], 8.0 / 12.0);
    EXPECT_EQ(gap["silhouette"]["missing_px"], 4);
    EXPECT_EQ(gap["objects"].size(), 2u);
    EXPECT_EQ(technique["silhouette"]["iou"], 8.0 / 16.0);
    EXPECT_EQ(technique["against_proxy"]["silhouette"]["iou"], 8.0 / 12.0);
    EXPECT_EQ(technique["against_proxy"]["silhouette"]["extra_px"], 4);
    for (const json* comparison : {&gap, &technique["against_proxy"]}) {
        for (const char* group : {"pooled_objects", "silhouette", "depth", "shadow", "normal", "st", "image"})
            EXPECT_TRUE(comparison->contains(group)) << group;
        EXPECT_FALSE(comparison->contains("cost"));
    }
    EXPECT_FALSE(results["techniques"][1].contains("against_proxy")); // failed
}

TEST(ResultsJson, UnknownBase_IsNull) {
    Results results = sampleResults();
    EXPECT_TRUE(json::parse(toJson(results)).at("base").is_null());
    results.base = "proxy";
    EXPECT_EQ(json::parse(toJson(results)).at("base"), "proxy");
    EXPECT_FALSE(json::parse(toJson(results)).contains("base_gap"));
}

TEST(ResultsJson, FailedTechnique_HasMessageOnly) {
    const json technique = json::parse(toJson(sampleResults())).at("techniques").at(1);
    EXPECT_EQ(technique["error"], "broken.glsl:3: undeclared 'x'");
    EXPECT_FALSE(technique.contains("silhouette"));
    EXPECT_FALSE(technique.contains("cost"));
}

TEST(ResultsJson, EqualResults_GiveEqualBytesWithoutNan) {
    const std::string text = toJson(sampleResults());
    EXPECT_EQ(text, toJson(sampleResults()));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
    EXPECT_THAT(text, Not(HasSubstr("inf")));
    EXPECT_LT(text.find("\"schema\""), text.find("\"program\""));
    EXPECT_LT(text.find("\"silhouette\""), text.find("\"depth\""));
}

TEST(ResultsJson, NonUtf8Names_AreWritten) {
    EXPECT_TRUE(json::parse(toJson(sampleResults("caf\xe9"))).is_object());
}

/// Rows of RFC 4180 text.
std::vector<std::vector<std::string>> parseCsv(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1);
    rows.back().emplace_back();
    bool quoted = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            if (c != '"')
                rows.back().back() += c;
            else if (i + 1 < text.size() && text[i + 1] == '"')
                rows.back().back() += text[i++];
            else
                quoted = false;
        } else if (c == '"') {
            quoted = true;
        } else if (c == ',') {
            rows.back().emplace_back();
        } else if (c == '\n') {
            rows.emplace_back(1);
        } else if (c != '\r') {
            rows.back().back() += c;
        }
    }
    rows.pop_back(); // the text ends with a line break
    return rows;
}

TEST(ResultsCsv, EachTechniqueObjectLight_HasRow) {
    const auto rows = parseCsv(toCsv(sampleResults("a,\"b\"")));
    ASSERT_EQ(rows.size(), 5u); // head, pooled, two objects, the failed one
    for (const auto& row : rows)
        EXPECT_EQ(row.size(), rows[0].size());
    EXPECT_EQ(rows[1][0], "a,\"b\"");
    EXPECT_EQ(rows[1][1], "(pooled)");
    EXPECT_EQ(rows[1][2], "sun");
    EXPECT_EQ(rows[2][1], "object 1");
    EXPECT_EQ(rows[3][1], "object 2");
    EXPECT_EQ(rows[4][0], "broken");
    EXPECT_EQ(rows[4].back(), "broken.glsl:3: undeclared 'x'");
    const auto column =
        static_cast<size_t>(std::find(rows[0].begin(), rows[0].end(), "silhouette.iou") - rows[0].begin());
    EXPECT_EQ(rows[1].at(column), "0.5");
    const auto picture =
        static_cast<size_t>(std::find(rows[0].begin(), rows[0].end(), "image.domain_px") - rows[0].begin());
    EXPECT_EQ(rows[1].at(picture), "48");
    EXPECT_EQ(rows[2].at(picture), ""); // not computed per object
    EXPECT_EQ(rows[4].at(column), "");
    EXPECT_EQ(rows[4].at(column + 1), ""); // counts of a failed technique are absent, not 0
}

TEST(ResultsCsv, BothBases_HaveOwnRows) {
    const auto rows = parseCsv(toCsv(sampleResultsOnBothBases()));
    ASSERT_EQ(rows[0][3], "reference");
    const auto column =
        static_cast<size_t>(std::find(rows[0].begin(), rows[0].end(), "silhouette.iou") - rows[0].begin());
    std::vector<std::string> pooled;
    for (const auto& row : rows)
        if (row[1] == "(pooled)") pooled.push_back(row[0] + " " + row[3] + " " + row.at(column).substr(0, 5));
    EXPECT_EQ(pooled, (std::vector<std::string>{"(base gap) limit 0.666", "linear_binary limit 0.5",
                                                "linear_binary proxy 0.666", "broken  "}));
    EXPECT_EQ(rows.size(),
              1u + 3 * 3 + 1); // head, three comparisons pooled and of two objects, the failed one
}

TEST(ResultsCsv, NoLights_StillHasRow) {
    Frame frame(2, 1);
    frame.add("id")[0] = 1;
    Results results;
    results.techniques.resize(1);
    results.techniques[0].comparison = compareFrames(frame, frame, {}, std::nullopt);
    EXPECT_EQ(parseCsv(toCsv(results)).size(), 3u); // head, pooled, object 1
}

TEST(MetricTable, Rows_EqualCsvColumns) {
    std::set<std::string> documented, written;
    for (const MetricInfo& metric : metricTable())
        documented.emplace(metric.key);
    const auto rows = parseCsv(toCsv({}));
    for (const std::string& column : rows.at(0))
        if (column.find('.') != std::string::npos) written.insert(column);
    EXPECT_EQ(documented, written);
}

/// Keys of the numbers and of the reasons in a group of results.json, prefixed by the group's name.
void collectKeys(const json& group, const std::string& prefix, std::set<std::string>& keys) {
    for (const auto& [key, value] : group.items())
        if (key == "absent")
            collectKeys(value, prefix, keys);
        else if (value.is_object())
            collectKeys(value, prefix + "." + key, keys);
        else
            keys.insert(prefix + "." + key);
}

TEST(MetricTable, Rows_EqualJsonKeys) {
    const json technique = json::parse(toJson(sampleResults())).at("techniques").at(0);
    std::set<std::string> documented, written;
    for (const MetricInfo& metric : metricTable())
        documented.emplace(metric.key);
    for (const char* group : {"silhouette", "depth", "normal", "st", "image", "fault", "cost"})
        collectKeys(technique.at(group), group, written);
    collectKeys(technique.at("shadow").at("sun"), "shadow", written);
    for (const char* more : {"cost.ms_runs", "cost.timer"}) // of the run, no figures
        EXPECT_EQ(written.erase(more), 1u) << more;
    EXPECT_EQ(documented, written);
}

TEST(MetricTable, Intervals_MatchResults) {
    EXPECT_TRUE(findMetric("silhouette.boundary_iou.2pct")->hasInterval);
    EXPECT_TRUE(findMetric("shadow.f1")->hasInterval);
    EXPECT_FALSE(findMetric("shadow.ber")->hasInterval);
    EXPECT_EQ(findMetric("silhouette.oui"), nullptr);
}

TEST(MetricTable, Description_FitsTerminal) {
    for (const MetricInfo& metric : metricTable()) {
        std::istringstream lines(describe(metric));
        std::string line;
        while (std::getline(lines, line)) {
            const auto characters =
                std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
            EXPECT_LE(characters, 110) << line;
        }
        EXPECT_EQ(describe(metric).find(metric.key), 0u);
        for (const std::string* text : {&metric.label, &metric.domain, &metric.meaning})
            EXPECT_FALSE(text->empty()) << metric.key;
    }
}

TEST(MetricTable, Json_ContainsEveryField) {
    const json table = json::parse(metricTableJson());
    ASSERT_EQ(table.size(), metricTable().size());
    EXPECT_EQ(table[0]["key"], "silhouette.iou");
    EXPECT_EQ(table[0]["better"], "high");
    for (const json& metric : table)
        for (const char* field :
             {"key", "label", "unit", "best", "better", "formula", "domain", "source", "meaning"})
            EXPECT_TRUE(metric.at(field).is_string()) << field;
}

TEST(ResultsJson, Requirements_AreKept) {
    Results results = sampleResults();
    EXPECT_FALSE(json::parse(toJson(results))["techniques"][0].contains("requirements"));
    results.techniques[0].requirements = {{"silhouette.iou >= 0.99", "silhouette.iou", 0.5, false}};
    results.techniques[1].requirements = {
        {"silhouette.iou >= 0.99", "silhouette.iou", Figure::absent("the technique failed"), false}};
    const json techniques = json::parse(toJson(results))["techniques"];
    EXPECT_EQ(techniques[0]["requirements"], (json::array({{{"require", "silhouette.iou >= 0.99"},
                                                            {"key", "silhouette.iou"},
                                                            {"value", 0.5},
                                                            {"passed", false}}})));
    EXPECT_EQ(techniques[1]["requirements"][0]["absent"], "the technique failed");
    EXPECT_THAT(toTable(results), HasSubstr("0/1 FAILED"));
    EXPECT_THAT(toTable(sampleResults()), Not(HasSubstr("require")));
}

TEST(ResultsTable, Table_FitsTerminal) {
    Results results = sampleResults("linear_binary@quadric");
    results.techniques.pop_back();
    const std::string table = toTable(results);
    EXPECT_LE(table.find('\n'), 130u);
}

TEST(ResultsTable, BothBases_HaveSecondTable) {
    const std::string table = toTable(sampleResultsOnBothBases());
    const size_t second = table.find("against the proxy ");
    ASSERT_NE(second, std::string::npos);
    EXPECT_THAT(table.substr(0, second), Not(HasSubstr("0.66667")));
    EXPECT_THAT(table.substr(second), HasSubstr("(base gap)         0.66667"));
    EXPECT_THAT(table.substr(second), HasSubstr("linear_binary      0.66667"));
    EXPECT_THAT(toTable(sampleResults()), Not(HasSubstr("proxy")));
}

TEST(ResultsTable, MissingFiguresAndFailures_AreShown) {
    const std::string table = toTable(sampleResults());
    // 8/16 - 8/17 = 0.029411…, rounded up; 7/8 - 6/8 exactly
    EXPECT_THAT(table, HasSubstr("0.50000  0.02942"));
    EXPECT_THAT(table, HasSubstr("0.7500  0.1250"));
    EXPECT_THAT(table, HasSubstr("broken: failed: broken.glsl:3"));
    EXPECT_THAT(table, HasSubstr("  -  ")); // no lookups were counted
}

} // namespace
} // namespace plumbline
