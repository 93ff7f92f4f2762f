#include "scenes/scene/scene.h"

namespace plumbline {
namespace {

/// Rotation by a right-handed angle about one axis of space.
Mat3 rotationAbout(int axis, double angleDegrees) {
    const double cosine = std::cos(radians(angleDegrees)), sine = std::sin(radians(angleDegrees));
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    Mat3 matrix(1.0);
    matrix[next][next] = cosine;
    matrix[next][last] = sine;
    matrix[last][next] = -sine;
    matrix[last][last] = cosine;
    return matrix;
}

/// About x, then y, then z: the last one applied stands on the left.
Mat3 rotation(const Vec3& rotateDegrees) {
    return rotationAbout(2, rotateDegrees.z) * rotationAbout(1, rotateDegrees.y) *
           rotationAbout(0, rotateDegrees.x);
}

} // namespace

Mat4 SceneObject::worldFromObject() const {
    Mat4 matrix(rotation(rotateDegrees) * scale);
    matrix[3] = Vec4(translate, 1.0);
    return matrix;
}

Vec3 SceneObject::axisWorld() const {
    return rotation(rotateDegrees)[2];
}

ControlMesh SceneObject::meshWorld() const {
    ControlMesh world = mesh;
    const Mat3 turn = rotation(rotateDegrees);
    const Mat3 linear = turn * scale;
    for (Vec3& point : world.points)
        point = linear * point + translate;
    for (Vec3& normal : world.normals)
        normal = turn * normal; // the scale is uniform
    return world;
}

} // namespace plumbline
