// OBJ texts as other programs write them: numbers, line ends, what stands at the end, unknown keywords.
#include "tests/scenes/mesh/obj_texts.h"

#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
const std::string kFace = "f 1 2 3\n";

TEST(ObjText, Numbers_AreReadOrRefusedWithTheirLine) {
    const std::pair<const char*, double> good[] = {
        {"1", 1},      {"+1", 1},    {"-1", -1},    {"1.", 1},          {".5", 0.5},
        {"-.5", -0.5}, {"+.5e1", 5}, {"1e3", 1000}, {"1E+3", 1000},     {"1e-3", 1e-3},
        {"007", 7},    {"-0", 0},    {"0e999", 0},  {"5e-324", 5e-324}, {"1e-310", 1e-310}};
    for (const auto& [text, value] : good)
        EXPECT_EQ(readText(fmt::format("v {} 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3", text)).points[0].x, value)
            << text;
    for (const char* text :
         {"+-1",   "-+1",    "++1",    "--1",     "+",         "-",        ".",           "e1",     "1e",
          "1e+",   "1e-400", "1E-400", "-1e-400", "1e-400xyz", "1e400",    "1e400e-5",    "1e999",  "0x10",
          "0x1p3", "nan",    "NaN",    "-nan",    "inf",       "+inf",     "infinity",    "1.#IND", "1.2.3",
          "1,5",   "1f",     "1d5",    "1_000",   "1/2",       "\xd9\xa1", "\xef\xbc\x91"})
        EXPECT_THAT(messageFor(fmt::format("v 0 0 0\nv 0 {} 0\n", text)), HasSubstr("a.obj:2: '")) << text;
}

TEST(ObjText, Indices_AreReadOrRefusedWithTheirLine) {
    EXPECT_THAT(readText(kTriangle + "f +1 02 -1\n").faceVertices, ElementsAre(0, 1, 2));
    for (const char* text : {"+-1", "-+1", "++1", "1.0", "1e0", "0x1", "1x", "1//", "1/+-1", "1//+-1", "/1"})
        EXPECT_THAT(messageFor(kTriangle + fmt::format("f {} 2 3\n", text)),
                    HasSubstr("is not a corner of a face"))
            << text;
    for (const char* tag : {"t crease 2/1/0 0 +-1 2", "t crease 2/1/0 0 1 +-2", "t crease +-2/1/0 0 1 2"})
        EXPECT_THAT(messageFor(kTriangle + kFace + tag + "\n"), HasSubstr("a.obj:5: '+-")) << tag;
}

RC_GTEST_PROP(ObjTextProperty, AnyWord_IsANumberInWholeOrRefused, ()) {
    const auto characters = rc::gen::elementOf(std::string("+-.eE0123459xn,"));
    const auto word = *rc::gen::nonEmpty(rc::gen::container<std::string>(characters));
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end); // the C locale; also takes what isn't decimal
    try {
        const ControlMesh mesh = readText("v " + word + " 0 0\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 2 3 4\n");
        RC_ASSERT(*end == '\0' && mesh.points[0].x == value);
    } catch (const InputError&) {
        const bool decimal = *end == '\0' && word.find_first_of("xn") == word.npos;
        RC_ASSERT(!decimal || std::abs(value) > 1e15 ||
                  (value == 0 && word.find_first_of("eE") != word.npos) || std::abs(value) < 1e-300);
    }
}

TEST(ObjText, WhatStandsAtTheEnd_IsIgnored) {
    using std::string;
    for (const string& end : {string("\0", 1), string(5, '\0'), string("\x1a"), string("\x1a\0\0", 3)})
        for (const char* lastLine : {"f 1 2 3\n", "f 1 2 3\r\n", "f 1 2 3\r", "f 1 2 3"})
            EXPECT_THAT(readText(kTriangle + lastLine + end).faceVertices, ElementsAre(0, 1, 2)) << lastLine;
}

TEST(ObjText, ZeroByteElsewhere_NamesItsLine) {
    const std::string zero(1, '\0');
    const std::string message = "a byte that is not text: zero";
    EXPECT_THAT(messageFor(kTriangle + zero + kFace), HasSubstr("a.obj:4: " + message));
    EXPECT_THAT(messageFor(kTriangle + kFace + zero + "\n"), HasSubstr("a.obj:5: " + message));
    EXPECT_THAT(messageFor("# a" + zero + "b\n" + kTriangle + kFace), HasSubstr("a.obj:1: " + message));
    EXPECT_THAT(messageFor("v 0 0 0\r\nv 1 0 0\rv 1 1" + zero + " 0\n" + kFace), HasSubstr("a.obj:3: "));
    EXPECT_THAT(messageFor("g a" + zero + "\n" + kTriangle + kFace), HasSubstr("a.obj:1: " + message));
    EXPECT_THAT(messageFor("\x1a" + kTriangle + kFace), HasSubstr("a.obj:1: a byte that is not text"));
}

TEST(ObjText, BlanksCommentsNames_MayHoldAnyLetters) {
    const ControlMesh mesh = readText("# caf\xe9 \x01\n\fo T\xfcr\n" + kTriangle +
                                      "g \x83\\\nusemtl C:\\maps\\\n\v f\t1 2\v3 \f\n");
    EXPECT_THAT(mesh.faceLines, ElementsAre(8)); // the backslashes belong to names and join no lines
    EXPECT_THAT(mesh.warnings, IsEmpty());
    EXPECT_THAT(readText(kTriangle + "g a \\\nb\nf 1 2 3\n").faceLines, ElementsAre(6));
}

TEST(ObjText, UnknownKeywords_AreWarnedOfOnce) {
    const ControlMesh mesh = readText("#VRML\nsolid x\nfacet 1\nfacet 2\n" + kTriangle + kFace + "F 1 2 3\n");
    ASSERT_EQ(mesh.warnings.size(), 3u);
    EXPECT_THAT(mesh.warnings[0], HasSubstr("a.obj:2: unknown keyword 'solid': the line is left out"));
    EXPECT_THAT(mesh.warnings[1], HasSubstr("a.obj:3: unknown keyword 'facet': 2 lines are left out"));
    EXPECT_THAT(mesh.warnings[2], HasSubstr("a.obj:9: unknown keyword 'F': the line is left out"));
    std::string many = kTriangle + kFace;
    for (int k = 0; k < 100; ++k)
        many += fmt::format("word{} x\n", k);
    const ControlMesh prose = readText(many);
    ASSERT_EQ(prose.warnings.size(), 11u);
    EXPECT_THAT(prose.warnings[10], HasSubstr("a.obj: lines of 90 more unknown keywords are left out"));
    EXPECT_THAT(messageFor("only prose\n"), HasSubstr("has no face"));
}

TEST(ObjText, BadNormalIndices_LeaveTheMeshWithoutNormals) {
    const std::pair<const char*, const char*> cases[] = {
        {"f 1//1 2//1 3//2\n", "the face in line 5 has the normal index 2, which is out of range"},
        {"f 1//1 2//0 3//1\n", "the face in line 5 has the normal index 0, which is out of range"},
        {"f 1//1 2//-2 3//1\n", "the face in line 5 has the normal index -2, which is out of range"},
        {"f 1//1 2//99999999999 3//1\n", "index 99999999999, which is out of range"}};
    for (const auto& [face, reason] : cases) {
        const ControlMesh mesh = readText(kTriangle + "vn 0 0 1\n" + face);
        EXPECT_THAT(mesh.faceVertices, ElementsAre(0, 1, 2));
        EXPECT_FALSE(mesh.hasNormals()) << face;
        EXPECT_THAT(mesh.normalsMissing, HasSubstr(reason)) << face; // scheme "none" refuses it
    }
    EXPECT_TRUE(readText(kTriangle + "f 1//1 2//1 3//1\nvn 0 0 1\n").hasNormals()); // defined after its use
}

TEST(ObjText, SmoothTriangles_AreTakenByTheirWord) {
    for (const char* value : {"0/0/1 catmark", "1/0/0 0"})
        EXPECT_NO_THROW(readText(kTriangle + kFace + "t smoothtriangles " + value + "\n")) << value;
    EXPECT_THAT(messageFor(kTriangle + kFace + "t smoothtriangles 0/0/1 smooth\n"),
                HasSubstr("a.obj:5: smoothtriangles 'smooth' is not supported; expected catmark"));
    for (const char* value : {"0/0/0", "0/1/0 1", "1/0/1 0 catmark", "0/0/2 catmark smooth"})
        EXPECT_THAT(messageFor(kTriangle + kFace + "t smoothtriangles " + value + "\n"),
                    HasSubstr("expected one word: catmark"))
            << value;
}

} // namespace
} // namespace plumbline
