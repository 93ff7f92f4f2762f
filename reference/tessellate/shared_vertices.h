// The micro-vertices that patches share: on the edges and vertices of the control mesh, and on the spokes of
// faces that are divided into sub-faces. Each is computed once, so that the micro-mesh is watertight to the
// bit.
#pragma once

#include "reference/tessellate/lattice.h"
#include "scenes/scene/relief.h"
#include "scenes/surface/base_surface.h"
#include "scenes/surface/shared_samples.h"

#include <vector>

namespace plumbline {

/// World space.
struct MicroVertex {
    Vec3f position{0};
    // Only on request: of the displaced surface and of its base, and st.
    Vec3f normal{0}, baseNormal{0};
    Vec2f st{0};
};

class SharedVertices {
  public:
    /// Vertices are displaced by the mean displacement of the sides that meet there along their mean
    /// direction (scenes/surface/weld.h). This welds the surface where texture coordinates are discontinuous
    /// or a crease has two normals. Under Seams::Open, faces whose positions differ have separate vertices.
    /// `attributes`: also compute normals and st, which are the first face's. Parallel.
    SharedVertices(const BaseSurface& surface, const Relief* relief, const Rates& rates, bool attributes);

    /// The vertex on a side of a patch (numbered like PatchLattice::sides), `segment` segments from the end
    /// where u or v is smaller (on a triangle's hypotenuse: v).
    const MicroVertex& at(int patch, int side, int segment) const;

  private:
    friend class SharedVertexBuilder;

    struct Spokes {
        size_t first;  // into vertices_: spoke k has `cells` vertices from the edge on, without the center
        size_t center; // shared by all spokes
    };

    /// The vertices on an edge that a face doesn't share, as (step, vertex), ascending.
    using OwnVertices = std::vector<std::pair<int, size_t>>;

    OwnVertices& ownVerticesAt(int face, int k);
    size_t onEdge(int face, int k, int step) const;
    size_t onSpoke(int face, int spoke, int step) const;

    const BaseSurface& surface_;
    SharedSamples samples_;
    std::vector<int> faceRates_; // of faces divided into sub-faces; otherwise 0
    std::vector<Spokes> spokes_; // per face
    std::vector<MicroVertex> vertices_;
    // Under Seams::Open: vertices that aren't shared. Otherwise empty.
    std::vector<MeshFace> meshFaces_;
    std::vector<OwnVertices> ownVertices_; // per face corner: of the edge that begins there
};

} // namespace plumbline
