#include "scenes/mesh/merge_vertices.h"

#include "scenes/mesh/cut_faces.h"
#include "scenes/mesh/mesh_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace plumbline {

namespace {

constexpr double kSamePlace = 1e-6; // samePlaceDistance
/// Side of a cell, in distances: few places are near another cell, and few fit into one.
constexpr double kCellDistances = 4;
/// Cells this many distances away are searched, so that rounding hides none.
constexpr double kReach = 1.001;

/// Finds points within a distance of a place, in cubic cells.
class PlaceIndex {
  public:
    explicit PlaceIndex(double distance) : distance_(distance), cell_(kCellDistances * distance) {}

    /// The first added point within the distance; otherwise adds this one, as `number`, and returns it.
    int firstNear(const Vec3& point, int number) {
        const Vec3 low = cellOf(point - kReach * distance_), high = cellOf(point + kReach * distance_);
        int nearest = -1;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 cell((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                            (corner & 4) != 0 ? high.z : low.z);
            const bool repeats = ((corner & 1) != 0 && high.x == low.x) ||
                                 ((corner & 2) != 0 && high.y == low.y) ||
                                 ((corner & 4) != 0 && high.z == low.z);
            const auto found = repeats ? cells_.end() : cells_.find(cell);
            if (found == cells_.end()) continue;
            for (const auto& [other, at] : found->second)
                if (glm::length(at - point) <= distance_ && (nearest < 0 || other < nearest)) nearest = other;
        }
        if (nearest >= 0) return nearest;
        cells_[cellOf(point)].emplace_back(number, point);
        return number;
    }

  private:
    struct Hash {
        size_t operator()(const Vec3& cell) const {
            size_t hash = 0;
            for (int axis = 0; axis < 3; ++axis)
                hash = (hash ^ std::hash<double>()(cell[axis])) * 0x9e3779b97f4a7c15u;
            return hash ^ (hash >> 32);
        }
    };
    Vec3 cellOf(const Vec3& point) const {
        return cell_ > 0 ? glm::floor(point / cell_) + 0.0 : point + 0.0; // + 0: -0 and 0 are one cell
    }

    double distance_, cell_;
    std::unordered_map<Vec3, std::vector<std::pair<int, Vec3>>, Hash> cells_;
};

/// For each vertex the first one within the distance that stands for itself.
std::vector<int> firstVertices(const ControlMesh& mesh, double distance) {
    PlaceIndex places(distance);
    std::vector<int> first;
    first.reserve(mesh.points.size());
    for (int vertex = 0; vertex < countOf(mesh.points); ++vertex)
        first.push_back(places.firstNear(item(mesh.points, vertex), vertex));
    return first;
}

void renumberTags(SubdivisionTags& tags, const std::vector<int>& numbers) {
    for (SubdivisionTags::Crease& crease : tags.creases) {
        crease.from = item(numbers, crease.from);
        crease.to = item(numbers, crease.to);
    }
    std::erase_if(tags.creases, [](const auto& crease) { return crease.from == crease.to; });
    for (SubdivisionTags::Corner& corner : tags.corners)
        corner.vertex = item(numbers, corner.vertex);
}

} // namespace

double samePlaceDistance(const ControlMesh& mesh) {
    Bounds bounds;
    for (const Vec3& point : mesh.points)
        bounds.add(point);
    return kSamePlace * bounds.diagonal();
}

size_t countEdgesOnEdges(const ControlMesh& mesh) {
    const MeshEdges edges(mesh);
    PlaceIndex places(samePlaceDistance(mesh));
    std::vector<int> known(mesh.points.size(), -1);
    const auto placeOf = [&](int vertex) {
        int& place = item(known, vertex);
        if (place < 0) place = places.firstNear(item(mesh.points, vertex), vertex);
        return place;
    };
    std::vector<std::pair<int, int>> ends; // of each boundary edge
    for (const auto& edge : edges.edges()) {
        if (edge.size() != 1) continue;
        const int low = placeOf(edge[0].low), high = placeOf(edge[0].high);
        if (low != high) ends.push_back(std::minmax(low, high));
    }
    std::ranges::sort(ends);
    size_t count = 0;
    for (size_t first = 0, end = 0; first < ends.size(); first = end) {
        while (end < ends.size() && ends[end] == ends[first])
            ++end;
        if (end - first > 1) count += end - first;
    }
    return count;
}

size_t mergeVertices(ControlMesh& mesh, double distance) {
    const std::vector<int> first = firstVertices(mesh, distance);
    std::vector<int> numbers; // after the others are removed
    std::vector<Vec3> kept;
    for (int vertex = 0; vertex < countOf(first); ++vertex) {
        const bool stays = item(first, vertex) == vertex;
        numbers.push_back(stays ? countOf(kept) : item(numbers, item(first, vertex)));
        if (stays) kept.push_back(item(mesh.points, vertex));
    }
    const size_t removed = mesh.points.size() - kept.size();
    mesh.points = std::move(kept);
    for (int& vertex : mesh.faceVertices)
        vertex = item(numbers, vertex);
    renumberTags(mesh.tags, numbers);
    repairFaces(mesh);
    return removed;
}

} // namespace plumbline
