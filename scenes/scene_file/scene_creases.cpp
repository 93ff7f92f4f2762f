#include "scenes/scene_file/scene_creases.h"

#include "scenes/mesh/mesh_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace plumbline {
namespace {

constexpr double kLargestSharpness = 1e6; // arbitrary: from kInfinitelySharp on all are equal

/// Indexes tags by their edge or vertex, so that a later tag replaces an earlier one.
struct TagIndex {
    std::map<std::pair<int, int>, SubdivisionTags::Crease> creases;
    std::map<int, SubdivisionTags::Corner> corners;

    explicit TagIndex(const SubdivisionTags& tags) {
        for (const SubdivisionTags::Crease& crease : tags.creases)
            add(crease);
        for (const SubdivisionTags::Corner& corner : tags.corners)
            add(corner);
    }
    void add(const SubdivisionTags::Crease& crease) {
        creases.insert_or_assign(std::minmax(crease.from, crease.to), crease);
    }
    void add(const SubdivisionTags::Corner& corner) { corners.insert_or_assign(corner.vertex, corner); }

    void writeTo(SubdivisionTags& tags) const {
        tags.creases.clear();
        tags.corners.clear();
        for (const auto& [edge, crease] : creases)
            tags.creases.push_back(crease);
        for (const auto& [vertex, corner] : corners)
            tags.corners.push_back(corner);
    }
};

void readPath(const TomlTable& table, double sharpness, const MeshEdges& edges, int vertexCount,
              TagIndex& tags) {
    const std::vector<int> path = table.integers("edges", 1, vertexCount);
    if (path.size() < 2)
        table.fail("edges", fmt::format("has {} vertices", path.size()), "two, or more for edges in a row");
    for (size_t i = 0; i + 1 < path.size(); ++i) {
        if (!edges.contains(path[i] - 1, path[i + 1] - 1))
            table.fail("edges", fmt::format("no face has an edge from vertex {} to {}", path[i], path[i + 1]),
                       "vertices that are neighbors in a face, counted from 1");
        tags.add(SubdivisionTags::Crease{path[i] - 1, path[i + 1] - 1, sharpness});
    }
}

} // namespace

void readCreases(const TomlTable& object, Scheme scheme, ControlMesh& mesh) {
    if (!object.has("creases")) return;
    if (scheme == Scheme::None)
        object.fail("creases", "has no meaning under scheme \"none\"", "scheme \"catmull-clark\" or \"loop\"",
                    "all edges of the polygons are sharp as they are");
    const MeshEdges edges(mesh);
    const int vertexCount = countOf(mesh.points);
    TagIndex tags(mesh.tags);
    for (const TomlTable& table : object.tables("creases")) {
        const double sharpness = table.number("sharpness", 0, kLargestSharpness);
        if (table.has("edges") == table.has("vertex"))
            table.fail({}, table.has("edges") ? "has both edges and vertex" : "has neither edges nor vertex",
                       "edges = [vertex, vertex, …] or vertex = a number");
        if (table.has("edges"))
            readPath(table, sharpness, edges, vertexCount, tags);
        else
            tags.add(SubdivisionTags::Corner{table.integer("vertex", 1, vertexCount) - 1, sharpness});
        table.finish();
    }
    tags.writeTo(mesh.tags);
}

} // namespace plumbline
