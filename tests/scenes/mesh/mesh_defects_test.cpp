#include "scenes/mesh/mesh_defects.h"
#include "scenes/surface/base_surface.h"
#include "tests/errors.h"
#include "tests/scenes/mesh/test_meshes.h"

#include <gmock/gmock.h>
#include <numeric>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> warningsOf(const ControlMesh& mesh, Scheme scheme = Scheme::CatmullClark) {
    checkControlMesh(mesh, scheme);
    return meshWarnings(mesh, scheme);
}

Vec3 limitAt(const ControlMesh& mesh, int patch, double u, double v) {
    const BaseSurface surface(mesh, Scheme::CatmullClark);
    BaseSurface::Evaluator evaluator(surface);
    evaluator.setPatch(patch);
    return evaluator.point(u, v).position;
}

void reverseFace(ControlMesh& mesh, int face) { // of a mesh of quads
    std::swap(mesh.faceVertices[size_t(4 * face + 1)], mesh.faceVertices[size_t(4 * face + 3)]);
}

/// `mesh` with a translated and scaled copy.
ControlMesh withSecondShell(ControlMesh mesh, const Vec3& offset, double scale) {
    const ControlMesh first = mesh;
    const int vertices = static_cast<int>(first.points.size());
    for (const Vec3& point : first.points)
        mesh.points.push_back(scale * point + offset);
    mesh.faceSizes.insert(mesh.faceSizes.end(), first.faceSizes.begin(), first.faceSizes.end());
    for (const int vertex : first.faceVertices)
        mesh.faceVertices.push_back(vertices + vertex);
    return mesh;
}

TEST(MeshDefects, CleanMesh_HasNoWarning) {
    for (const ControlMesh& mesh : {cubeMesh(), bumpyGrid(4), fanMesh(64), prismMesh(5),
                                    withSecondShell(cubeMesh(), Vec3(5, 0, 0), 1), triangulated(cubeMesh())})
        for (const Scheme scheme : {Scheme::CatmullClark, Scheme::None})
            EXPECT_THAT(warningsOf(mesh, scheme), IsEmpty()) << mesh.name;
}

TEST(MeshDefects, ThreeFacesOnAnEdge_Warns) {
    ControlMesh mesh = bumpyGrid(5); // with a fin on its edges from vertex 10 to 14
    for (int i = 0; i < 5; ++i)
        mesh.points.push_back(Vec3(i, 3 + 0.1 * i, -2));
    for (int i = 0; i < 4; ++i)
        addFace(mesh, {10 + i, 11 + i, 26 + i, 25 + i});
    mesh.faceLines.resize(20);
    std::iota(mesh.faceLines.begin(), mesh.faceLines.end(), 101);
    EXPECT_THAT(
        warningsOf(mesh),
        ElementsAre(
            "grid:117: face 17 is one of 3 faces on the edge from vertex 11 to 12: no surface continues "
            "there, the edge is made infinitely sharp (and 3 more)"));
    EXPECT_THAT(warningsOf(mesh, Scheme::None), ElementsAre(HasSubstr("normals are the mean of all")));
    // As the warning states, the edge is infinitely sharp: its limit curve is the cubic B-spline of the
    // vertices, at a vertex (a + 4 b + c) / 6.
    const auto& p = mesh.points;
    const Vec3 onCrease = (p[11] + 4.0 * p[12] + p[13]) / 6.0;
    EXPECT_LT(glm::length(limitAt(mesh, 5, 1, 1) - onCrease), 1e-14);
    EXPECT_LT(glm::length(limitAt(mesh, 17, 1, 0) - onCrease), 1e-14);
}

TEST(MeshDefects, EqualEdgeDirections_Warn) {
    ControlMesh mesh = bumpyGrid(5);
    for (int face = 8; face < 16; ++face)
        reverseFace(mesh, face);
    EXPECT_THAT(
        warningsOf(mesh),
        ElementsAre(
            "grid: face 9 and face 5 run along the edge from vertex 11 to 12 in the same direction: one "
            "of them is inside out, the edge is made infinitely sharp and its ends corners (and 3 "
            "more)"));
    EXPECT_LT(glm::length(limitAt(mesh, 5, 1, 1) - mesh.points[12]), 1e-14); // a corner: the vertex itself
    EXPECT_THAT(warningsOf(mesh, Scheme::None),
                ElementsAre(testing::EndsWith(": one of them is inside out (and 3 more)")));
}

TEST(MeshDefects, FacesSharingOneVertex_Warn) {
    ControlMesh mesh = bumpyGrid(5);
    for (const Vec3& point : {Vec3(3, 5, -2), Vec3(3, 5, -3), Vec3(2, 5, -3)})
        mesh.points.push_back(point);
    addFace(mesh, {12, 25, 26, 27});
    EXPECT_THAT(warningsOf(mesh),
                ElementsAre("grid: vertex 13 joins faces that share no edge there: it is made a corner"));
    EXPECT_LT(glm::length(limitAt(mesh, 5, 1, 1) - mesh.points[12]), 1e-14);
}

TEST(MeshDefects, FacesWithoutArea_Warn) {
    ControlMesh mesh = cubeMesh();
    mesh.points[1] = mesh.points[0];
    EXPECT_THAT(
        warningsOf(mesh),
        ElementsAre("cube: face 1 has coincident vertices: it is subdivided as if they were two (and 1 "
                    "more)"));
    mesh.points[5] = mesh.points[4]; // face 3 (0 1 5 4) is a line now; the other two still share the edges
    EXPECT_THAT(warningsOf(mesh), ElementsAre("cube: face 3 has no area: it still shapes the limit surface",
                                              HasSubstr("face 1 has coincident vertices")));
    EXPECT_THAT(warningsOf(mesh, Scheme::None), ElementsAre("cube: face 3 has no area: it is invisible",
                                                            HasSubstr("normals vary abruptly there")));
    // A self-intersecting face has area on both sides of the intersection, although its area vector is zero.
    ControlMesh crossed;
    crossed.name = "crossed";
    crossed.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}};
    addFace(crossed, {0, 1, 2, 3});
    addFace(crossed, {1, 4, 5, 3});
    EXPECT_THAT(warningsOf(crossed), Not(testing::Contains(HasSubstr("no area"))));
}

TEST(MeshDefects, InwardShells_Warn) {
    ControlMesh mesh = cubeMesh();
    for (int face = 0; face < 6; ++face)
        reverseFace(mesh, face);
    EXPECT_THAT(
        warningsOf(mesh),
        ElementsAre(
            "cube: face 1 and the rest of its closed shell of 6 point inwards (volume -8): right for a "
            "cavity, inside out otherwise; its relief is displaced the opposite way"));
    for (Vec3& point : mesh.points) // the shell's position has no effect
        point += Vec3(100, 0, 0);
    EXPECT_THAT(warningsOf(mesh), ElementsAre(HasSubstr("volume -8)")));
    ControlMesh two = withSecondShell(cubeMesh(), Vec3(0), 0.5);
    for (int face = 6; face < 12; ++face)
        reverseFace(two, face);
    EXPECT_THAT(warningsOf(two), ElementsAre(HasSubstr("face 7 and the rest of its closed shell of 6")));
    mesh.faceSizes.pop_back(); // open, so the outside is undefined
    mesh.faceVertices.resize(20);
    EXPECT_THAT(warningsOf(mesh), IsEmpty());
}

TEST(MeshDefects, UnusedVerticesAndTags_Warn) {
    ControlMesh mesh = cubeMesh();
    mesh.points.insert(mesh.points.begin(), Vec3(9));
    for (int& vertex : mesh.faceVertices)
        ++vertex;
    mesh.points.push_back(Vec3(9));
    mesh.tags.creases.push_back({1, 2, 3.0});
    mesh.warnings.push_back("cube.obj:3: of the file");
    EXPECT_THAT(warningsOf(mesh), ElementsAre("cube.obj:3: of the file",
                                              "cube: vertex 1 belongs to no face: left out (and 1 more)"));
    EXPECT_THAT(warningsOf(mesh, Scheme::None),
                testing::Contains("cube: 1 creases and corners have no effect under scheme \"none\""));
}

TEST(MeshDefects, DuplicateFace_IsRefused) {
    ControlMesh mesh = cubeMesh();
    addFace(mesh, {7, 6, 4, 5}); // face 2 with another first vertex
    EXPECT_EQ(inputErrorOf([&] { checkControlMesh(mesh, Scheme::None); }),
              "cube: face 7: has the same vertices as face 2; expected each face once");
    mesh = bumpyGrid(2);
    addFace(mesh, {1, 0, 2, 3}); // the same face with opposite orientation
    EXPECT_THAT(warningsOf(mesh), IsEmpty());
}

TEST(MeshDefects, ZeroNormals_AreRefusedUnderSchemeNone) {
    ControlMesh mesh = bumpyGrid(2);
    mesh.normals = {Vec3(0, 1, 0), Vec3(0)};
    mesh.faceNormals = {0, 0, 1, 0};
    EXPECT_NO_THROW(checkControlMesh(mesh, Scheme::CatmullClark));
    EXPECT_THAT(inputErrorOf([&] { checkControlMesh(mesh, Scheme::None); }),
                HasSubstr("grid: face 1: normal 2 is zero; expected a direction"));
}

TEST(LimitCheck, DoubletBesideSharpEdge_IsRefused) {
    // A pillow: two coincident squares with opposite orientation, so that every vertex has only two faces.
    // Valid by itself.
    ControlMesh pillow;
    pillow.name = "pillow";
    pillow.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    addFace(pillow, {0, 1, 2, 3});
    addFace(pillow, {3, 2, 1, 0});
    EXPECT_NO_THROW(BaseSurface(pillow, Scheme::CatmullClark));
    pillow.tags.creases.push_back({0, 1, 2.0});
    EXPECT_EQ(
        inputErrorOf([&] { BaseSurface(pillow, Scheme::CatmullClark); }),
        "pillow: face 1: vertex 1 has no edge beside those it shares with face 2, and a sharp edge is near; "
        "expected a mesh OpenSubdiv can evaluate there; scheme \"none\" takes it");
    EXPECT_NO_THROW(BaseSurface(pillow, Scheme::None));
    pillow.tags.creases[0].sharpness = 0; // smooth
    EXPECT_NO_THROW(BaseSurface(pillow, Scheme::CatmullClark));
}

TEST(VertexNormals, CancelingNormals_FallBackToFaces) {
    ControlMesh sheet = bumpyGrid(2);
    for (Vec3& point : sheet.points)
        point.y = 0;
    addFace(sheet, {2, 3, 1, 0}); // a double-sided sheet, whose normals cancel at every vertex
    const BaseSurface surface(sheet, Scheme::None);
    BaseSurface::Evaluator evaluator(surface);
    evaluator.setPatch(0);
    EXPECT_EQ(evaluator.point(0.3, 0.6).normal, Vec3(0, 1, 0));
    evaluator.setPatch(1);
    EXPECT_EQ(evaluator.point(0.3, 0.6).normal, Vec3(0, -1, 0));
}

} // namespace
} // namespace plumbline
