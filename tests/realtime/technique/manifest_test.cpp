// Manifests, settings and names, without OpenGL.
#include "realtime/glsl/glsl_text.h"
#include "realtime/technique/composition.h"
#include "realtime/technique/harness_parameters.h"
#include "realtime/technique/technique.h"
#include "realtime/technique/technique_list.h"
#include "scenes/core/error.h"
#include "scenes/core/read_file.h"
#include "scenes/toml/toml_table.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(TechniqueText, FullText_GivesSearchSurfaceSettings) {
    const TechniqueRequest request = parseTechnique("linear_binary@quadric:linear_steps=64,binary_steps=0");
    EXPECT_EQ(request.search, "linear_binary");
    EXPECT_EQ(request.surface, "quadric");
    EXPECT_EQ(request.settings.at("linear_steps"), "64");
    EXPECT_EQ(request.settings.at("binary_steps"), "0");
    EXPECT_EQ(parseTechnique("linear_binary").surface, "flat");
}

TEST(TechniqueText, PathWithAtAndColon_IsRead) {
    const TechniqueRequest request = parseTechnique("/a@b:c/mine@quadric:n=1");
    EXPECT_EQ(request.search, "/a@b:c/mine");
    EXPECT_EQ(request.surface, "quadric");
    EXPECT_EQ(parseTechnique("../mine/").search, "../mine");
}

TEST(TechniqueText, MalformedText_IsRefused) {
    for (const char* text : {"", "@quadric", "a@", "a:", "a:b", "a:=1", "a:b=", "a:b=1,", "a:b=1,b=2"})
        EXPECT_THROW(parseTechnique(text), InputError) << text;
}

TEST(TechniqueText, RandomText_ParsesOrIsRefused) {
    rc::check([](const std::string& text) {
        try {
            RC_ASSERT(!parseTechnique(text).search.empty());
        } catch (const InputError&) {
        }
    });
}

std::string nameOf(const std::string& text, const Settings& shared = {}) {
    return resolveTechnique(text, shared).name();
}

TEST(TechniqueName, ChangedParameters_AreSortedInName) {
    EXPECT_EQ(nameOf("linear_binary"), "linear_binary");
    EXPECT_EQ(nameOf("linear_binary@flat:linear_steps=10"), "linear_binary");
    EXPECT_EQ(nameOf("linear_binary@quadric:linear_steps=64"), "linear_binary@quadric:linear_steps=64");
    EXPECT_EQ(nameOf("linear_binary:shadow=none,linear_steps=064,filter=hardware,binary_steps=2"),
              "linear_binary:binary_steps=2,filter=hardware,linear_steps=64,shadow=none");
    EXPECT_EQ(nameOf("linear_binary:shadow_bias=2e-2"), "linear_binary");
    EXPECT_EQ(nameOf("linear_binary:shadow_bias=0.050"), "linear_binary:shadow_bias=0.05");
}

TEST(TechniqueName, OwnSettings_OverrideShared) {
    EXPECT_EQ(nameOf("linear_binary:linear_steps=5", {{"linear_steps", "7"}, {"cone_steps", "3"}}),
              "linear_binary:linear_steps=5");
    EXPECT_EQ(nameOf("micro_triangles", {{"linear_steps", "7"}}), "micro_triangles");
}

TEST(TechniqueList, Library_IsSortedWithoutTemplate) {
    std::vector<std::string> names;
    for (const Manifest& info : listTechniques())
        names.push_back(info.name);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    EXPECT_THAT(names, testing::IsSupersetOf({"linear_binary", "micro_triangles", "normal_mapping"}));
    EXPECT_THAT(names, testing::Not(testing::Contains("_template")));
}

TEST(TechniqueList, EveryComposition_ResolvesOnItsSurfacesOnly) {
    const std::vector<Manifest> library = listSurfaces();
    for (const Manifest& info : listTechniques()) {
        EXPECT_FALSE(info.title.empty());
        const std::vector<std::string> surfaces = surfacesFor(info, library);
        EXPECT_EQ(info.drawsMicroTriangles(), surfaces.empty());
        for (const Manifest& surface : library) {
            const bool runs = std::find(surfaces.begin(), surfaces.end(), surface.name) != surfaces.end();
            EXPECT_EQ(messageOf<InputError>([&] { nameOf(info.name + "@" + surface.name); }).empty(),
                      runs || (info.drawsMicroTriangles() && surface.name == "flat"))
                << info.name << " " << surface.name;
        }
    }
}

TEST(TechniqueList, ListedShadows_CanBeRequested) {
    std::map<std::string, std::vector<std::string>> ofSurface;
    for (const Manifest& surface : listSurfaces())
        ofSurface[surface.name] = offeredShadows(surface);
    const auto contains = [](const std::vector<std::string>& list, const char* value) {
        return std::find(list.begin(), list.end(), value) != list.end();
    };
    for (const Manifest& info : listTechniques())
        for (const std::string& surface : surfacesFor(info, listSurfaces()))
            for (const char* shadow : {"relief", "none", "map"}) {
                const std::string name = info.name + "@" + surface + ":shadow=" + shadow;
                if (contains(offeredShadows(info), shadow) && contains(ofSurface.at(surface), shadow))
                    EXPECT_NO_THROW(nameOf(name)) << name;
                else
                    EXPECT_THROW(nameOf(name), InputError) << name;
            }
}

TEST(Settings, KnownSettings_AreSearchsSurfacesAndHarnesss) {
    EXPECT_THAT(resolveTechnique("linear_binary").settingNames(),
                ElementsAre("binary_steps", "depth_correction", "early_exit", "filter", "linear_steps",
                            "shadow", "shadow_bias", "shadow_map_bias", "shadow_map_size", "steps",
                            "tolerance", "triangle_bounds"));
    EXPECT_THAT(resolveTechnique("linear_binary@quadric").settingNames(),
                ElementsAre("binary_steps", "coefficients", "depth_correction", "early_exit", "filter",
                            "linear_steps", "shadow", "shadow_bias", "shadow_map_bias", "shadow_map_size",
                            "steps", "tolerance", "triangle_bounds"));
    EXPECT_TRUE(resolveTechnique("micro_triangles").settingNames().empty());
}

TEST(Settings, Shadows_AreCommonOnesAndMap) {
    EXPECT_EQ(nameOf("linear_binary:shadow=relief"), "linear_binary");
    EXPECT_EQ(nameOf("linear_binary:shadow=map"), "linear_binary:shadow=map");
    EXPECT_EQ(nameOf("linear_binary@quadric:shadow=none"), "linear_binary@quadric");
    EXPECT_EQ(nameOf("linear_binary@quadric:shadow=map"), "linear_binary@quadric:shadow=map");
    EXPECT_EQ(messageOf<InputError>([] { nameOf("linear_binary@quadric:shadow=relief"); }),
              "linear_binary@quadric: shadow = 'relief'; expected none or map");
}

TEST(Settings, BadSetting_MessageNamesChoices) {
    const auto message = [](const std::string& text) { return messageOf<InputError>([&] { nameOf(text); }); };
    EXPECT_EQ(message("linear_binary:linear_stepz=3"),
              "linear_binary: has no parameter 'linear_stepz'; expected binary_steps, depth_correction, "
              "early_exit, filter, linear_steps, shadow, shadow_bias, shadow_map_bias, shadow_map_size, "
              "steps, tolerance or triangle_bounds; did you mean 'linear_steps'?");
    EXPECT_EQ(message("linear_binary:linear_steps=0"),
              "linear_binary: linear_steps = '0'; expected a whole number from 1 to 4096");
    EXPECT_THAT(message("linear_binary:linear_steps=2.5"), HasSubstr("expected a whole number"));
    EXPECT_THAT(message("linear_binary:linear_steps=99999999999999999999"),
                HasSubstr("expected a whole number"));
    EXPECT_THAT(message("linear_binary:shadow_bias=nan"), HasSubstr("expected a number from 0 to 1"));
    EXPECT_THAT(message("linear_binary:filter=hardwear"), HasSubstr("did you mean 'hardware'?"));
    EXPECT_THAT(message("linear_binary@quadric:shadow=relief"), HasSubstr("expected none"));
    EXPECT_THAT(message("linear_binery"), HasSubstr("did you mean 'linear_binary'?"));
    EXPECT_THAT(message("linear_binary@quadrik"), HasSubstr("did you mean 'quadric'?"));
    EXPECT_THAT(message("micro_triangles@quadric"), HasSubstr("has no surface 'quadric'; expected flat"));
    EXPECT_THAT(message("./no/such/folder"), HasSubstr("no folder"));
}

// --- manifests of a user -------------------------------------------------------------------------

constexpr const char* kGood = "title = 'Mine'\n"
                              "citation = 'me'\n"
                              "inputs = ['height']\n"
                              "needs = []\n"
                              "limits = []\n";
constexpr const char* kParameter = "[[parameter]]\n"
                                   "name = 'steps'\n"
                                   "type = 'int'\n"
                                   "default = 3\n"
                                   "range = [1, 9]\n"
                                   "unit = 'steps'\n"
                                   "meaning = 'how many'\n";
constexpr const char* kShader =
    "// steps: not a use\n"
    "ReliefHit traceRelief(ReliefRay ray) { return hitAt(ray, 1.0 / float(steps)); }\n";

/// The error message for a manifest in the folder "mine"; empty if it is valid.
std::string manifestMessage(const std::string& toml, const std::string& shader = kShader) {
    const TemporaryFolder folder;
    writeFile(folder / "mine/technique.toml", toml);
    writeFile(folder / "mine/mine.glsl", shader);
    const std::string message = messageOf<InputError>([&] { nameOf((folder.path() / "mine").string()); });
    const size_t at = message.find("technique.toml");
    return at == std::string::npos ? message : message.substr(at);
}

TEST(Manifest, ValidManifest_IsReadInFull) {
    EXPECT_EQ(manifestMessage(std::string(kGood) + kParameter), "");
    EXPECT_EQ(manifestMessage(kGood), "");
}

/// `kGood` and `kParameter` with one text fragment replaced.
std::string with(const std::string& old, const std::string& replacement) {
    std::string toml = std::string(kGood) + kParameter;
    const size_t at = toml.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return toml.replace(at, old.size(), replacement);
}

TEST(Manifest, Mistakes_NameTheirLine) {
    EXPECT_EQ(manifestMessage(with("title = 'Mine'\n", "titel = 'Mine'\n")),
              "technique.toml:1: title: is missing; expected a single-line string");
    EXPECT_EQ(
        manifestMessage(with("limits = []", "limits = []\nlimit = []")),
        "technique.toml:6: limit: unknown field; expected channels, citation, geometry, inputs, limits, "
        "needs, parameter, shader, shadows or title; did you mean 'limits'?");
    EXPECT_THAT(manifestMessage(with("['height']", "[\n'hight']")),
                AllOf(StartsWith("technique.toml:4: inputs: holds the string \"hight\"; expected height"),
                      EndsWith("did you mean 'height'?")));
    EXPECT_EQ(manifestMessage(with("needs = []", "needs = 'linear_st'")),
              "technique.toml:4: needs: is the string \"linear_st\"; expected an array of strings");
    EXPECT_EQ(manifestMessage(with("needs = []", "needs = ['linear_st', 'linear_st']")),
              "technique.toml:4: needs: holds \"linear_st\" twice; expected each once");
    EXPECT_THAT(manifestMessage(with("needs = []", "needs = ['linear_stt']")),
                HasSubstr("did you mean 'linear_st'?"));
    EXPECT_EQ(manifestMessage(with("limits = []", "limits = []\nshadows = []")),
              "technique.toml:6: shadows: is empty; expected relief or none");
    EXPECT_EQ(manifestMessage(with("'me'", "7")),
              "technique.toml:2: citation: is 7; expected a string in quotes");
    EXPECT_THAT(manifestMessage(std::string(kGood) + "geometry = 'proxie'"),
                HasSubstr("did you mean 'proxy'?"));
    EXPECT_THAT(manifestMessage(std::string(kGood) + "channels = ['Q']"),
                HasSubstr("channels: holds the string \"Q\""));
    EXPECT_THAT(manifestMessage(std::string(kGood) + "channels = ['Z']"), HasSubstr("neither A nor id"));
    EXPECT_EQ(manifestMessage(std::string(kGood) + "channels = ['id', 'Z']"), "");
    EXPECT_THAT(manifestMessage("title = "), HasSubstr("technique.toml:1: "));
    EXPECT_THAT(manifestMessage("\xff\xfe"), HasSubstr("technique.toml:1: "));
}

TEST(Manifest, ParameterMistakes_NameTheirLine) {
    EXPECT_EQ(
        manifestMessage(with("'int'", "'integer'")),
        "technique.toml:8: parameter.type: is the string \"integer\"; expected int, float, bool or choice");
    EXPECT_EQ(manifestMessage(with("default = 3", "default = 30")),
              "technique.toml:9: parameter.default: is 30; expected a whole number from 1 to 9");
    EXPECT_EQ(
        manifestMessage(with("default = 3", "default = '3'")),
        "technique.toml:9: parameter.default: is the string \"3\"; expected a whole number from 1 to 9");
    EXPECT_EQ(manifestMessage(with("default = 3", "default = 3.0")),
              "technique.toml:9: parameter.default: is 3.0; expected a whole number from 1 to 9");
    EXPECT_EQ(manifestMessage(with("[1, 9]", "[9, 1]")),
              "technique.toml:10: parameter.range: [9, 1] is empty; expected [lowest, highest]");
    EXPECT_EQ(manifestMessage(with("[1, 9]", "[1, inf]")),
              "technique.toml:10: parameter.range: is inf; expected a whole number from -2147483647 to "
              "2147483647");
    EXPECT_EQ(manifestMessage(with("unit = 'steps'", "units = 'steps'")),
              "technique.toml:6: parameter.unit: is missing; expected a string");
    EXPECT_THAT(manifestMessage(with("'steps'", "'shadow'")),
                HasSubstr("technique.toml:7: parameter.name: 'shadow' is used by the harness"));
    EXPECT_THAT(manifestMessage(with("'steps'", "'float'")), HasSubstr("is reserved in GLSL"));
    EXPECT_THAT(manifestMessage(with("'steps'", "'a b'")), HasSubstr("can't be a GLSL name"));
    EXPECT_THAT(manifestMessage(with("'steps'", "'gl_x'")), HasSubstr("can't be a GLSL name"));
    for (const char* name : {"kAmbient", "uHeightMap", "outColor", "gIterations", "cone_step", "ReliefWalk",
                             "bufferDepth", "verticalDescent", "shadow_map_bias"})
        EXPECT_THAT(manifestMessage(with("'steps'", "'" + std::string(name) + "'")),
                    HasSubstr("is used by the harness"));
    EXPECT_THAT(manifestMessage(std::string(kGood) + kParameter + kParameter),
                HasSubstr("technique.toml:14: parameter.name: 'steps' is declared twice"));
    EXPECT_THAT(manifestMessage(std::string(kGood) +
                                "[[parameter]]\nname='f'\ntype='float'\ndefault=1\nrange=[0, 1e300]\n"
                                "unit=''\nmeaning='m'\n"),
                HasSubstr("parameter.range: is 1e+300; expected a number from"));
}

/// The error message for a technique with these needs on a surface; empty if they are compatible.
std::string compositionMessage(const std::string& needs, const std::string& surface) {
    const TemporaryFolder folder;
    writeFile(folder / "mine/technique.toml", with("needs = []", "needs = [" + needs + "]"));
    writeFile(folder / "mine/mine.glsl", kShader);
    return messageOf<InputError>([&] { nameOf((folder.path() / "mine").string() + "@" + surface); });
}

TEST(Composition, SurfaceLackingANeed_IsRefusedWithReason) {
    EXPECT_THAT(
        compositionMessage("'bounded_descent', 'linear_st'", "quadric_nearest"),
        EndsWith(
            "/mine' has no surface 'quadric_nearest': the search needs linear_st (texture coordinates that "
            "are linear along the ray) and bounded_descent (a bound on the ray's descent), which the "
            "surface doesn't offer; expected flat, quadric or quadric_full"));
    EXPECT_THAT(compositionMessage("'flat_base'", "quadric"), EndsWith("expected flat"));
    EXPECT_EQ(compositionMessage("'bounded_descent', 'linear_st'", "quadric_full"), "");
    for (const std::string& surface : surfaceNames())
        EXPECT_EQ(compositionMessage("", surface), "") << surface;
}

TEST(Composition, UndeclaredNeed_IsRefused) {
    const auto message = [](const std::string& needs, const std::string& call) {
        return manifestMessage(with("needs = []", "needs = [" + needs + "]"),
                               std::string(kShader) + "// call: " + call + "\nfloat f() { return " + call +
                                   "; }");
    };
    EXPECT_EQ(message("", "steepestDescent(ray, 0.0)"),
              "technique.toml:4: needs: lacks bounded_descent, which mine.glsl relies on by calling "
              "steepestDescent; expected \"bounded_descent\" among them");
    EXPECT_EQ(message("'bounded_descent'", "steepestDescent(ray, 0.0)"), "");
    EXPECT_THAT(message("'polynomial_depth'", "beginWalk(ray)"), HasSubstr("lacks linear_st"));
    EXPECT_THAT(message("'linear_st'", "hitInCell(ray)"), HasSubstr("lacks polynomial_depth"));
    EXPECT_EQ(message("", "mySteepestDescent(ray, 0.0)"), "");
}

TEST(Composition, OfferedBound_IsDefinedByShader) {
    for (const std::string& name : surfaceNames()) {
        const Manifest surface = readSurfaceManifest(surfacesFolder() / name);
        EXPECT_EQ(surface.hasOffer("bounded_descent"),
                  namesIdentifier(readWholeFile(surface.shaderFile()), "surfaceSteepestDescent"))
            << name;
    }
}

TEST(Manifest, SurfaceManifest_NamesQuadricAndVariant) {
    const auto message = [](const std::string& inputs, const std::string& rest) {
        const TemporaryFolder folder;
        writeFile(folder / "bent/surface.toml",
                  "title = 'Bent'\ncitation = 'me'\nshadows = ['none']\nlimits = []\noffers = []\n" + inputs +
                      rest);
        writeFile(folder / "bent/bent.glsl", "// nothing");
        return messageOf<InputError>([&] {
            const Manifest manifest = readSurfaceManifest(folder.path() / "bent");
            EXPECT_TRUE(manifest.hasQuadricBase());
            EXPECT_EQ(manifest.variantOf, "quadric");
        });
    };
    const std::string variant = "variant_of = 'quadric'\n";
    EXPECT_EQ(message("inputs = ['quadric']\n", variant), "");
    EXPECT_EQ(message("inputs = ['quadric_full']\n", variant), "");
    EXPECT_THAT(message("inputs = ['quadric', 'quadric_full']\n", variant),
                HasSubstr("surface.toml:6: inputs: holds two quadrics; expected quadric or quadric_full"));
    EXPECT_THAT(message("inputs = ['quadric']\n", "variant_of = 'quadrik'\n"),
                AllOf(HasSubstr("surface.toml:7: variant_of: is the string \"quadrik\""),
                      EndsWith("did you mean 'quadric'?")));
    EXPECT_THAT(message("inputs = ['quadric']\n", "variant_of = 3\n"),
                HasSubstr("variant_of: is 3; expected flat"));
}

TEST(Manifest, NamedShader_IsReadInPlaceOfTheFoldersOwn) {
    const TemporaryFolder folder;
    const auto message = [&](const std::string& field) {
        writeFile(folder / "mine/technique.toml", kGood + field);
        return messageOf<InputError>([&] {
            const Manifest manifest = readTechniqueManifest(folder / "mine");
            EXPECT_EQ(readWholeFile(manifest.shaderFile()), kShader);
        });
    };
    writeFile(folder / "other/shared.glsl", kShader);
    EXPECT_EQ(message("shader = '../other/shared.glsl'\n"), "");
    EXPECT_THAT(message(""), EndsWith("mine.glsl: no such file"));
    EXPECT_THAT(message("shader = '../other/sharde.glsl'\n"), HasSubstr("technique.toml:6: shader: names"));
    EXPECT_THAT(message("shader = '../other'\n"), HasSubstr("which is no file; expected the path of a file"));
}

TEST(Settings, Coefficients_ChooseVertexQuadrics) {
    const auto set = [](const char* technique) { return resolveTechnique(technique).curvatureSet(); };
    EXPECT_EQ(set("linear_binary@quadric"), CurvatureSet::RingTwoTerms);
    EXPECT_EQ(set("linear_binary@quadric:coefficients=limit"), CurvatureSet::LimitTwoTerms);
    EXPECT_EQ(set("linear_binary@quadric_full"), CurvatureSet::RingThreeTerms);
    EXPECT_EQ(set("linear_binary@quadric_full:coefficients=limit"), CurvatureSet::LimitThreeTerms);
    EXPECT_EQ(nameOf("linear_binary@quadric:coefficients=limit"), "linear_binary@quadric:coefficients=limit");
    EXPECT_THAT(resolveTechnique("linear_binary").settingNames(),
                Not(Contains("coefficients"))); // no curved base
}

TEST(Manifest, ChoiceOfMapKinds_IsInput) {
    const std::string choice = "[[parameter]]\nname = 'which'\ntype = 'choice'\ndefault = 'normal'\n"
                               "choices = ['normal', 'max_mipmap']\nunit = ''\nmeaning = 'm'\n";
    const TemporaryFolder folder;
    writeFile(folder / "mine/technique.toml", with("['height']", "['height', 'which']") + choice);
    writeFile(folder / "mine/mine.glsl", std::string(kShader) + "int x() { return which; }\n");
    const auto kinds = [&](const char* settings) {
        return resolveTechnique((folder.path() / "mine").string() + settings).bakedKinds();
    };
    EXPECT_THAT(kinds(""), ElementsAre("normal"));
    EXPECT_THAT(kinds(":which=max_mipmap"), ElementsAre("max_mipmap"));
    EXPECT_THAT(manifestMessage(with("['height']", "['steps']")),
                HasSubstr("inputs: holds the string \"steps\""));
}

TEST(Manifest, TwoMapsOfOneFamily_AreRefused) {
    EXPECT_THAT(manifestMessage(with("['height']", "['height', 'cone_step', 'cone_step_relaxed']")),
                HasSubstr("takes both 'cone_step' and 'cone_step_relaxed', which belong to the same family"));
}

TEST(Manifest, UnusedParameter_IsRefused) {
    EXPECT_EQ(manifestMessage(
                  std::string(kGood) + kParameter,
                  "// steps\n/* steps */\nReliefHit traceRelief(ReliefRay ray) { return missed(); } int "
                  "my_steps, steps2;"),
              "technique.toml: parameter 'steps' doesn't occur in mine.glsl; expected a shader that uses "
              "every parameter "
              "of the manifest");
}

TEST(Manifest, DeepKeys_AreRefused) {
    const auto repeated = [](const std::string& part, size_t count) {
        std::string text;
        for (size_t i = 0; i < count; ++i)
            text += part;
        return text;
    };
    const size_t deep = 100000;
    for (const std::string& keys :
         {"[" + repeated("a.", deep) + "a]", "[[" + repeated("a.", deep) + "a]]",
          repeated("a.", deep) + "a = 1", repeated("\"a\" . ", deep) + "a = 1",
          repeated("'a.b'.", deep) + "a = 1", "a = {" + repeated("a.", deep) + "a = 1}",
          "a = " + repeated("{ a = ", deep) + "1", "a = " + repeated("[", deep) + repeated("]", deep),
          "a = " + repeated("[{ a = ", deep)}) {
        const std::string message = manifestMessage(kGood + ("\n" + keys + "\n"), kShader);
        EXPECT_THAT(message, HasSubstr("technique.toml:")) << keys.substr(0, 20);
        EXPECT_LT(message.size(), 1000u) << keys.substr(0, 20);
    }
    EXPECT_THAT(
        messageOf<InputError>([&] {
            TomlTable::parse("a.toml", "a = 1").change("--set", "a", "{" + repeated("b.", deep) + "b=1}");
        }),
        HasSubstr("more than 1000 parts"));
}

TEST(Manifest, LongShader_IsRefusedAtOnce) {
    const std::string comment(kMostShaderBytes - std::string(kShader).size() - 3, '/');
    EXPECT_EQ(manifestMessage(kGood, kShader + ("\n" + comment)), "");
    EXPECT_THAT(manifestMessage(kGood, kShader + ("\n" + comment + "////")),
                HasSubstr("bytes long; expected at most 4194304"));
}

TEST(Manifest, NonAsciiBytes_NameTheirLine) {
    EXPECT_THAT(manifestMessage(kGood, "\xef\xbb\xbf" + std::string(kShader)),
                HasSubstr("mine.glsl:1: holds the byte 0xef outside of a comment"));
    EXPECT_THAT(manifestMessage(kGood, std::string(kShader) + "\n\xe2\x80\x9c"),
                HasSubstr("mine.glsl:4: holds the byte 0xe2"));
    EXPECT_THAT(manifestMessage(kGood, std::string(kShader) + std::string(1, '\0')),
                HasSubstr("holds the byte 0x00"));
    EXPECT_EQ(
        manifestMessage(kGood, "// \xc3\xa4 /* in comments */\n/* \xe2\x80\x9c */" + std::string(kShader)),
        "");
}

TEST(Manifest, MissingFile_IsNamed) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "mine");
    const std::string path = (folder.path() / "mine").string();
    EXPECT_EQ(messageOf<InputError>([&] { nameOf(path); }),
              path + ": has no technique.toml; expected technique.toml and mine.glsl; "
                     "realtime/techniques/_template/ is "
                     "one to copy");
    writeFile(folder / "mine/technique.toml", kGood);
    EXPECT_EQ(messageOf<InputError>([&] { nameOf(path); }), path + "/mine.glsl: no such file");
}

TEST(Constants, EveryType_IsGlslConstant) {
    const TemporaryFolder folder;
    writeFile(folder / "mine/technique.toml",
              std::string(kGood) +
                  "[[parameter]]\nname='f'\ntype='float'\ndefault=3\nrange=[0,9]\nunit=''\nmeaning='m'\n"
                  "[[parameter]]\nname='b'\ntype='bool'\ndefault=true\nunit=''\nmeaning='m'\n"
                  "[[parameter]]\nname='c'\ntype='choice'\ndefault='y'\nchoices=['x','y']\nunit=''\n"
                  "meaning='m'\n");
    writeFile(folder / "mine/mine.glsl", "f b c traceRelief");
    const Technique technique = resolveTechnique((folder.path() / "mine").string() + ":f=1e-30");
    EXPECT_EQ(technique.glslConstants(), "const float f = 1.000000000e-30;\n"
                                         "const bool b = true;\n"
                                         "const int c = 1;\nconst int c_x = 0;\nconst int c_y = 1;\n");
    EXPECT_EQ(technique.name(), "mine:f=1e-30");
    EXPECT_EQ(technique.parameters().at("c"), "y");
}

} // namespace
} // namespace plumbline
