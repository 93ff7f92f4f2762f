#include "scenes/scene/scene.h"

#define GLM_ENABLE_EXPERIMENTAL // GLM requires it for gtx
#include <glm/gtx/euler_angles.hpp>

namespace plumbline {
namespace {

/// Rotates about x, then y, then z; the last rotation is the leftmost factor.
Mat3 rotation(const Vec3& rotateDegrees) {
    const Vec3 angles = radians(rotateDegrees);
    return Mat3(glm::eulerAngleZ(angles.z)) * Mat3(glm::eulerAngleY(angles.y)) *
           Mat3(glm::eulerAngleX(angles.x));
}

} // namespace

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
