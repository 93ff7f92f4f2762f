// What BaseSurface and its evaluators share. Only base_surface.cpp and evaluator.cpp include this header.
#pragma once

#include "scenes/surface/base_surface.h"
#include "scenes/surface/prepared_faces.h"

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <mutex>
#include <shared_mutex>

namespace plumbline {

using LimitSurfaceCache =
    OpenSubdiv::Bfr::SurfaceFactoryCacheThreaded<std::shared_mutex, std::shared_lock<std::shared_mutex>,
                                                 std::unique_lock<std::shared_mutex>>;
using LimitSurfaceFactory = OpenSubdiv::Bfr::RefinerSurfaceFactory<LimitSurfaceCache>;

struct BaseSurface::Impl {
    ControlMesh mesh;
    Scheme scheme;
    std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> refiner;
    std::unique_ptr<LimitSurfaceFactory> factory; // null for Scheme::None
    std::unique_ptr<PreparedFaces> preparedFaces; // likewise
    std::vector<MeshFace> faces;
    std::vector<int> firstPatch; // per face, plus the end; indices into patches
    std::vector<Patch> patches;

    Impl(ControlMesh meshWorld, Scheme schemeOfMesh);

  private:
    void listPatches();
    /// False for a face that only supports its neighbors. Throws InputError for any other face without a
    /// limit surface.
    bool hasLimitSurface(int face) const;
    void addPatches(const MeshFace& face);
};

} // namespace plumbline
