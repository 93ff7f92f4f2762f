// The data of the interactive page: packed planes, curves, failing pixels, JSON in the page.
#include "tests/validate/results/sample_results.h"
#include "validate/report/error_curves.h"
#include "validate/report/failing_pixels.h"
#include "validate/report/frame_data.h"
#include "validate/report/layer_packing.h"
#include "validate/report/report_data.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <gmock/gmock.h>
#include <zlib.h>

namespace plumbline {
namespace {

using namespace test;
using nlohmann::json;
using report::base64;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<uint8_t> bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

// RFC 4648, section 10.
TEST(Base64, Rfc4648Vectors_Encode) {
    EXPECT_EQ(base64(bytesOf("")), "");
    EXPECT_EQ(base64(bytesOf("f")), "Zg==");
    EXPECT_EQ(base64(bytesOf("fo")), "Zm8=");
    EXPECT_EQ(base64(bytesOf("foo")), "Zm9v");
    EXPECT_EQ(base64(bytesOf("foob")), "Zm9vYg==");
    EXPECT_EQ(base64(bytesOf("fooba")), "Zm9vYmE=");
    EXPECT_EQ(base64(bytesOf("foobar")), "Zm9vYmFy");
    EXPECT_EQ(base64(std::vector<uint8_t>{255, 255, 254}), "///+");
}

/// Unpacks like the page, but simpler.
std::vector<uint8_t> unpack(const std::string& text, size_t size) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<uint8_t> packed;
    uint32_t bits = 0;
    int count = 0;
    for (const char letter : text) {
        if (letter == '=') break;
        bits = bits << 6 | static_cast<uint32_t>(letters.find(letter));
        count += 6;
        if (count >= 8) packed.push_back(static_cast<uint8_t>(bits >> (count -= 8)));
    }
    std::vector<uint8_t> bytes(size);
    uLongf length = size;
    EXPECT_EQ(uncompress(bytes.data(), &length, packed.data(), packed.size()), Z_OK);
    EXPECT_EQ(length, size);
    for (size_t at = 1; at < size; ++at)
        bytes[at] = static_cast<uint8_t>(bytes[at] + bytes[at - 1]);
    return bytes;
}

std::vector<uint32_t> unpackFloatBits(const std::string& text, size_t count) {
    const std::vector<uint8_t> bytes = unpack(text, 4 * count);
    std::vector<uint32_t> bits(count);
    for (size_t at = 0; at < count; ++at)
        for (size_t byte = 0; byte < 4; ++byte)
            bits[at] = bits[at] << 8 | bytes[byte * count + at];
    return bits;
}

RC_GTEST_PROP(LayerPacking, Floats_KeepEveryBit, (const std::vector<uint32_t>& bits)) {
    RC_PRE(!bits.empty());
    std::vector<float> values;
    for (const uint32_t pattern : bits)
        values.push_back(std::bit_cast<float>(pattern));
    RC_ASSERT(unpackFloatBits(report::packFloats(values), values.size()) == bits);
}

RC_GTEST_PROP(LayerPacking, Words_RoundTrip, (const std::vector<uint16_t>& values)) {
    RC_PRE(!values.empty());
    const std::vector<uint8_t> bytes = unpack(report::packWords(values), 2 * values.size());
    for (size_t at = 0; at < values.size(); ++at)
        RC_ASSERT((bytes[at] << 8 | bytes[values.size() + at]) == values[at]);
}

TEST(FrameData, Plane_TakesSmallestLosslessType) {
    Frame frame = emptyFrame(3, 1);
    paintRectangle(frame, 0, 0, 2, 1, 1, 2.5f);
    frame.add("cost.fetches");
    frame.add("cost.iterations");
    set(frame, "cost.fetches", 1, 0, 300);
    set(frame, "cost.iterations", 1, 0, 1.5f); // not an integer, so it must not be rounded
    const report::FrameData data = report::packTest(FramePair(frame, frame, {}), frame.channel("Z"));
    const json layers = json::parse(data.json);
    EXPECT_EQ(layers.size(), data.layers.size());
    EXPECT_EQ(layers.at("id").at("type"), "u8");
    EXPECT_EQ(layers.at("depth").at("type"), "f32");
    EXPECT_EQ(layers.at("fetches").at("type"), "u16");
    EXPECT_EQ(layers.at("iterations").at("type"), "f32");
    EXPECT_THAT(unpack(layers.at("id").at("data"), 3), ElementsAre(1, 1, 0));
    EXPECT_THAT(unpack(layers.at("shadow.sun").at("data"), 3),
                ElementsAre(0, 0, 255)); // "none" where nothing is covered
    EXPECT_THAT(unpackFloatBits(layers.at("depth").at("data"), 3),
                ElementsAre(std::bit_cast<uint32_t>(2.5f), std::bit_cast<uint32_t>(2.5f),
                            std::bit_cast<uint32_t>(kInfinityF)));
}

TEST(FrameData, NormalAngle_IsIn256thsOfDegree) {
    Frame reference = emptyFrame(2, 1);
    paintRectangle(reference, 0, 0, 2, 1);
    Frame test = reference;
    for (const char* axis : {"N.X", "N.Y", "N.Z"}) {
        set(reference, axis, 0, 0, axis[2] == 'Z' ? 1 : 0);
        set(test, axis, 0, 0, axis[2] == 'X' ? 3 : 0); // a right angle for any length
        set(test, axis, 1, 0, kNanF);
    }
    const json layer =
        json::parse(report::packTest(FramePair(reference, test, {}), {}).json).at("normal_angle");
    EXPECT_EQ(layer.at("scale"), 1.0 / 256);
    EXPECT_THAT(unpack(layer.at("data"), 4), ElementsAre(90, 255, 0, 255)); // 90 * 256, then "none"
}

// Relief depth 0.5: e = 0, +0.005, -0.05, +0.15, +0.5 are 0, 0.01, -0.1, 0.3 and 1 relief depths, up to float
// rounding.
TEST(ErrorCurves, FiveErrors_GiveSharesAndCounts) {
    Frame reference = emptyFrame(6, 1), test = emptyFrame(6, 1);
    const double errors[] = {0, 0.005, -0.05, 0.15, 0.5};
    for (int x = 0; x < 5; ++x) {
        paintPixel(reference, x, 0, 1, 2.0f);
        paintPixel(test, x, 0, 1, static_cast<float>(2 + errors[x]));
    }
    const FramePair pair(reference, test, {objectWithRelief(1, 0.5)});
    const Comparison comparison = compareFrames(reference, test, pair.objects(), std::nullopt);
    const auto curves = report::errorCurves(pair, comparison);
    ASSERT_TRUE(curves);
    const std::vector<double> thresholds = report::badpixThresholds();
    ASSERT_EQ(curves->badpix.size(), thresholds.size());
    for (size_t i = 0; i < thresholds.size(); ++i) {
        const double t = thresholds[i];
        if (std::abs(t - 0.01) < 1e-6 || std::abs(t - 0.1) < 1e-6 || std::abs(t - 1) < 1e-6)
            continue; // depends on rounding
        const double expected = (t < 0.01) + (t < 0.1) + (t < 0.3) + (t < 1);
        EXPECT_EQ(curves->badpix[i], expected / 5) << t;
    }
    // Equal to the metrics at the three named thresholds.
    const auto at = [&](double t) {
        return curves->badpix[static_cast<size_t>(std::find(thresholds.begin(), thresholds.end(), t) -
                                                  thresholds.begin())];
    };
    EXPECT_EQ(at(0.01), *comparison.pooled.figure("depth.badpix_1pct"));
    EXPECT_EQ(at(0.05), *comparison.pooled.figure("depth.badpix_5pct"));
    EXPECT_EQ(at(0.25), *comparison.pooled.figure("depth.badpix_25pct"));

    EXPECT_EQ(curves->below, 0u);
    EXPECT_EQ(curves->above, 2u); // 0.3 and 1
    uint64_t inside = 0;
    for (const uint64_t count : curves->counts)
        inside += count;
    EXPECT_EQ(inside, 3u);
    EXPECT_EQ(curves->counts[25], 1u); // 0 is in the first bin right of the middle
}

TEST(ErrorCurves, NoReliefOrDepth_IsAbsent) {
    const Frame reference = sampleReference();
    const FramePair pair(reference, reference, {objectWithRelief(1, 0), objectWithRelief(2, 0)});
    EXPECT_FALSE(
        report::errorCurves(pair, compareFrames(reference, reference, pair.objects(), std::nullopt)));
}

TEST(FailingPixels, EachReason_CountsOnceWithoutUncertain) {
    Frame reference = emptyFrame(8, 1);
    addUncertainty(reference);
    for (int x = 0; x < 7; ++x)
        paintPixel(reference, x, 0, 1, 2.0f);
    Frame test = reference;
    set(test, "id", 0, 0, 0);         // missing
    paintPixel(test, 7, 0, 1, 2);     // extra
    set(test, "Z", 1, 0, 2.06f);      // by 6 % of the relief
    set(test, "Z", 2, 0, 2.04f);      // by 4 %
    set(test, "Z", 3, 0, kNanF);      // no depth
    set(test, "shadow.sun", 4, 0, 1); // falsely dark
    set(test, "id", 5, 0, 2);         // another object
    set(test, "id", 6, 0, 0);         // missing, but the reference is uncertain
    set(reference, "uncertain", 6, 0, 1);
    const std::vector<ObjectInfo> objects{objectWithRelief(1, 1), objectWithRelief(2, 1)};
    const FramePair pair(reference, test, objects);
    const Comparison comparison = compareFrames(reference, test, objects, std::nullopt);
    report::FailingPixels failing;
    failing.add(pair, comparison);
    EXPECT_THAT(failing.counts(), ElementsAre(1, 1, 0, 1, 1, 1, 0, 1));
    failing.add(pair, comparison);
    EXPECT_EQ(failing.techniques(), 2);
    EXPECT_THAT(failing.counts(), ElementsAre(2, 2, 0, 2, 2, 2, 0, 2));
}

TEST(FailingPixels, Shadow_CountsWhereReferenceIsCertain) {
    Frame reference = emptyFrame(4, 1);
    addUncertainty(reference);
    paintRectangle(reference, 0, 0, 4, 1);
    Frame test = reference;
    for (int x = 0; x < 3; ++x)
        set(test, "shadow.sun", x, 0, 1);
    set(reference, "uncertain.shadow.sun", 1, 0, 1);
    set(reference, "shadow.sun", 2, 0, kNanF);
    set(test, "shadow.sun", 3, 0, kNanF); // no value where the reference is lit
    const FramePair pair(reference, test, {objectWithRelief(1, 1)});
    report::FailingPixels failing;
    failing.add(pair, compareFrames(reference, test, pair.objects(), std::nullopt));
    EXPECT_THAT(failing.counts(), ElementsAre(1, 0, 0, 1));
}

TEST(ReportData, ScriptEndTag_IsEscaped) {
    const std::string hostile = "</script><script>alert(1)</script><!--";
    Results results = sampleResults(hostile);
    results.scene.name = results.scene.purpose = hostile;
    report::ReportData data;
    data.frames = {
        {.id = "t1", .name = hostile, .kind = "technique", .file = "data/" + hostile, .layers = {hostile}}};
    data.objects = {objectWithRelief(1, 0.1)};
    data.objects[0].name = hostile;
    const std::string text = report::reportDataJson(results, data);
    EXPECT_THAT(text, Not(HasSubstr("<")));
    EXPECT_EQ(json::parse(text).at("frames")[0].at("name"), hostile);
    EXPECT_EQ(json::parse(text).at("results").at("scene").at("name"), hostile);
}

TEST(ReportData, NonUtf8Name_GivesValidJson) {
    report::ReportData data;
    data.frames = {{.id = "t1", .name = "caf\xe9", .kind = "technique", .file = "data/1.js", .layers = {}}};
    EXPECT_TRUE(json::accept(report::reportDataJson(sampleResults(), data)));
}

} // namespace
} // namespace plumbline
