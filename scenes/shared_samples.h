// Numbers for the samples faces of a mesh share, at one rate for all edges: a vertex, or a place on an edge,
// has one number whichever face it is reached from, so that what is computed there is computed once and
// surfaces close.
#pragma once

#include "base_surface.h"

namespace plumbline {

class SharedSamples {
  public:
    SharedSamples(const BaseSurface& surface, int rate) : surface_(surface), rate_(rate) {}

    /// All numbers are below this.
    size_t count() const {
        return static_cast<size_t>(surface_.vertexCount()) +
               static_cast<size_t>(surface_.edgeCount()) * static_cast<size_t>(rate_ - 1);
    }
    /// Number of the sample `step` segments (0 … rate) along edge k of a face, from its corner k.
    size_t onEdge(int face, int k, int step) const {
        const std::span<const int> vertices = surface_.faceVertices(face);
        const size_t corner = static_cast<size_t>(k);
        if (step == 0) return static_cast<size_t>(vertices[corner]);
        if (step == rate_) return static_cast<size_t>(vertices[(corner + 1) % vertices.size()]);
        const int edge = surface_.faceEdges(face)[corner];
        const int fromStart = vertices[corner] == surface_.edgeStart(edge) ? step : rate_ - step;
        return static_cast<size_t>(surface_.vertexCount()) +
               static_cast<size_t>(edge) * static_cast<size_t>(rate_ - 1) +
               static_cast<size_t>(fromStart - 1);
    }

  private:
    const BaseSurface& surface_;
    int rate_;
};

} // namespace plumbline
