#include "scenes/mesh/mesh_defects.h"

#include "scenes/core/disjoint_sets.h"
#include "scenes/mesh/findings.h"
#include "scenes/mesh/mesh_edges.h"
#include "scenes/mesh/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace plumbline {
namespace {

/// Relative rounding error of coordinates, a few units in the last place of a double. A face whose height is
/// below this fraction of the mesh's size has no area.
constexpr double kRounding = 0x1p-50;

/// Signed volumes below this fraction of the cubed mesh size belong to flat shells, that is, two coincident
/// sheets.
constexpr double kFlatVolume = 1e-9;

class DefectFinder {
  public:
    DefectFinder(const ControlMesh& mesh, Scheme scheme)
        : mesh_(mesh), scheme_(scheme), faces_(mesh.faces()), edges_(mesh) {
        Bounds bounds;
        for (const Vec3& point : mesh.points)
            bounds.add(point);
        size_ = bounds.diagonal();
    }

    std::vector<std::string> find() {
        warnings_ = mesh_.warnings;
        findCrowdedEdges();
        findOpposedFaces();
        findPinchedVertices();
        findFlatFaces();
        findCrossingOutlines();
        findInsideOutShells();
        findUnusedVertices();
        findTagsWithoutEffect();
        return std::move(warnings_);
    }

  private:
    bool smooth() const { return scheme_ != Scheme::None; }

    void findCrowdedEdges() {
        Findings found;
        for (const auto& edge : edges_.edges())
            if (edge.size() > 2)
                found.add([&] {
                    return fmt::format("{} is one of {} faces on the edge from vertex {} to {}",
                                       whereOfFace(mesh_, edge[2].face), edge.size(), edge[0].low + 1,
                                       edge[0].high + 1);
                });
        found.report(warnings_, smooth()
                                    ? ": no surface continues there, the edge is made infinitely sharp"
                                    : ": no surface continues there, normals are the mean of all of them");
    }

    void findOpposedFaces() {
        Findings found;
        for (const auto& edge : edges_.edges())
            if (edge.size() == 2 && edge[0].forward == edge[1].forward)
                found.add([&] {
                    return fmt::format(
                        "{} and face {} run along the edge from vertex {} to {} in the same direction",
                        whereOfFace(mesh_, edge[1].face), faceNumber(mesh_, edge[0].face), edge[0].low + 1,
                        edge[0].high + 1);
                });
        found.report(
            warnings_,
            smooth() ? ": one of them is inside out, the edge is made infinitely sharp and its ends corners"
                     : ": one of them is inside out");
    }

    void findPinchedVertices() {
        Findings found;
        for (const int vertex : pinchedVertices(mesh_, edges_))
            found.add([&] {
                return fmt::format("{}: vertex {} joins faces that share no edge there", mesh_.name,
                                   vertex + 1);
            });
        found.report(warnings_,
                     smooth() ? ": it is made a corner" : ": its normal is the mean of all of them");
    }

    void findFlatFaces() {
        Findings flat, collapsed;
        for (const MeshFace& face : faces_) {
            const Vec3& first = mesh_.pointAt(face.firstCorner);
            // Sum of the fan triangles' unsigned areas: signed areas of a self-intersecting face may cancel.
            double area = 0;
            double longestEdge = 0, shortestEdge = kInfinity;
            for (size_t k = 0; k < face.size; ++k) {
                const Vec3 &a = mesh_.pointAt(face.corner(k)), &b = mesh_.pointAt(face.corner(k + 1));
                area += 0.5 * glm::length(glm::cross(a - first, b - first));
                longestEdge = std::max(longestEdge, glm::length(b - a));
                shortestEdge = std::min(shortestEdge, glm::length(b - a));
            }
            if (area <= kRounding * size_ * longestEdge)
                flat.add([&] { return whereOfFace(mesh_, face.index) + " has no area"; });
            else if (shortestEdge <= kRounding * size_)
                collapsed.add([&] { return whereOfFace(mesh_, face.index) + " has coincident vertices"; });
        }
        flat.report(warnings_, smooth() ? ": it still shapes the limit surface" : ": it is invisible");
        collapsed.report(warnings_, smooth() ? ": it is subdivided as if they were two"
                                             : ": normals vary abruptly there");
    }

    /// Under Scheme::None these are dropped (cut_faces.h).
    void findCrossingOutlines() {
        if (smooth()) return;
        Findings found;
        for (const MeshFace& face : faces_)
            if (outlineOf(mesh_, face).kind == OutlineKind::Crossing)
                found.add([&] { return whereOfFace(mesh_, face.index) + " crosses its own outline"; });
        found.report(warnings_, ": it has no inside and is left out");
    }

    /// A shell is closed if every edge has two faces with opposite directions.
    void findInsideOutShells() {
        DisjointSets shells(mesh_.faceSizes.size());
        std::set<int> openFaces;
        for (const auto& edge : edges_.edges()) {
            for (const HalfEdge& half : edge)
                shells.join(half.face, edge[0].face);
            if (edge.size() != 2 || edge[0].forward == edge[1].forward) openFaces.insert(edge[0].face);
        }
        std::set<int> open;
        for (const int face : openFaces)
            open.insert(shells.rootOf(face));
        struct Shell {
            int firstFace = 0, faces = 0;
            double volume = 0;
        };
        std::map<int, Shell> found;
        for (const MeshFace& face : faces_) {
            Shell& shell = found[shells.rootOf(face.index)];
            if (shell.faces++ == 0) shell.firstFace = face.index;
            shell.volume += volumeUnder(face);
        }
        Findings insideOut;
        for (const auto& [root, shell] : found)
            if (!open.contains(root) && shell.volume < -kFlatVolume * size_ * size_ * size_)
                insideOut.add([&, &shell = shell] {
                    return fmt::format(
                        "{} and the rest of its closed shell of {} point inwards (volume {:.3g})",
                        whereOfFace(mesh_, shell.firstFace), shell.faces, shell.volume);
                });
        insideOut.report(
            warnings_,
            ": right for a cavity, inside out otherwise; its relief is displaced the opposite way");
    }

    /// Signed volume between a face and the mesh's first point. The face is triangulated as a fan around its
    /// center, so that the two sides of a sheet enclose zero volume.
    double volumeUnder(const MeshFace& face) const {
        const Vec3 origin = mesh_.points[0];
        Vec3 center(0), areaVector(0);
        for (size_t k = 0; k < face.size; ++k) {
            const Vec3 a = mesh_.pointAt(face.corner(k)) - origin,
                       b = mesh_.pointAt(face.corner(k + 1)) - origin;
            center += a / static_cast<double>(face.size);
            areaVector += 0.5 * glm::cross(a, b);
        }
        return glm::dot(center, areaVector) / 3; // = sum of center . (a x b) / 6
    }

    void findUnusedVertices() {
        std::vector<bool> used(mesh_.points.size());
        for (const int vertex : mesh_.faceVertices)
            item(used, vertex) = true;
        Findings found;
        for (size_t vertex = 0; vertex < used.size(); ++vertex)
            if (!used[vertex])
                found.add(
                    [&] { return fmt::format("{}: vertex {} belongs to no face", mesh_.name, vertex + 1); });
        found.report(warnings_, ": left out");
    }

    void findTagsWithoutEffect() {
        const size_t count = mesh_.tags.creases.size() + mesh_.tags.corners.size();
        if (!smooth() && count > 0)
            warnings_.push_back(fmt::format("{}: {} creases and corners have no effect under scheme \"none\"",
                                            mesh_.name, count));
    }

    const ControlMesh& mesh_;
    Scheme scheme_;
    std::vector<MeshFace> faces_;
    MeshEdges edges_;
    double size_ = 0;
    std::vector<std::string> warnings_;
};

} // namespace

std::vector<std::string> meshWarnings(const ControlMesh& mesh, Scheme scheme) {
    return DefectFinder(mesh, scheme).find();
}

} // namespace plumbline
