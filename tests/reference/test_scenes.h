// Small scenes created in code, whose images can be derived by hand.
#pragma once

#include "scenes/scene/scene.h"

#include <cmath>

namespace plumbline {

/// Square of side `size` in the plane z = 0, facing +z, with `segments` quads per side and uv (0,0) at its
/// lower left.
inline ControlMesh squareMesh(double size, int segments) {
    ControlMesh mesh;
    mesh.name = "square";
    const int side = segments + 1;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const Vec2 uv(double(i) / segments, double(j) / segments);
            mesh.uvs.push_back(uv);
            mesh.points.push_back(Vec3((uv - 0.5) * size, 0));
        }
    for (int j = 0; j < segments; ++j)
        for (int i = 0; i < segments; ++i) {
            mesh.faceSizes.push_back(4);
            for (const int v : {j * side + i, j * side + i + 1, (j + 1) * side + i + 1, (j + 1) * side + i})
                mesh.faceVertices.push_back(v);
        }
    mesh.faceUvs = mesh.faceVertices;
    return mesh;
}

/// A square with a relief, seen from +z by an orthographic camera whose image is 4 world units high.
inline Scene squareScene(std::shared_ptr<const HeightMap> map, double depth, int segments = 1) {
    Scene scene;
    scene.name = "square";
    scene.camera.projection = Camera::Projection::Orthographic;
    scene.camera.positionWorld = {0, 0, 5};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.viewHeight = 4;
    scene.camera.width = 40;
    scene.camera.height = 40;
    SceneObject square;
    square.name = "square";
    square.mesh = squareMesh(2, segments);
    square.scheme = Scheme::None;
    if (map) square.relief = Relief{std::move(map), depth, 0.0, Vec2(1), Vec2(0)};
    scene.objects.push_back(square);
    Light light;
    light.name = "sun";
    light.toLightWorld = {0, 0, 1};
    scene.lights.push_back(light);
    return scene;
}

/// The object-to-world matrix, computed from the world positions of the origin and the axes.
inline Mat4 worldFromObject(SceneObject object) {
    object.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<Vec3> at = object.meshWorld().points;
    return Mat4(Vec4(at[1] - at[0], 0), Vec4(at[2] - at[0], 0), Vec4(at[3] - at[0], 0), Vec4(at[0], 1));
}

} // namespace plumbline
