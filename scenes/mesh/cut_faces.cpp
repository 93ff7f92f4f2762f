#include "scenes/mesh/cut_faces.h"

#include "scenes/core/error.h"
#include "scenes/mesh/findings.h"
#include "scenes/mesh/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>

namespace plumbline {

namespace {

/// Corners of a face of the mesh, as indices into its faceVertices.
using Corners = std::vector<size_t>;

/// Replaces a mesh's faces one after another, with all that is stored for each of them or for its corners.
class FaceRebuilder {
  public:
    explicit FaceRebuilder(ControlMesh& mesh) : mesh_(mesh), firstNewFace_{0} {}

    void add(const MeshFace& face, const Corners& corners) {
        sizes_.push_back(countOf(corners));
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        lines_.push_back(mesh_.faceLines.empty() ? 0 : item(mesh_.faceLines, face.index));
        numbers_.push_back(faceNumber(mesh_, face.index));
    }
    void keep(const MeshFace& face) {
        Corners corners(face.size);
        std::iota(corners.begin(), corners.end(), face.firstCorner);
        add(face, corners);
    }
    /// After the last part of each face.
    void endFace() { firstNewFace_.push_back(countOf(sizes_)); }

    void finish() {
        rebuild(mesh_.faceVertices);
        rebuild(mesh_.faceUvs);
        rebuild(mesh_.faceNormals);
        mesh_.faceSizes = std::move(sizes_);
        if (!mesh_.faceLines.empty()) mesh_.faceLines = std::move(lines_);
        mesh_.faceNumbers = std::move(numbers_);
        std::vector<SubdivisionTags::Hole> holes;
        for (const SubdivisionTags::Hole& hole : mesh_.tags.holes) {
            if (hole.face < 0 || hole.face + 1 >= countOf(firstNewFace_)) {
                holes.push_back(hole); // isn't in the mesh, as checkControlMesh says
                continue;
            }
            for (int face = item(firstNewFace_, hole.face); face < item(firstNewFace_, hole.face + 1); ++face)
                holes.push_back({face, hole.line});
        }
        mesh_.tags.holes = std::move(holes);
    }

  private:
    void rebuild(std::vector<int>& ofCorners) const {
        if (ofCorners.empty()) return;
        std::vector<int> result;
        result.reserve(corners_.size());
        for (const size_t corner : corners_)
            result.push_back(ofCorners[corner]);
        ofCorners = std::move(result);
    }

    ControlMesh& mesh_;
    std::vector<int> sizes_, lines_, numbers_, firstNewFace_;
    Corners corners_;
};

void requireCuttable(const ControlMesh& mesh, int face, size_t corners) {
    if (corners > kMaxConcaveCorners)
        throw InputError(whereOfFace(mesh, face), fmt::format("{} corners and a concave outline", corners),
                         fmt::format("at most {}", kMaxConcaveCorners), "cut it into several");
}

/// Whether all arrays are long enough and the face's vertices in range; checkControlMesh explains what isn't.
bool isReadable(const ControlMesh& mesh) {
    size_t corners = 0;
    for (const int size : mesh.faceSizes)
        corners += size < 0 ? 0 : static_cast<size_t>(size);
    const auto fits = [&](const std::vector<int>& ofCorners, bool optional) {
        return ofCorners.size() == corners || (optional && ofCorners.empty());
    };
    return fits(mesh.faceVertices, false) && fits(mesh.faceUvs, true) && fits(mesh.faceNormals, true) &&
           std::ranges::all_of(mesh.faceVertices, [&](int vertex) {
               return vertex >= 0 && std::cmp_less(vertex, mesh.points.size());
           });
}

class FaceRepairer {
  public:
    explicit FaceRepairer(ControlMesh& mesh) : mesh_(mesh), rebuilder_(mesh) {}

    void repair() {
        const std::vector<MeshFace> faces = mesh_.faces();
        if (std::ranges::none_of(faces, [&](const MeshFace& face) { return repeated(cornersOf(face)) >= 0; }))
            return;
        for (const MeshFace& face : faces) {
            repair(face);
            rebuilder_.endFace();
        }
        rebuilder_.finish();
        if (mesh_.faceSizes.empty())
            throw InputError(drops_.first, "and no other face is left", "faces of different vertices");
        repeats_.report(mesh_.warnings, ": once counts");
        cuts_.report(mesh_.warnings, ": it is cut into triangles");
        drops_.report(mesh_.warnings, ": it is left out");
    }

  private:
    int vertexAt(size_t corner) const { return mesh_.faceVertices[corner]; }

    static Corners cornersOf(const MeshFace& face) {
        Corners corners(face.size);
        std::iota(corners.begin(), corners.end(), face.firstCorner);
        return corners;
    }

    /// A vertex that occurs more than once; -1 if there is none.
    int repeated(const Corners& corners) const {
        std::vector<int> vertices;
        for (const size_t corner : corners)
            vertices.push_back(vertexAt(corner));
        std::ranges::sort(vertices);
        const auto twice = std::ranges::adjacent_find(vertices);
        return twice == vertices.end() ? -1 : *twice;
    }

    void repair(const MeshFace& face) {
        Corners corners = cornersOf(face);
        if (face.size < 3 || repeated(corners) < 0) return rebuilder_.keep(face);
        const auto describe = [&, vertex = repeated(corners)] {
            return fmt::format("{} names vertex {} twice", whereOfFace(mesh_, face.index), vertex + 1);
        };
        shorten(corners);
        if (corners.size() < 3) return drops_.add(describe);
        if (repeated(corners) < 0) {
            repeats_.add(describe);
            return rebuilder_.add(face, corners);
        }
        requireCuttable(mesh_, face.index, corners.size());
        const Outline outline = outlineOf(asMesh(corners), {0, 0, corners.size()});
        if (outline.kind != OutlineKind::Concave) return drops_.add(describe);
        const auto triangles = cutOutline(outline.points);
        if (triangles.empty()) return drops_.add(describe);
        cuts_.add(describe);
        std::set<std::array<int, 3>> seen; // an outline may go around twice
        for (const auto& [a, b, c] : triangles)
            if (seen.insert(rotated(vertexAt(corners[a]), vertexAt(corners[b]), vertexAt(corners[c]))).second)
                rebuilder_.add(face, {corners[a], corners[b], corners[c]});
    }

    /// The same for a triangle whichever vertex it begins with.
    static std::array<int, 3> rotated(int a, int b, int c) {
        std::array<int, 3> vertices{a, b, c};
        std::rotate(vertices.begin(), std::ranges::min_element(vertices), vertices.end());
        return vertices;
    }

    /// Removes vertices that follow themselves, and edges there and back. What precedes a removed corner is
    /// looked at again, so that a path there and back shrinks from its end.
    void shorten(Corners& corners) const {
        Corners kept;
        const auto isSpike = [&](const Corners& at) {
            return at.size() >= 3 && vertexAt(at.back()) == vertexAt(at[at.size() - 3]);
        };
        for (const size_t corner : corners) {
            if (!kept.empty() && vertexAt(kept.back()) == vertexAt(corner)) continue;
            kept.push_back(corner);
            if (isSpike(kept)) kept.resize(kept.size() - 2);
        }
        // The same where the end meets the beginning.
        size_t first = 0;
        for (bool changed = true; changed && kept.size() - first >= 2;) {
            changed = true;
            const size_t last = kept.size() - 1;
            const auto same = [&](size_t a, size_t b) { return vertexAt(kept[a]) == vertexAt(kept[b]); };
            const bool canSpike = last - first >= 2;
            if (same(last, first) || (canSpike && same(last - 1, first)))
                kept.pop_back();
            else if (canSpike && same(last, first + 1))
                ++first; // the first one is a spike's end
            else
                changed = false;
        }
        corners.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
    }

    /// A mesh of one face.
    ControlMesh asMesh(const Corners& corners) const {
        ControlMesh one;
        one.faceSizes = {countOf(corners)};
        for (const size_t corner : corners) {
            one.faceVertices.push_back(countOf(one.points));
            one.points.push_back(item(mesh_.points, vertexAt(corner)));
        }
        return one;
    }

    ControlMesh& mesh_;
    FaceRebuilder rebuilder_;
    Findings repeats_, cuts_, drops_;
};

} // namespace

void repairFaces(ControlMesh& mesh) {
    if (isReadable(mesh)) FaceRepairer(mesh).repair();
}

void cutConcaveFaces(ControlMesh& mesh) {
    const std::vector<MeshFace> faces = mesh.faces();
    std::vector<Outline> outlines;
    for (const MeshFace& face : faces) {
        outlines.push_back(outlineOf(mesh, face));
        if (outlines.back().kind == OutlineKind::Concave) requireCuttable(mesh, face.index, face.size);
    }
    if (std::ranges::all_of(outlines, [](const Outline& o) { return o.kind == OutlineKind::Convex; })) return;
    FaceRebuilder rebuilder(mesh);
    for (const MeshFace& face : faces) {
        const Outline& outline = item(outlines, face.index);
        if (outline.kind == OutlineKind::Convex) {
            rebuilder.keep(face);
        } else if (outline.kind == OutlineKind::Concave) {
            for (const auto& [a, b, c] : cutOutline(outline.points))
                rebuilder.add(face, {face.corner(a), face.corner(b), face.corner(c)});
        }
        rebuilder.endFace();
    }
    rebuilder.finish();
    if (mesh.faceSizes.empty())
        throw InputError(mesh.name, "the outlines of all faces cross themselves", "a face with an inside");
}

} // namespace plumbline
