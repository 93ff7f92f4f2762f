#include "scenes/surface/prepared_faces.h"

#include "scenes/core/error.h"
#include "scenes/core/index.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
PreparedFaces::PreparedFaces(const OpenSubdiv::Bfr::SurfaceFactory& factory, const ControlMesh& mesh)
    : factory_(factory), mesh_(mesh), kept_(mesh.faceSizes.size()) {}

std::shared_ptr<const PreparedFace> PreparedFaces::face(int index) {
    if (auto ready = item(kept_, index).load()) return ready;
    auto prepared = prepare(index);
    // Regular faces are prepared in less time than it takes to evaluate them a few times.
    if (!prepared->surface.IsRegular()) keep(index, prepared);
    return prepared;
}

std::shared_ptr<const PreparedFace> PreparedFaces::prepare(int index) const {
    auto prepared = std::make_shared<PreparedFace>();
    auto& [surface, patchPoints, largestCoordinate] = *prepared;
    if (!factory_.InitVertexSurface(index, &surface))
        throw InputError(whereOfFace(mesh_, index), "OpenSubdiv can't evaluate its limit surface");
    patchPoints.resize(3 * lengthOf(surface.GetNumPatchPoints()));
    const OpenSubdiv::Bfr::Surface<double>::PointDescriptor xyz(3);
    surface.PreparePatchPoints(&mesh_.points[0].x, xyz, patchPoints.data(), xyz);
    for (const double coordinate : patchPoints)
        largestCoordinate = std::max(largestCoordinate, std::abs(coordinate));
    return prepared;
}

void PreparedFaces::keep(int index, const std::shared_ptr<const PreparedFace>& prepared) {
    const uint64_t bytes = prepared->bytes();
    std::shared_ptr<const PreparedFace> none;
    if (keptBytes_.fetch_add(bytes) + bytes > kMaxKeptBytes ||
        !item(kept_, index).compare_exchange_strong(none, prepared))
        keptBytes_ -= bytes;
}

} // namespace plumbline
