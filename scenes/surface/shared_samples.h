// Numbers the samples that faces of a mesh share: a vertex or a point on an edge has the same number for
// every incident face, so that its position is computed once and surfaces are watertight.
#pragma once

#include "scenes/surface/base_surface.h"

#include <cassert>
#include <vector>

namespace plumbline {

class SharedSamples {
  public:
    /// `edgeRates`: segments of each edge.
    SharedSamples(const BaseSurface& surface, std::vector<int> edgeRates)
        : surface_(surface), rates_(std::move(edgeRates)) {
        firstOfEdge_.reserve(rates_.size() + 1);
        firstOfEdge_.push_back(lengthOf(surface.vertexCount()));
        for (const int rate : rates_)
            firstOfEdge_.push_back(firstOfEdge_.back() + lengthOf(rate - 1));
    }
    /// The same for all edges.
    SharedSamples(const BaseSurface& surface, int rate)
        : SharedSamples(surface, std::vector<int>(lengthOf(surface.edgeCount()), rate)) {}

    /// The number of samples; all sample numbers are below it.
    size_t count() const { return firstOfEdge_.back(); }
    int edgeRate(int edge) const { return item(rates_, edge); }
    /// Number of the sample `step` segments (0 … the edge's rate) along edge k of a face, from its corner k.
    size_t onEdge(int face, int k, int step) const {
        const std::span<const int> vertices = surface_.faceVertices(face);
        const int edge = item(surface_.faceEdges(face), k), rate = edgeRate(edge);
        assert(step >= 0 && step <= rate);
        if (step == 0) return lengthOf(item(vertices, k));
        if (step == rate) return lengthOf(item(vertices, (k + 1) % countOf(vertices)));
        const int fromStart = item(vertices, k) == surface_.edgeStart(edge) ? step : rate - step;
        return item(firstOfEdge_, edge) + lengthOf(fromStart - 1);
    }

  private:
    const BaseSurface& surface_;
    std::vector<int> rates_;
    std::vector<size_t> firstOfEdge_;
};

} // namespace plumbline
