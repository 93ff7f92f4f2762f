// The base surface S(u,v) of a control mesh under its scheme, with its unit normal n and texture coordinates.
// It is evaluated with OpenSubdiv's Bfr in double precision at approximation level 10, at which samples at
// dyadic (u,v) are on the limit surface.
//
// The surface is a list of patches. A quad face is one patch over the unit square; a triangle under Loop or
// Scheme::None is one patch over u, v >= 0, u + v <= 1; any other face of n corners is n patches over unit
// squares, where patch k has its corners at the face's corner k (0,0), the middle of edge k (1,0), the face's
// center (1,1) and the middle of edge k-1 (0,1).
//
// Space: that of the given mesh, which is world space everywhere in this project. Safe for concurrent use.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <array>
#include <memory>
#include <span>

namespace plumbline {

/// A sample of the base surface at one (u,v).
struct BasePoint {
    Vec3 position;
    Vec3 normal; // unit, outward for counterclockwise faces; zero where undefined
    Vec2 uv;     // of the mesh, not tiled; zero if it has none
};

/// A sample with the derivatives needed for the displaced surface's normal.
struct BaseSample : BasePoint {
    Vec3 positionU, positionV;   // derivatives with respect to the patch's u and v
    Vec3 normalU{0}, normalV{0}; // from the second derivatives of the position; 0 at a singular point of a
                                 // limit surface, where they aren't bounded
    Vec2 uvU, uvV;
    /// S_u and S_v are parallel or 0, to within rounding: at a pole, and at a smooth corner where a face is
    /// alone between two sharp edges. `normal` is the limit of the normals around it.
    bool singular = false;
};

class BaseSurface {
  public:
    struct Patch {
        int face;        // of the control mesh
        int corner;      // k above; 0 for a face with a single patch
        bool triangular; // domain u + v <= 1
        bool subFace;    // one of n patches of its face
    };

    /// Throws InputError (see checkControlMesh), also for topology that OpenSubdiv rejects.
    BaseSurface(ControlMesh meshWorld, Scheme scheme);
    ~BaseSurface();
    BaseSurface(const BaseSurface&) = delete;
    BaseSurface& operator=(const BaseSurface&) = delete;

    const ControlMesh& mesh() const;
    const std::vector<Patch>& patches() const;
    const Patch& patch(int index) const { return item(patches(), index); }

    /// Connectivity of the control mesh. Edge indices are shared by the edge's faces.
    int vertexCount() const;
    int edgeCount() const;
    std::span<const int> faceVertices(int face) const;
    /// Edge k of a face joins its corners k and k+1.
    std::span<const int> faceEdges(int face) const;
    /// The first vertex of an edge. A face whose corner k is the other vertex traverses the edge backwards.
    int edgeStart(int edge) const;

    /// False for a face that only supports its neighbors: a hole, or one of
    /// ControlMesh::boundaryFacesSupportOnly.
    bool hasLimit(int face) const;
    /// Index of a face's first patch; its other patches follow. Only for faces that have a limit surface.
    int firstPatch(int face) const;

    /// A face tessellated with `rate` segments per edge. The first `boundaryCount` samples run around the
    /// face's boundary from corner 0: sample k * rate is corner k. Facets are quads, or triangles with -1 as
    /// the last index, with the same winding as the face.
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

    /// Evaluates one patch at a time. It holds the patch's control points, so reuse it for many samples.
    class Evaluator {
      public:
        explicit Evaluator(const BaseSurface& surface);
        ~Evaluator();
        /// Consecutive patches of the same face share one setup.
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
