// Topology checks of control meshes, independent of the code that creates them.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace plumbline {

struct DirectedEdge {
    int face;
    int fromUv, toUv;
};
/// By (from, to) vertex; in a consistently oriented mesh each occurs at most once.
inline std::multimap<std::pair<int, int>, DirectedEdge> directedEdges(const ControlMesh& mesh) {
    std::multimap<std::pair<int, int>, DirectedEdge> edges;
    size_t first = 0;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const auto size = static_cast<size_t>(mesh.faceSizes[size_t(face)]);
        for (size_t k = 0; k < size; ++k) {
            const size_t a = first + k, b = first + (k + 1) % size;
            edges.insert(
                {{mesh.faceVertices[a], mesh.faceVertices[b]}, {face, mesh.faceUvs[a], mesh.faceUvs[b]}});
        }
        first += size;
    }
    return edges;
}

struct Topology {
    bool consistent = true; // no directed edge twice
    int vertices = 0, edges = 0, faces = 0, boundaryEdges = 0;
    int seamEdges = 0; // inner edges whose uvs on the two sides differ by more than an integer
    int euler() const { return vertices - edges + faces; }
};
inline Topology topologyOf(const ControlMesh& mesh) {
    const auto edges = directedEdges(mesh);
    Topology result;
    result.vertices = static_cast<int>(mesh.points.size());
    result.faces = mesh.faceCount();
    // The same integer difference along the whole edge, not only at its ends.
    const auto differByWhole = [&](const DirectedEdge& edge, const DirectedEdge& twin) {
        const Vec2 from = mesh.uvs[size_t(edge.fromUv)] - mesh.uvs[size_t(twin.toUv)];
        const Vec2 to = mesh.uvs[size_t(edge.toUv)] - mesh.uvs[size_t(twin.fromUv)];
        // uvs are quotients of small integers, or lengths over their sum: rounding stays below 1e-14
        return glm::length(from - to) < 1e-14 && glm::length(from - glm::round(from)) < 1e-14;
    };
    for (const auto& [key, edge] : edges) {
        if (edges.count(key) > 1) result.consistent = false;
        const auto twin = edges.find({key.second, key.first});
        if (twin == edges.end()) {
            ++result.boundaryEdges;
            ++result.edges;
        } else if (key.first < key.second) {
            ++result.edges;
            if (!differByWhole(edge, twin->second)) ++result.seamEdges;
        }
    }
    return result;
}

/// Signed volumes of the connected components, with holes closed by fans; positive if faces point outwards.
/// Sorted.
inline std::vector<double> partVolumes(const ControlMesh& mesh) {
    std::vector<int> parent(mesh.points.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
        while (parent[size_t(v)] != v)
            v = parent[size_t(v)] = parent[size_t(parent[size_t(v)])];
        return v;
    };
    const auto edges = directedEdges(mesh);
    for (const auto& [key, edge] : edges)
        parent[size_t(root(key.first))] = root(key.second);
    std::map<int, double> volumes;
    const auto addTriangle = [&](const Vec3& a, const Vec3& b, const Vec3& c, int part) {
        volumes[part] += glm::dot(a, glm::cross(b, c)) / 6;
    };
    size_t first = 0;
    for (const int size : mesh.faceSizes) {
        const auto point = [&](int k) { return mesh.points[size_t(mesh.faceVertices[first + size_t(k)])]; };
        for (int k = 1; k + 1 < size; ++k)
            addTriangle(point(0), point(k), point(k + 1), root(mesh.faceVertices[first]));
        first += size_t(size);
    }
    std::map<int, int> next; // along boundaries, opposite to the faces' direction
    for (const auto& [key, edge] : edges)
        if (!edges.count({key.second, key.first})) next[key.second] = key.first;
    std::set<int> done;
    for (const auto& [start, unused] : next)
        for (int v = start; done.insert(v).second; v = next.at(v))
            addTriangle(mesh.points[size_t(start)], mesh.points[size_t(v)], mesh.points[size_t(next.at(v))],
                        root(start));
    std::vector<double> result;
    for (const auto& [part, volume] : volumes)
        result.push_back(volume);
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace plumbline
