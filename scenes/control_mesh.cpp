#include "control_mesh.h"

#include "error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

/// Buffers for tracing and drawing are float, where squared lengths overflow from 1.8e19 on.
constexpr double kLargestCoordinate = 1e15;

std::string whereOfFace(const ControlMesh& mesh, int face) {
    if (mesh.faceLines.empty()) return fmt::format("{}: face {}", mesh.name, face + 1);
    return fmt::format("{}:{}: face {}", mesh.name, mesh.faceLines[static_cast<size_t>(face)], face + 1);
}

template <class Vector>
void checkCoordinates(const ControlMesh& mesh, const std::vector<Vector>& values, const char* what) {
    for (size_t i = 0; i < values.size(); ++i)
        for (int axis = 0; axis < Vector::length(); ++axis)
            if (!(std::abs(values[i][axis]) <= kLargestCoordinate))
                throw InputError(mesh.name,
                                 fmt::format("{} {} has the coordinate {}", what, i + 1, values[i][axis]),
                                 "finite numbers up to 1e15");
}

void checkArrayLengths(const ControlMesh& mesh) {
    size_t corners = 0;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int size = mesh.faceSizes[static_cast<size_t>(face)];
        if (size < 3)
            throw InputError(mesh.name, fmt::format("face {} has {} vertices", face + 1, size), "3 or more");
        corners += static_cast<size_t>(size);
    }
    const auto check = [&](size_t length, bool optional, const char* what) {
        if (length != corners && !(optional && length == 0))
            throw InputError(mesh.name, fmt::format("{} {} for {} face corners", length, what, corners),
                             "one a corner");
    };
    check(mesh.faceVertices.size(), false, "vertex indices");
    check(mesh.faceUvs.size(), true, "uv indices");
    check(mesh.faceNormals.size(), true, "normal indices");
    if (!mesh.faceLines.empty() && mesh.faceLines.size() != mesh.faceSizes.size())
        throw InputError(
            mesh.name, fmt::format("{} line numbers for {} faces", mesh.faceLines.size(), mesh.faceCount()));
}

void checkIndices(const ControlMesh& mesh, int face, size_t firstCorner, const std::vector<int>& indices,
                  size_t count, const char* what) {
    const auto corners = static_cast<size_t>(mesh.faceSizes[static_cast<size_t>(face)]);
    for (size_t corner = firstCorner; corner < firstCorner + corners; ++corner)
        if (indices[corner] < 0 || static_cast<size_t>(indices[corner]) >= count)
            throw InputError(whereOfFace(mesh, face),
                             fmt::format("{} index {} is out of range", what, indices[corner] + 1),
                             fmt::format("1 to {}", count));
}

void checkDistinctVertices(const ControlMesh& mesh, int face, size_t firstCorner) {
    const auto begin = mesh.faceVertices.begin() + static_cast<std::ptrdiff_t>(firstCorner);
    std::vector<int> sorted(begin, begin + mesh.faceSizes[static_cast<size_t>(face)]);
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
        throw InputError(whereOfFace(mesh, face),
                         fmt::format("vertex {} occurs twice in the face", *twice + 1), "distinct vertices");
}

/// Length of the area vector (sum of p_k x p_k+1 about the first corner, halved): the area of a planar face.
double faceArea(const ControlMesh& mesh, int face, size_t firstCorner) {
    const auto point = [&](int k) {
        return mesh.points[static_cast<size_t>(mesh.faceVertices[firstCorner + static_cast<size_t>(k)])];
    };
    Vec3 areaVector(0);
    for (int k = 1; k + 1 < mesh.faceSizes[static_cast<size_t>(face)]; ++k)
        areaVector += 0.5 * glm::cross(point(k) - point(0), point(k + 1) - point(0));
    return glm::length(areaVector);
}

} // namespace

void checkControlMesh(const ControlMesh& mesh, Scheme scheme) {
    if (mesh.faceCount() == 0) throw InputError(mesh.name, "no face", "at least one");
    checkArrayLengths(mesh);
    checkCoordinates(mesh, mesh.points, "vertex");
    checkCoordinates(mesh, mesh.uvs, "uv");
    checkCoordinates(mesh, mesh.normals, "normal");
    double area = 0;
    size_t firstCorner = 0;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        checkIndices(mesh, face, firstCorner, mesh.faceVertices, mesh.points.size(), "vertex");
        if (mesh.hasUvs()) checkIndices(mesh, face, firstCorner, mesh.faceUvs, mesh.uvs.size(), "uv");
        if (mesh.hasNormals())
            checkIndices(mesh, face, firstCorner, mesh.faceNormals, mesh.normals.size(), "normal");
        checkDistinctVertices(mesh, face, firstCorner);
        const int size = mesh.faceSizes[static_cast<size_t>(face)];
        if (scheme == Scheme::Loop && size != 3)
            throw InputError(whereOfFace(mesh, face), fmt::format("{} vertices", size),
                             "triangles alone under scheme \"loop\"",
                             "\"catmull-clark\" takes faces of any size");
        area += faceArea(mesh, face, firstCorner);
        firstCorner += static_cast<size_t>(size);
    }
    if (!(area > 0)) throw InputError(mesh.name, "the mesh has no area: its faces are points or lines");
}

} // namespace plumbline
