#include "scenes/scene_file/scene_merge.h"

#include "scenes/mesh/merge_vertices.h"
#include "scenes/scene/scene_limits.h"

#include <fmt/format.h>

namespace plumbline {

void readMerge(const TomlTable& object, ControlMesh& mesh) {
    if (!object.has("merge")) return;
    if (!object.has("mesh")) object.fail("merge", "is for meshes of files", "no merge beside shape");
    const std::vector<std::string> values = object.scalars("merge");
    const std::string expected = "true, false or a distance in the mesh's units";
    if (values.size() != 1) object.fail("merge", "is an array", expected);
    double distance = 0;
    if (values[0] == "true" || values[0] == "false") {
        if (!object.boolean("merge")) return;
        distance = samePlaceDistance(mesh);
    } else if (values[0].starts_with('"')) {
        object.fail("merge", "is " + values[0], expected);
    } else {
        distance = object.number("merge", 0, kLargestLength);
    }
    if (mergeVertices(mesh, distance) == 0)
        mesh.warnings.push_back(fmt::format("{}: merge = {} merges no vertices", mesh.name, values[0]));
}

std::optional<std::string> looseFacesWarning(const ControlMesh& mesh) {
    const size_t edges = countEdgesOnEdges(mesh);
    if (edges == 0) return std::nullopt;
    return fmt::format(
        "{}: {} boundary edges lie on another boundary edge: the faces there share no vertices, so "
        "that a relief parts them and nothing is smoothed across; merge = true in the object "
        "joins them",
        mesh.name, edges);
}

} // namespace plumbline
