// The base surface S(u,v) with its unit normal n and texture coordinates, of the control mesh under its
// scheme: OpenSubdiv's Bfr in double precision, refined so far (level 10) that samples at dyadic (u,v) are on
// the limit surface.
//
// The surface is a list of patches. A quad face is one patch over the unit square; a triangle under Loop or
// Scheme::None is one patch over u, v >= 0, u + v <= 1; any other face of n corners is n patches over unit
// squares, patch k going from corner k (0,0) to the middle of edge k (1,0), the face's center (1,1) and the
// middle of edge k-1 (0,1).
//
// Space: that of the mesh given, which is world space everywhere in this project. Safe to use from many
// threads.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <array>
#include <memory>
#include <span>

namespace plumbline {

/// The base at one (u,v).
struct BasePoint {
    Vec3 position;
    Vec3 normal; // unit, outward for counter-clockwise faces; zero where the surface has none
    Vec2 uv;     // of the mesh, not tiled; zero if it has none
};

/// The base at one (u,v) with everything the displaced surface's own normal needs.
struct BaseSample : BasePoint {
    Vec3 positionU, positionV; // derivatives by the patch's u and v
    Vec3 normalU, normalV;     // from the second derivatives of the position
    Vec2 uvU, uvV;
};

class BaseSurface {
  public:
    struct Patch {
        int face;        // of the control mesh
        int corner;      // k above; 0 for a face that is one patch
        bool triangular; // domain u + v <= 1
        bool subFace;    // one of n patches of its face
    };

    /// Throws InputError (see checkControlMesh), and for topology OpenSubdiv refuses.
    BaseSurface(ControlMesh meshWorld, Scheme scheme);
    ~BaseSurface();
    BaseSurface(const BaseSurface&) = delete;
    BaseSurface& operator=(const BaseSurface&) = delete;

    const ControlMesh& mesh() const;
    const std::vector<Patch>& patches() const;
    const Patch& patch(int index) const { return item(patches(), index); }

    /// Connectivity of the control mesh. An edge is shared by the faces that name it.
    int vertexCount() const;
    int edgeCount() const;
    std::span<const int> faceVertices(int face) const;
    /// Edge k of a face joins its corners k and k+1.
    std::span<const int> faceEdges(int face) const;
    /// Vertex an edge starts from; a face whose corner k is not this vertex runs along the edge backwards.
    int edgeStart(int edge) const;

    /// False for a face that only supports its neighbors: a hole, or one of
    /// ControlMesh::boundaryFacesSupportOnly.
    bool hasLimit(int face) const;
    /// Index of a face's first patch; its others follow. Only for a face that has a limit.
    int firstPatch(int face) const;

    /// A face cut into facets at `rate` segments an edge. The first `boundaryCount` samples run round the
    /// face from corner 0: sample k * rate is corner k. Facets are quads, or triangles with -1 last;
    /// counter-clockwise like the face.
    struct FaceTessellation {
        struct Sample {
            int patch;
            double u, v;
        };
        std::vector<Sample> samples;
        int boundaryCount = 0;
        std::vector<std::array<int, 4>> facets;
    };
    FaceTessellation tessellateFace(int face, int rate) const;

    /// Evaluates one patch; holds the patch's control points, so make one and evaluate many samples.
    class Evaluator {
      public:
        explicit Evaluator(const BaseSurface& surface);
        ~Evaluator();
        /// Patches of one face in sequence cost one set-up.
        void setPatch(int patch);
        BasePoint point(double u, double v) const;
        BaseSample sample(double u, double v) const;

      private:
        struct State;
        std::unique_ptr<State> state_;
    };

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace plumbline
