#include "scenes/mesh/control_mesh.h"
#include "scenes/scene/scene.h"
#include "tests/errors.h"

#include <gmock/gmock.h>

namespace plumbline {
namespace {

using testing::HasSubstr;

/// One quad of side 1 in the xy plane.
ControlMesh quad() {
    ControlMesh mesh;
    mesh.name = "quad";
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.faceSizes = {4};
    mesh.faceVertices = {0, 1, 2, 3};
    return mesh;
}

std::string messageFor(const ControlMesh& mesh, Scheme scheme = Scheme::CatmullClark) {
    return inputErrorOf([&] { checkControlMesh(mesh, scheme); });
}

TEST(ControlMesh, ValidMesh_Passes) {
    EXPECT_NO_THROW(checkControlMesh(quad(), Scheme::CatmullClark));
    EXPECT_NO_THROW(checkControlMesh(quad(), Scheme::None));
}

TEST(ControlMesh, InvalidMesh_NamesFault) {
    ControlMesh mesh = quad();
    mesh.faceVertices[2] = 4;
    EXPECT_EQ(messageFor(mesh), "quad: face 1: vertex index 5 is out of range; expected 1 to 4");
    mesh.faceVertices[2] = -1;
    EXPECT_THAT(messageFor(mesh), HasSubstr("vertex index 0 is out of range"));
    mesh.faceVertices[2] = 1;
    mesh.faceLines = {12};
    EXPECT_EQ(messageFor(mesh),
              "quad:12: face 1: vertex 2 occurs twice in the face; expected distinct vertices");

    mesh = quad();
    mesh.points[3].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(messageFor(mesh), "quad: vertex 4 has the coordinate nan; expected finite numbers up to 1e15");
    mesh.points[3].y = 1e16;
    EXPECT_THAT(messageFor(mesh), HasSubstr("1e+16"));

    mesh = quad();
    mesh.faceSizes = {2, 2};
    EXPECT_THAT(messageFor(mesh), HasSubstr("face 1 has 2 vertices"));
    mesh.faceSizes = {3};
    EXPECT_THAT(messageFor(mesh), HasSubstr("4 vertex indices for 3 face corners"));

    mesh = quad();
    mesh.uvs = {{0, 0}};
    mesh.faceUvs = {0, 0, 0};
    EXPECT_THAT(messageFor(mesh), HasSubstr("3 uv indices for 4 face corners"));
    mesh.faceUvs = {0, 0, 0, 1};
    EXPECT_THAT(messageFor(mesh), HasSubstr("uv index 2 is out of range; expected 1 to 1"));

    mesh = quad();
    for (Vec3& point : mesh.points)
        point.y = 0;
    EXPECT_THAT(messageFor(mesh), HasSubstr("no area"));

    EXPECT_THAT(messageFor(quad(), Scheme::Loop), HasSubstr("4 vertices; expected only triangles"));
    EXPECT_THAT(messageFor(ControlMesh()), HasSubstr("no face"));
}

TEST(SceneObject, RotateDegrees_AreAboutXThenYThenZ) {
    SceneObject object;
    object.mesh = quad();
    object.mesh.normals = {{0, 0, 1}};
    object.scale = 2;
    object.translate = {10, 0, 0};
    object.rotateDegrees = {90, 90, 0};
    // (0,1,0): about x by 90 degrees to (0,0,1), about y by 90 degrees to (1,0,0); twice as large, 10 to the
    // right.
    const Vec3 moved = object.meshWorld().points[3];
    EXPECT_NEAR(moved.x, 12, 1e-14);
    EXPECT_NEAR(moved.y, 0, 1e-14);
    EXPECT_NEAR(moved.z, 0, 1e-14);
    // (0,0,1): about x to (0,-1,0), which the rotation about y doesn't change; normals stay unit.
    EXPECT_NEAR(object.meshWorld().normals[0].y, -1, 1e-15);

    object.rotateDegrees = {0, 90, 90}; // (1,0,0) about y to (0,0,-1), unchanged by the rotation about z
    EXPECT_NEAR(object.meshWorld().points[1].z, -2, 1e-14);

    object.rotateDegrees = {0, 0, 90}; // (1,0,0) about z to (0,1,0)
    EXPECT_NEAR(object.meshWorld().points[1].y, 2, 1e-14);
}

TEST(ColorMap, BetweenAndBeyondTexels_BlendsAndRepeats) {
    ColorMap map;
    map.width = 2;
    map.height = 1;
    map.rgb = {1, 0, 0, 0, 0.5f, 1};
    EXPECT_EQ(map.sample({0.25, 0.5}), Vec3(1, 0, 0));
    EXPECT_EQ(map.sample({0.5, 3.1}), Vec3(0.5, 0.25, 0.5));
    EXPECT_EQ(map.sample({1.0, 0.5}), Vec3(0.5, 0.25, 0.5));
}

} // namespace
} // namespace plumbline
