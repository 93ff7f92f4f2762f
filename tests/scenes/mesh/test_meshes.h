// Small meshes for tests.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <cmath>
#include <initializer_list>

namespace plumbline {

inline void addFace(ControlMesh& mesh, std::initializer_list<int> vertices) {
    mesh.faceSizes.push_back(static_cast<int>(vertices.size()));
    mesh.faceVertices.insert(mesh.faceVertices.end(), vertices);
}

/// Corners at +-1; vertex k has x, y, z positive where bits 0, 1, 2 of k are set. Face 2 (the second) is the
/// top one, z = 1.
inline ControlMesh cubeMesh() {
    ControlMesh mesh;
    mesh.name = "cube";
    for (int k = 0; k < 8; ++k)
        mesh.points.push_back(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
    mesh.faceSizes.assign(6, 4);
    mesh.faceVertices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    return mesh;
}

/// side x side vertices, (i, bumps, -j) at index j * side + i; faces point toward +Y.
inline ControlMesh bumpyGrid(int side) {
    ControlMesh mesh;
    mesh.name = "grid";
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            mesh.points.push_back(Vec3(i, std::sin(1.7 * i + 0.3 * j * j) + 0.25 * i * j, -j));
    for (int j = 0; j + 1 < side; ++j)
        for (int i = 0; i + 1 < side; ++i)
            addFace(mesh, {j * side + i, j * side + i + 1, (j + 1) * side + i + 1, (j + 1) * side + i});
    return mesh;
}

/// An open cone: `valence` triangles around vertex 0, the tip.
inline ControlMesh fanMesh(int valence) {
    ControlMesh mesh;
    mesh.name = "fan";
    mesh.points.push_back(Vec3(0, 0, 1));
    for (int k = 0; k < valence; ++k) {
        mesh.points.push_back(Vec3(std::cos(2 * kPi * k / valence), std::sin(2 * kPi * k / valence), 0));
        addFace(mesh, {0, 1 + k, 1 + (k + 1) % valence});
    }
    return mesh;
}

/// A closed prism over a polygon of `sides`: two n-gons and quads.
inline ControlMesh prismMesh(int sides) {
    ControlMesh mesh;
    mesh.name = "prism";
    for (const double z : {-1.0, 1.0})
        for (int k = 0; k < sides; ++k)
            mesh.points.push_back(Vec3(std::cos(2 * kPi * k / sides), std::sin(2 * kPi * k / sides), z));
    for (const bool top : {false, true}) {
        mesh.faceSizes.push_back(sides);
        for (int k = 0; k < sides; ++k)
            mesh.faceVertices.push_back(top ? sides + k : sides - 1 - k);
    }
    for (int k = 0; k < sides; ++k)
        addFace(mesh, {k, (k + 1) % sides, sides + (k + 1) % sides, sides + k});
    return mesh;
}

/// Every face triangulated as a fan around its first corner.
inline ControlMesh triangulated(const ControlMesh& mesh) {
    ControlMesh result;
    result.name = mesh.name;
    result.points = mesh.points;
    size_t first = 0;
    for (const int size : mesh.faceSizes) {
        for (int k = 1; k + 1 < size; ++k)
            addFace(result, {mesh.faceVertices[first], mesh.faceVertices[first + size_t(k)],
                             mesh.faceVertices[first + size_t(k) + 1]});
        first += size_t(size);
    }
    return result;
}

} // namespace plumbline
