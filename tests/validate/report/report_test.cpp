#include "scenes/core/srgb.h"
#include "tests/temporary_folder.h"
#include "tests/validate/results/sample_results.h"
#include "validate/report/pictures.h"
#include "validate/report/report.h"
#include "validate/report/report_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::Not;

Rgb pixelOf(const Picture& picture, int x, int y) {
    const size_t at =
        (static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x)) * 3;
    return {picture.rgb[at], picture.rgb[at + 1], picture.rgb[at + 2]};
}

// IEC 61966-2-1: 0.0031308 is where the line meets the curve (code 10.3), 0.5 encodes to 0.7354 = 187.5 /
// 255, and code 128 means 0.21586 linear.
TEST(SrgbCode, LinearValues_GetStandardCode) {
    EXPECT_EQ(srgbCode(0), 0);
    EXPECT_EQ(srgbCode(1), 255);
    EXPECT_EQ(srgbCode(0.0031308), 10);
    EXPECT_EQ(srgbCode(0.21586), 128);
    EXPECT_EQ(srgbCode(0.5), 188);
    EXPECT_EQ(srgbCode(7), 255);
    EXPECT_EQ(srgbCode(-1), 0);
    EXPECT_EQ(srgbCode(kNanF), 0);
}

TEST(ColorAt, BetweenStops_IsLinear) {
    const std::array<Rgb, 3> stops{{{0, 10, 20}, {100, 110, 120}, {200, 10, 255}}};
    const ColorMap map{"map", 0, stops}, diverging{"diverging", -1, stops};
    EXPECT_EQ(colorAt(map, 0), stops[0]);
    EXPECT_EQ(colorAt(map, 0.25), (Rgb{50, 60, 70}));
    EXPECT_EQ(colorAt(map, 0.5), stops[1]);
    EXPECT_EQ(colorAt(map, 0.75), (Rgb{150, 60, 188})); // 187.5 away from zero
    EXPECT_EQ(colorAt(map, 1), stops[2]);
    for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0})
        EXPECT_EQ(colorAt(diverging, x), colorAt(map, (x + 1) / 2)) << x;
}

TEST(ColorAt, BeyondEnds_Clamps) {
    for (const ColorMap& map : colormap::all()) {
        EXPECT_EQ(colorAt(map, map.low - 3), map.stops.front()) << map.name;
        EXPECT_EQ(colorAt(map, 7), map.stops.back()) << map.name;
    }
}

TEST(Pictures, Silhouette_ColorsEachCase) {
    Frame reference = emptyFrame(5, 1), test = emptyFrame(5, 1);
    paintPixel(reference, 1, 0, 1, 2); // agree
    paintPixel(test, 1, 0, 1, 2);
    paintPixel(reference, 2, 0, 1, 2); // missing
    paintPixel(test, 3, 0, 1, 2);      // extra
    paintPixel(reference, 4, 0, 1, 2); // another object
    paintPixel(test, 4, 0, 2, 2);
    const Picture picture = silhouettePicture(FramePair(reference, test, {}));
    EXPECT_EQ(pixelOf(picture, 0, 0), palette::kNothing);
    EXPECT_EQ(pixelOf(picture, 1, 0), palette::kAgree);
    EXPECT_EQ(pixelOf(picture, 2, 0), palette::kMissing);
    EXPECT_EQ(pixelOf(picture, 3, 0), palette::kExtra);
    EXPECT_EQ(pixelOf(picture, 4, 0), palette::kOther);
}

TEST(Pictures, DepthError_IsSymmetricAndSaturates) {
    Frame reference = emptyFrame(5, 1), test = emptyFrame(5, 1);
    paintRectangle(reference, 0, 0, 5, 1, 1, 2.0f);
    const float depths[] = {2.0f, 1.5f, 2.5f, 9.0f, kNanF};
    for (int x = 0; x < 5; ++x)
        paintPixel(test, x, 0, 1, depths[x]);
    const Picture picture =
        depthErrorPicture(FramePair(reference, test, {}), reference.channel("Z"), test.channel("Z"), 0.5);
    EXPECT_EQ(pixelOf(picture, 0, 0), colorAt(colormap::kDiverging, 0));
    EXPECT_EQ(pixelOf(picture, 1, 0), colorAt(colormap::kDiverging, -1)); // nearer by the full range
    EXPECT_EQ(pixelOf(picture, 2, 0), colorAt(colormap::kDiverging, 1));
    EXPECT_EQ(pixelOf(picture, 3, 0), colorAt(colormap::kDiverging, 1)); // beyond the range
    EXPECT_EQ(pixelOf(picture, 4, 0), palette::kInvalid);
    EXPECT_GT(colorAt(colormap::kDiverging, -1)[2], colorAt(colormap::kDiverging, -1)[0]); // too near is blue
    EXPECT_GT(colorAt(colormap::kDiverging, 1)[0], colorAt(colormap::kDiverging, 1)[2]); // too far is orange
}

TEST(Pictures, Shadow_ColorsEachCase) {
    Frame reference = emptyFrame(4, 1), test = emptyFrame(4, 1);
    paintRectangle(reference, 0, 0, 4, 1);
    paintRectangle(test, 0, 0, 4, 1);
    for (const int x : {1, 3})
        set(reference, "shadow.sun", x, 0, 1);
    for (const int x : {1, 2})
        set(test, "shadow.sun", x, 0, 1);
    const Picture picture = shadowPicture(FramePair(reference, test, {}), "sun");
    EXPECT_EQ(pixelOf(picture, 0, 0), palette::kAgree);
    EXPECT_EQ(pixelOf(picture, 1, 0), palette::kBothDark);
    EXPECT_EQ(pixelOf(picture, 2, 0), palette::kExtra);   // false shadow
    EXPECT_EQ(pixelOf(picture, 3, 0), palette::kMissing); // false light
}

TEST(Pictures, Curvature_IsRedConvexBlueConcaveGreenFlat) {
    Frame test = emptyFrame(12, 1), empty = emptyFrame(2, 1);
    test.add("curvature.a");
    empty.add("curvature.a");
    const float values[] = {0, 0.5f, -0.5f, 0.25f, 7, kNanF, 0, 0, 0, 0, 0, 3};
    for (int x = 0; x < 11; ++x) { // the last one isn't covered
        set(test, "id", x, 0, 1);
        set(test, "curvature.a", x, 0, values[x]);
    }
    const Picture picture = curvaturePicture(test, "curvature.a", 0.5);
    EXPECT_EQ(pixelOf(picture, 0, 0), colorAt(colormap::kCurvature, 0));
    EXPECT_EQ(pixelOf(picture, 1, 0), colorAt(colormap::kCurvature, 1));
    EXPECT_EQ(pixelOf(picture, 2, 0), colorAt(colormap::kCurvature, -1));
    EXPECT_EQ(pixelOf(picture, 3, 0), colorAt(colormap::kCurvature, 0.5)); // by magnitude
    EXPECT_EQ(pixelOf(picture, 4, 0), colorAt(colormap::kCurvature, 1));   // beyond the range
    EXPECT_EQ(pixelOf(picture, 5, 0), palette::kInvalid);
    EXPECT_EQ(pixelOf(picture, 11, 0), palette::kNothing);
    const auto strongest = [](const Rgb& color) {
        return std::max_element(color.begin(), color.end()) - color.begin();
    };
    EXPECT_EQ(strongest(colorAt(colormap::kCurvature, 1)), 0);
    EXPECT_EQ(strongest(colorAt(colormap::kCurvature, 0)), 1);
    EXPECT_EQ(strongest(colorAt(colormap::kCurvature, -1)), 2);
    // Nine of ten finite values are within 0.5; the tenth doesn't matter.
    EXPECT_EQ(curvatureRange(test, "curvature.a"), 0.5);
    EXPECT_EQ(curvatureRange(empty, "curvature.a"), 0);
}

TEST(ReportFiles, LongNames_HaveOwnFiles) {
    const TemporaryFolder folder;
    const Frame reference = sampleReference(), test = shiftedRight(reference);
    TechniqueOutcome technique;
    technique.name = std::string(150, 'x');
    technique.comparison = compareFrames(reference, test, {}, std::nullopt);
    Report report(folder.path(), {.interactive = false, .singleFile = false});
    report.addTechnique(technique, reference, test);
    const std::string stem = "1_" + std::string(98, 'x'); // 100 letters of the name are kept
    for (const char* what : {"_color", "_silhouette", "_depth"})
        EXPECT_TRUE(std::filesystem::exists(folder / (stem + what + ".png"))) << what;
}

TEST(ReportPage, EveryText_IsEscaped) {
    const std::string hostile = "<script>alert('x')</script>&\"";
    Results results = sampleResults(hostile);
    results.scene.name = hostile;
    results.scene.purpose = hostile;
    results.techniques[0].parameters[hostile] = hostile;
    results.techniques[0].limits = {hostile};
    results.techniques[0].comparison.notes = {hostile};
    results.techniques[0].comparison.objects[0].object.name = hostile;
    results.techniques[1].error = hostile;
    results.reference.objects[0].name = hostile;
    ReportPictures pictures;
    ReportPicture picture;
    picture.caption = hostile;
    picture.file = "a.png";
    pictures.techniques[hostile] = {picture};
    const std::string page = reportPage(results, pictures, {});
    EXPECT_THAT(page, Not(HasSubstr("<script")));
    EXPECT_THAT(page, HasSubstr("&lt;script&gt;"));
}

TEST(ReportPage, Page_ShowsFiguresLimitsAndReasons) {
    const std::string page = reportPage(sampleResults(), {}, {});
    EXPECT_THAT(page, HasSubstr("A scene &lt;of&gt; paint &amp; &quot;quotes&quot;"));
    EXPECT_THAT(page, HasSubstr("1 234 567 micro-triangles"));
    EXPECT_THAT(page, HasSubstr("8 segments per control edge instead of the 16"));
    EXPECT_THAT(page, HasSubstr("99 % within 0.031 px (the aim: 0.05 px)"));
    EXPECT_THAT(page, HasSubstr("seen in 134 pixels"));
    EXPECT_THAT(page, HasSubstr("broken.glsl:3"));
    EXPECT_THAT(page, HasSubstr(">0.50000<small>0.47059–0.50000</small>"));
    EXPECT_THAT(page, HasSubstr(">0.7500<small>0.7500–0.8750</small>"));
    EXPECT_THAT(page, HasSubstr("contour distance<small>mean, px"));
    // 4 missing, 4 extra, 12 px in 20.
    EXPECT_THAT(page, HasSubstr("<td data-value=\"4\">4</td><td data-value=\"4\">4</td>"));
    EXPECT_THAT(page, HasSubstr("<td data-value=\"0.6\">0.60</td><td data-value=\"1\">1.00</td>"));
    EXPECT_THAT(page, HasSubstr("title=\"the test frame has no channel cost.fetches\">–"));
    EXPECT_THAT(page, HasSubstr("12.5 ms, median of 5 (wall clock around glFinish)"));
}

TEST(ReportPage, BestFiguresAndMissedRequirements_AreMarked) {
    Results results = sampleResults(); // its first technique has an IoU of 0.5
    const Frame reference = sampleReference();
    TechniqueOutcome exact = results.techniques[0];
    exact.name = "exact";
    exact.comparison = compareFrames(reference, reference, {objectWithRelief(1, 0.1)}, std::nullopt);
    results.techniques.push_back(exact);
    EXPECT_THAT(reportPage(results, {}, {}), HasSubstr("<td class=\"best\" data-value=\"1\">1.00000"));
    EXPECT_THAT(reportPage(results, {}, {}), Not(HasSubstr("class=\"best\" data-value=\"0.5\"")));
    EXPECT_THAT(reportPage(results, {}, {}), Not(HasSubstr("miss a requirement")));

    results.techniques[0].requirements = {{"silhouette.iou >= 0.9", "silhouette.iou", 0.5, false},
                                          {"depth.rmse <= 1", "depth.rmse", 0.1, true}};
    const std::string page = reportPage(results, {}, {});
    EXPECT_THAT(page, HasSubstr("<td class=\"fail\" data-value=\"0.5\">0.50000"));
    EXPECT_THAT(page, HasSubstr("misses 1 of 2 required"));
    EXPECT_THAT(page, HasSubstr(">Required silhouette.iou &gt;= 0.9, found 0.5.<"));
    EXPECT_THAT(page, HasSubstr("miss a requirement"));

    results.techniques[0].requirements = {
        {"silhouette.iou@object 1 >= 0.9", "silhouette.iou@object 1", 0.25, false}};
    const std::string ofObject = reportPage(results, {}, {});
    EXPECT_THAT(ofObject, HasSubstr("<tr><th scope=\"row\">object 1</th><td class=\"fail\">"));
    EXPECT_THAT(ofObject, Not(HasSubstr("<td class=\"fail\" data-value=\"0.5\">"))); // the pooled one
    EXPECT_THAT(ofObject, HasSubstr("<tr><th scope=\"row\">object 2</th><td>"));

    results.techniques[0].requirements = {{"shadow.agreement >= 0.9", "shadow.sun.agreement", 0.5, false}};
    EXPECT_THAT(reportPage(results, {}, {}),
                HasSubstr(">Required shadow.agreement &gt;= 0.9, found 0.5 in shadow.sun.agreement.<"));

    results.techniques.back().control = true; // only one technique is left to rank
    EXPECT_THAT(reportPage(results, {}, {}), Not(HasSubstr("class=\"best\" data-value")));
}

TEST(ReportPage, BothBases_ShowGap) {
    ReportPictures pictures;
    ReportPicture picture;
    picture.kind = ReportPicture::Kind::Silhouette;
    picture.caption = "Silhouette difference";
    picture.file = "gap.png";
    pictures.baseGap = {picture};
    const std::string page = reportPage(sampleResultsOnBothBases(), pictures, {});
    const size_t begin = page.find("id=\"base\""), end = page.find("id=\"technique-1\"");
    ASSERT_LT(begin, end);
    const std::string section = page.substr(begin, end - begin);
    EXPECT_THAT(section, HasSubstr("<th scope=\"row\">the base gap</th><td>0.66667<small>"));
    EXPECT_THAT(section, HasSubstr("<th scope=\"row\">linear_binary</th><td>0.66667<small>"));
    EXPECT_THAT(section,
                HasSubstr("src=\"gap.png\" alt=\"Silhouette difference of the reference on the proxy\""));
    EXPECT_THAT(section, HasSubstr(cssColor(palette::kMissing))); // its legend
    EXPECT_THAT(section, HasSubstr("The aim isn&apos;t met: --memory 1 MB."));
    EXPECT_THAT(reportPage(sampleResults(), {}, {}), Not(HasSubstr("id=\"base\"")));
}

TEST(ReportPage, Page_NeedsNoNetwork) {
    const std::string page = reportPage(sampleResults(), {}, {});
    for (const char* remote : {"http:", "https:", "//cdn", "<script", "<link", "@import"})
        EXPECT_THAT(page, Not(HasSubstr(remote))) << remote;
}

} // namespace
} // namespace plumbline
