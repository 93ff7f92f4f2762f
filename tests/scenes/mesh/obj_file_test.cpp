#include "scenes/mesh/obj_file.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/scenes/mesh/obj_texts.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <random>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjFile, SeparateIndices_AreKept) {
    const ControlMesh mesh = readText(kSquare + "v 2 2 0\n"
                                                "vt 0 0\nvt 1 0\nvt 0.5 1 0\nvn 0 0 2\n"
                                                "o first\nf 1/1/1 2/2/1 3/3/1 4/1/1 5/2/1\n"
                                                "g second\nusemtl unknown\nf 1/3/1 2/1/1 3/2/1\n");
    EXPECT_THAT(mesh.faceSizes, ElementsAre(5, 3));
    EXPECT_THAT(mesh.faceVertices, ElementsAre(0, 1, 2, 3, 4, 0, 1, 2));
    EXPECT_THAT(mesh.faceUvs, ElementsAre(0, 1, 2, 0, 1, 2, 0, 1));
    EXPECT_THAT(mesh.faceNormals, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0));
    EXPECT_THAT(mesh.faceLines, ElementsAre(11, 14));
    EXPECT_EQ(mesh.points[4], Vec3(2, 2, 0));
    EXPECT_EQ(mesh.uvs[2], Vec2(0.5, 1));
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1)); // made unit
}

TEST(ObjFile, NegativeIndices_CountFromEnd) {
    const ControlMesh mesh = readText(kSquare + "f -4 -3 -2\nv 5 5 5\nf -1 1 2\n");
    EXPECT_THAT(mesh.faceVertices, ElementsAre(0, 1, 2, 4, 0, 1));
}

TEST(ObjFile, LineEndsCommentsContinuations_AreRead) {
    const std::string expected = "f 1 2 3";
    for (const char* text :
         {"v 0 0 0 # c\r\nv 1 0 0\r\nv 1 1 0\r\n\r\nf 1 2 3 # end",    // DOS, no last line end
          "\xef\xbb\xbfv 0 0 0\rv 1 0 0\rv 1 1 0\r\rf 1 2 3\r",        // old Mac, byte-order mark
          "v 0 0 0\nv 1 0 0 1.0\nv 1 1 0\n# \\\nf 1 \\\n2 \\\n3\n"}) { // joined lines, a weight
        const ControlMesh mesh = readText(text);
        EXPECT_THAT(mesh.faceVertices, ElementsAre(0, 1, 2));
        EXPECT_THAT(mesh.faceLines, ElementsAre(5));
    }
    // The line after a joined one keeps its number: f begins in line 4 and ends in line 6.
    EXPECT_EQ(messageFor("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 \\\n2 \\\n3\nf 1 2 9\n"),
              "a.obj:7: vertex index 9 is out of range; expected 1 to 3");
}

TEST(ObjFile, FacesOver255Vertices_AreRead) {
    std::string text, face = "f";
    for (int k = 0; k < 300; ++k) {
        text += fmt::format("v {} {} 0\n", std::cos(2 * kPi * k / 300), std::sin(2 * kPi * k / 300));
        face += fmt::format(" {}", k + 1);
    }
    const ControlMesh mesh = readText(text + face);
    EXPECT_THAT(mesh.faceSizes, ElementsAre(300));
    EXPECT_EQ(mesh.faceVertices.back(), 299);
}

TEST(ObjFile, Faults_NameTheirLine) {
    const std::pair<std::string, std::string> cases[] = {
        {"v 0 0 nan\n", "a.obj:1: 'nan' is not a finite number"},
        {"v 0 0 inf\n", "a.obj:1: 'inf' is not a finite number"},
        {"v 0 0 1e999\n", "a.obj:1: '1e999' is not a finite number"},
        {"v 0 0 1.2.3\n", "a.obj:1: '1.2.3' is not a finite number"},
        {"v 0 0 0x10\n", "a.obj:1: '0x10' is not a finite number"},
        {"v 0 0\n", "a.obj:1: 2 numbers for a vertex; expected 3"},
        {"vt 0\n", "a.obj:1: 1 numbers for a uv; expected 2"},
        {kSquare + "f 1 2\n", "a.obj:5: a face with 2 corners; expected 3 or more"},
        {kSquare + "f 1 2 5\n", "a.obj:5: vertex index 5 is out of range; expected 1 to 4"},
        {kSquare + "f 1 2 -5\n", "a.obj:5: vertex index -5 is out of range; expected -4 to -1 here"},
        {kSquare + "f 0 1 2\n", "a.obj:5: vertex index 0"},
        {kSquare + "f 1/1 2/1 3/1\n",
         "a.obj:5: uv index 1 is out of range; expected 1 to 0; the file has no uv"},
        {kSquare + "f 1 2 x\n", "a.obj:5: 'x' is not a corner of a face"},
        {kSquare + "f 1 2 3/\n", "a.obj:5: '3/' is not a corner of a face"},
        {kSquare + "f 1 2 3/1/\n", "a.obj:5: '3/1/' is not a corner of a face"},
        {kSquare + "f 1 2 99999999999999999999\n", "is not a corner of a face"},
        {kSquare + "vt 0 0\nf 1/1 2/1 3\n",
         "a.obj:6: corners '1/1' and '3' of one face have different kinds"},
        {kSquare + "f 1 2 2\n", "a.obj:5: face 1 names vertex 2 twice: and no other face is left"},
        {kSquare + "surf 0 1 0 1 1\n", "a.obj:5: 'surf' is not supported"},
        {kSquare, "a.obj: has no face"},
        {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "no area"},
        {"", "a.obj: is empty"},
        {std::string("v 0 0 0\n\0\1", 10), "a.obj:2: a byte that is not text: zero"},
        {"v 0 0 0\ng \1\n", "a.obj:2: a byte that is not text"},
    };
    for (const auto& [text, message] : cases)
        EXPECT_THAT(messageFor(text), HasSubstr(message)) << text;
    EXPECT_THAT(inputErrorOf([] { readObj("/nonexistent/a.obj"); }), HasSubstr("no such file"));
    EXPECT_THAT(inputErrorOf([] { readObj("/"); }), HasSubstr("is not a file"));
}

TEST(ObjFile, SubdivisionTags_AreKept) {
    // Vertices and faces of `t` lines count from 0. Tags may precede the elements that they refer to.
    const ControlMesh mesh =
        readText("t crease 2/1/0 0 1 2.5\n" + kSquare + "f 1 2 3 4\n" +
                 "t crease 3/2/0 1 2 3 1 +2e0\n"
                 "t corner 2/1/0 0 2 10\nt hole 1/0/0 0\n"
                 "t interpolateboundary 1/0/0 2\nt creasemethod 0/0/1 normal\n"
                 "t facevaryinginterpolateboundary 1/0/0 1\nt smoothtriangles 1/0/0 0\n");
    const auto& creases = mesh.tags.creases;
    ASSERT_EQ(creases.size(), 3u);
    const double sharpness[] = {2.5, 1, 2};
    const int lines[] = {1, 7, 7};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(creases[size_t(i)].from, i);
        EXPECT_EQ(creases[size_t(i)].to, i + 1);
        EXPECT_EQ(creases[size_t(i)].sharpness, sharpness[i]);
        EXPECT_EQ(creases[size_t(i)].line, lines[i]);
    }
    ASSERT_EQ(mesh.tags.corners.size(), 2u);
    EXPECT_EQ(mesh.tags.corners[1].vertex, 2);
    EXPECT_EQ(mesh.tags.corners[1].sharpness, 10);
    ASSERT_EQ(mesh.tags.holes.size(), 1u);
    EXPECT_EQ(mesh.tags.holes[0].face, 0);
    EXPECT_TRUE(mesh.tags.boundaryCornersRound);
    EXPECT_FALSE(mesh.boundaryFacesSupportOnly);
    ASSERT_EQ(mesh.warnings.size(), 1u);
    EXPECT_THAT(mesh.warnings[0], HasSubstr("a.obj:12: facevaryinginterpolateboundary is ignored"));
    EXPECT_TRUE(readText(kSquare + "f 1 2 3 4\nt interpolateboundary 1/0/0 0\n").boundaryFacesSupportOnly);
    EXPECT_FALSE(readText(kSquare + "f 1 2 3 4\nt interpolateboundary 1/0/0 1\n").tags.boundaryCornersRound);
}

TEST(ObjFile, FaultyTags_NameTheirLine) {
    const std::string square = kSquare + "f 1 2 3 4\n";
    const std::pair<std::string, std::string> cases[] = {
        {"t", "a.obj:6: a subdivision tag without its counts; expected t crease 2/1/0 …"},
        {"t crease", "a.obj:6: a subdivision tag without its counts"},
        {"t crease 2/1 0 1 2", "a.obj:6: '2/1' in a subdivision tag; expected how many"},
        {"t crease -2/1/0 0 1 2", "a.obj:6: '-2' in a subdivision tag"},
        {"t crease 2/1/0 0 1", "a.obj:6: 2 values follow 2/1/0 in a subdivision tag; expected as many"},
        {"t crease 18446744073709551615/4/0 0 1 2", "3 values follow 18446744073709551615/4/0"},
        {"t crease 2/1/0 0 x 2", "a.obj:6: 'x' in a subdivision tag; expected a whole number"},
        {"t crease 2/1/0 0 1 two", "a.obj:6: 'two' in a subdivision tag; expected a finite number"},
        {"t crease 2/1/0 0 1 nan", "a.obj:6: 'nan' in a subdivision tag; expected a finite number"},
        {"t crease 2/1/0 0 1 inf", "a.obj:6: 'inf' in a subdivision tag"},
        {"t crease 2/1/0 0 1 -1", "a.obj:6: sharpness -1"},
        {"t crease 1/1/0 0 1",
         "a.obj:6: crease with 1 whole numbers, 1 numbers and 0 words; expected two vertices"},
        {"t crease 3/3/0 0 1 2 1 1 1", "a.obj:6: crease with 3 whole numbers, 3 numbers"},
        {"t crease 2/1/0 0 4 1",
         "a.obj:6: vertex 5 isn't in the mesh; expected 1 to 4 (0 to 3 in 't' lines)"},
        {"t crease 2/1/0 -1 0 1", "a.obj:6: vertex 0 isn't in the mesh"},
        {"t crease 2/1/0 0 2 1", "a.obj:6: no face has an edge from vertex 1 to 3"},
        {"t crease 2/1/0 1 1 1", "a.obj:6: no face has an edge from vertex 2 to 2"},
        {"t crease 2/1/0 0 1 1\nt crease 2/1/0 1 0 2",
         "a.obj:7: the edge from vertex 2 to 1 has sharpness 1 and 2; expected one"},
        {"t corner 1/1/0 4 1", "a.obj:6: vertex 5 isn't in the mesh"},
        {"t corner 1/1/0 3 -0.5", "a.obj:6: sharpness -0.5"},
        {"t corner 1/0/0 3", "a.obj:6: corner with 1 whole numbers, 0 numbers"},
        {"t corner 2/2/0 3 3 1 2", "a.obj:6: vertex 4 has sharpness 1 and 2; expected one"},
        {"t hole 1/0/0 1", "a.obj:6: face 2 isn't in the mesh; expected 1 to 1 (0 to 0 in 't' lines)"},
        {"t hole 0/1/0 1", "a.obj:6: hole with 0 whole numbers"},
        {"t interpolateboundary 1/0/0 3", "a.obj:6: interpolateboundary 3; expected 0 (faces"},
        {"t interpolateboundary 0/0/0", "expected one whole number"},
        {"t creasemethod 0/0/1 chaikin", "a.obj:6: creasemethod 'chaikin' is not supported; expected normal"},
        {"t smoothtriangles 1/0/0 1", "a.obj:6: smoothtriangles '1' is not supported"},
        {"t vertexedit 1/0/0 1",
         "a.obj:6: subdivision tag 'vertexedit' is not supported; expected crease, corner,"},
        {"t creese 2/1/0 0 1 2", "did you mean 'crease'?"},
    };
    for (const auto& [tag, message] : cases)
        EXPECT_THAT(messageFor(square + tag + "\n"), HasSubstr(message)) << tag;
}

TEST(ObjFile, RepeatedTags_AreRead) {
    EXPECT_NO_THROW(readText(
        kSquare + "f 1 2 3 4\nt crease 2/1/0 0 1 2\nt crease 3/1/0 2 1 0 2\nt corner 2/1/0 3 3 1\n"));
}

TEST(ObjFile, PartialUvs_CountAsNoneWithReason) {
    const ControlMesh mesh = readText(kSquare + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1//1 3//1 4//1\n");
    EXPECT_FALSE(mesh.hasUvs());
    EXPECT_EQ(mesh.uvsMissing, "the face in line 8 has no uv indices, though others have");
    EXPECT_TRUE(mesh.hasNormals());
    EXPECT_EQ(readText(kSquare + "f 1 2 3\n").uvsMissing, "");
}

std::string smallObj() {
    return kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n# a comment\nf 1/1/1 2/2/1 3/3/1\nf -4/-3/-1 "
                     "-2/-2/-1 -1/-1/-1\n";
}

TEST(ObjFile, TruncatedAnywhere_IsReadOrRefused) {
    const std::string whole = smallObj();
    for (size_t length = 0; length <= whole.size(); ++length) {
        const bool read = worksOrIsRefused([&] { readText(whole.substr(0, length)); });
        EXPECT_EQ(read, length >= whole.find("3/3/1") + 5 &&
                            (length <= whole.find("f -4") || length + 1 >= whole.size()))
            << length; // only after a complete face, or within the second one's last digit or line ending
    }
}

TEST(ObjFile, DamagedAnywhere_IsReadOrRefused) {
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i) {
        std::string text = smallObj() + "t crease 2/1/0 0 1 2.5\nt corner 1/1/0 2 10\nt hole 1/0/0 0\n";
        for (int changes = 0; changes < 3; ++changes)
            text[random() % text.size()] = static_cast<char>(random());
        worksOrIsRefused([&] {
            const ControlMesh mesh = readText(text);
            checkControlMesh(mesh, Scheme::CatmullClark);
        });
    }
}

RC_GTEST_PROP(ObjFileProperty, WrittenNumbers_ReadBackEqual, ()) {
    const double x =
        static_cast<double>(*rc::gen::arbitrary<int64_t>()) * std::pow(10.0, *rc::gen::inRange(-25, -6));
    const ControlMesh mesh = readText(fmt::format("v {:.17g} 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", x));
    RC_ASSERT(mesh.points[0].x == x);
}

TEST(ObjFile, Spot_HasItsCounts) {
    const std::filesystem::path file = std::filesystem::path(PLUMBLINE_SHARED_DATA) / "spot_control_mesh.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
    const ControlMesh mesh = readObj(file);
    // Counted by its publisher: 160 quads, 16 pentagons, 4 triangles.
    EXPECT_EQ(std::count(mesh.faceSizes.begin(), mesh.faceSizes.end(), 4), 160);
    EXPECT_EQ(std::count(mesh.faceSizes.begin(), mesh.faceSizes.end(), 5), 16);
    EXPECT_EQ(std::count(mesh.faceSizes.begin(), mesh.faceSizes.end(), 3), 4);
    EXPECT_EQ(mesh.faceUvs.size(), 160u * 4 + 16 * 5 + 4 * 3);
    EXPECT_GT(mesh.uvs.size(), mesh.points.size()); // it has seams
    // Closed: V - E + F = 2 with every edge in two faces.
    EXPECT_EQ(mesh.points.size() + mesh.faceSizes.size() - mesh.faceVertices.size() / 2, 2u);
}

} // namespace
} // namespace plumbline
