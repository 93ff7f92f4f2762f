// The micro-vertices that patches share: on the edges and corners of the control mesh, and on the spokes of
// faces that are cut into sub-faces. Each is computed once, so that the micro-triangles close bit for bit.
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
    Vec3f normal{0}; // these two on request only
    Vec2f st{0};
};

class SharedVertices {
  public:
    /// Displaced by the mean of what the faces around say, along the mean of their directions: where texture
    /// coordinates tear the surface, or a crease has two normals, it is welded. Under Seams::Open faces that
    /// disagree about a place each have their own. `attributes`: fill normals and st, the first face's.
    /// Parallel.
    SharedVertices(const BaseSurface& surface, const Relief* relief, const Rates& rates, bool attributes);

    /// On a side of a patch (numbered as PatchLattice::sides), `segment` of its segments from the end where u
    /// or v is smaller (on a triangle's long side: v).
    const MicroVertex& at(int patch, int side, int segment) const;

  private:
    friend class SharedVertexBuilder;

    struct Spokes {
        size_t first;  // into vertices_: spoke k of the face has `cells` of them from the edge on, the center
                       // left out
        size_t center; // one for all spokes
    };

    /// Vertices a face has of its own on an edge, as (step, vertex), ascending.
    using OwnVertices = std::vector<std::pair<int, size_t>>;

    OwnVertices& ownVerticesAt(int face, int k);
    size_t onEdge(int face, int k, int step) const;
    size_t onSpoke(int face, int spoke, int step) const;

    const BaseSurface& surface_;
    SharedSamples samples_;
    std::vector<int> faceRates_; // of faces cut into sub-faces; else 0
    std::vector<Spokes> spokes_; // per face
    std::vector<MicroVertex> vertices_;
    // Under Seams::Open: where a face's vertex isn't the shared one. Else empty.
    std::vector<MeshFace> meshFaces_;
    std::vector<OwnVertices> ownVertices_; // of the edge that starts in each corner of a face
};

} // namespace plumbline
