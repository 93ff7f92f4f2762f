#include "scenes/mesh/control_mesh.h"

#include "scenes/core/error.h"
#include "scenes/mesh/mesh_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

namespace plumbline {
namespace {

/// Buffers for tracing and drawing are float, where squared lengths overflow from 1.8e19 on.
constexpr double kLargestCoordinate = 1e15;

template <class Vector>
void checkCoordinates(const ControlMesh& mesh, const std::vector<Vector>& values, const char* what) {
    for (size_t i = 0; i < values.size(); ++i)
        for (int axis = 0; axis < Vector::length(); ++axis)
            if (!(std::abs(values[i][axis]) <= kLargestCoordinate))
                throw InputError(mesh.name,
                                 fmt::format("{} {} has the coordinate {}", what, i + 1, values[i][axis]),
                                 "finite numbers up to 1e15");
}

void checkFaceSizes(const ControlMesh& mesh) {
    if (mesh.faceCount() == 0) throw InputError(mesh.name, "no face", "at least one");
    for (int face = 0; face < mesh.faceCount(); ++face)
        if (const int size = item(mesh.faceSizes, face); size < 3)
            throw InputError(mesh.name, fmt::format("face {} has {} vertices", faceNumber(mesh, face), size),
                             "3 or more");
}

void checkArrayLengths(const ControlMesh& mesh, size_t corners) {
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

bool isIndex(int index, size_t count) {
    return index >= 0 && std::cmp_less(index, count);
}

void checkIndices(const ControlMesh& mesh, const MeshFace& face, const std::vector<int>& indices,
                  size_t count, const char* what) {
    for (const int index : face.of(indices))
        if (!isIndex(index, count))
            throw InputError(whereOfFace(mesh, face.index),
                             fmt::format("{} index {} is out of range", what, index + 1),
                             fmt::format("1 to {}", count));
}

void checkDistinctVertices(const ControlMesh& mesh, const MeshFace& face) {
    const auto vertices = face.of(mesh.faceVertices);
    std::vector<int> sorted(vertices.begin(), vertices.end());
    std::ranges::sort(sorted);
    const auto twice = std::ranges::adjacent_find(sorted);
    if (twice != sorted.end())
        throw InputError(whereOfFace(mesh, face.index),
                         fmt::format("vertex {} occurs twice in the face", *twice + 1), "distinct vertices");
}

/// The vertices of a face, rotated so that the lowest index comes first.
std::vector<int> rotatedVertices(const ControlMesh& mesh, const MeshFace& face) {
    const auto inOrder = face.of(mesh.faceVertices);
    std::vector<int> vertices(inOrder.begin(), inOrder.end());
    std::rotate(vertices.begin(), std::ranges::min_element(vertices), vertices.end());
    return vertices;
}

/// Two faces with the same vertices in the same order coincide, so it is undefined which one a ray hits. Two
/// faces in opposite orders are allowed: they are the two sides of a sheet.
void checkDistinctFaces(const ControlMesh& mesh, const std::vector<MeshFace>& faces, const MeshEdges& edges) {
    for (const auto& edge : edges.edges()) {
        // Duplicate faces need two half edges in the same direction, which is rare.
        const auto forward = std::ranges::count_if(edge, &HalfEdge::forward);
        if (forward < 2 && std::ssize(edge) - forward < 2) continue;
        std::map<std::vector<int>, int> seen;
        for (const HalfEdge& half : edge) {
            const auto [place, isNew] =
                seen.emplace(rotatedVertices(mesh, item(faces, half.face)), half.face);
            if (!isNew)
                throw InputError(
                    whereOfFace(mesh, half.face),
                    fmt::format("has the same vertices as face {}", faceNumber(mesh, place->second)),
                    "each face once");
        }
    }
}

void checkNormals(const ControlMesh& mesh, const MeshFace& face) {
    for (const int normal : face.of(mesh.faceNormals))
        if (item(mesh.normals, normal) == Vec3(0))
            throw InputError(whereOfFace(mesh, face.index), fmt::format("normal {} is zero", normal + 1),
                             "a direction", "a mesh without any normals gets them from its faces");
}

std::string whereOfTag(const ControlMesh& mesh, int line) {
    return line > 0 ? fmt::format("{}:{}", mesh.name, line) : mesh.name;
}

void checkSharpness(const ControlMesh& mesh, double sharpness, int line) {
    if (!(sharpness >= 0) || !std::isfinite(sharpness))
        throw InputError(whereOfTag(mesh, line), fmt::format("sharpness {}", sharpness),
                         "a finite number, 0 (smooth) or more; from 10 on it is always sharp");
}

void checkTagIndex(const ControlMesh& mesh, int line, const char* what, int index, size_t count) {
    if (!isIndex(index, count))
        throw InputError(whereOfTag(mesh, line), fmt::format("{} {} isn't in the mesh", what, index + 1),
                         fmt::format("1 to {} (0 to {} in 't' lines)", count, count - 1));
}

void checkCreases(const ControlMesh& mesh, const MeshEdges& edges) {
    std::map<std::pair<int, int>, double> creased;
    for (const SubdivisionTags::Crease& crease : mesh.tags.creases) {
        checkTagIndex(mesh, crease.line, "vertex", crease.from, mesh.points.size());
        checkTagIndex(mesh, crease.line, "vertex", crease.to, mesh.points.size());
        if (!edges.contains(crease.from, crease.to))
            throw InputError(
                whereOfTag(mesh, crease.line),
                fmt::format("no face has an edge from vertex {} to {}", crease.from + 1, crease.to + 1),
                "neighbors in a face", "'t' lines count vertices from 0, faces and scene files from 1");
        checkSharpness(mesh, crease.sharpness, crease.line);
        const auto [place, isNew] = creased.emplace(std::minmax(crease.from, crease.to), crease.sharpness);
        if (!isNew && place->second != crease.sharpness)
            throw InputError(whereOfTag(mesh, crease.line),
                             fmt::format("the edge from vertex {} to {} has sharpness {} and {}",
                                         crease.from + 1, crease.to + 1, place->second, crease.sharpness),
                             "one sharpness for each edge");
    }
}

void checkCornersAndHoles(const ControlMesh& mesh) {
    std::map<int, double> corners;
    for (const SubdivisionTags::Corner& corner : mesh.tags.corners) {
        checkTagIndex(mesh, corner.line, "vertex", corner.vertex, mesh.points.size());
        checkSharpness(mesh, corner.sharpness, corner.line);
        const auto [place, isNew] = corners.emplace(corner.vertex, corner.sharpness);
        if (!isNew && place->second != corner.sharpness)
            throw InputError(whereOfTag(mesh, corner.line),
                             fmt::format("vertex {} has sharpness {} and {}", corner.vertex + 1,
                                         place->second, corner.sharpness),
                             "one sharpness for each vertex");
    }
    for (const SubdivisionTags::Hole& hole : mesh.tags.holes)
        checkTagIndex(mesh, hole.line, "face", hole.face, mesh.faceSizes.size());
}

/// Length of the area vector (half the sum of p_k x p_k+1 about the first corner), which is the area of a
/// planar face.
double faceArea(const ControlMesh& mesh, const MeshFace& face) {
    const Vec3& first = mesh.pointAt(face.firstCorner);
    Vec3 areaVector(0);
    for (size_t k = 1; k + 1 < face.size; ++k)
        areaVector +=
            0.5 * glm::cross(mesh.pointAt(face.corner(k)) - first, mesh.pointAt(face.corner(k + 1)) - first);
    return glm::length(areaVector);
}

} // namespace

int faceNumber(const ControlMesh& mesh, int face) {
    return mesh.faceNumbers.empty() ? face + 1 : item(mesh.faceNumbers, face);
}

std::string whereOfFace(const ControlMesh& mesh, int face) {
    const int number = faceNumber(mesh, face);
    if (mesh.faceLines.empty()) return fmt::format("{}: face {}", mesh.name, number);
    return fmt::format("{}:{}: face {}", mesh.name, item(mesh.faceLines, face), number);
}

std::vector<MeshFace> ControlMesh::faces() const {
    std::vector<MeshFace> result;
    result.reserve(faceSizes.size());
    size_t firstCorner = 0;
    for (const int size : faceSizes) {
        assert(size >= 0);
        result.push_back({countOf(result), firstCorner, static_cast<size_t>(size)});
        firstCorner += result.back().size;
    }
    return result;
}

void checkControlMesh(const ControlMesh& mesh, Scheme scheme) {
    checkFaceSizes(mesh);
    const std::vector<MeshFace> faces = mesh.faces();
    checkArrayLengths(mesh, faces.back().firstCorner + faces.back().size);
    checkCoordinates(mesh, mesh.points, "vertex");
    checkCoordinates(mesh, mesh.uvs, "uv");
    checkCoordinates(mesh, mesh.normals, "normal");
    double area = 0;
    for (const MeshFace& face : faces) {
        checkIndices(mesh, face, mesh.faceVertices, mesh.points.size(), "vertex");
        if (mesh.hasUvs()) checkIndices(mesh, face, mesh.faceUvs, mesh.uvs.size(), "uv");
        if (mesh.hasNormals()) checkIndices(mesh, face, mesh.faceNormals, mesh.normals.size(), "normal");
        if (mesh.hasNormals() && scheme == Scheme::None) checkNormals(mesh, face);
        checkDistinctVertices(mesh, face);
        if (scheme == Scheme::Loop && face.size != 3)
            throw InputError(whereOfFace(mesh, face.index), fmt::format("{} vertices", face.size),
                             "only triangles under scheme \"loop\"",
                             "\"catmull-clark\" takes faces of any size");
        area += faceArea(mesh, face);
    }
    if (!(area > 0)) throw InputError(mesh.name, "the mesh has no area: its faces are points or lines");

    const MeshEdges edges(mesh);
    checkDistinctFaces(mesh, faces, edges);
    checkCreases(mesh, edges);
    checkCornersAndHoles(mesh);
}

} // namespace plumbline
