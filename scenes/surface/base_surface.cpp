#include "scenes/surface/base_surface.h"

#include "scenes/core/error.h"
#include "scenes/mesh/cut_faces.h"
#include "scenes/mesh/vertex_normals.h"
#include "scenes/surface/base_surface_impl.h"
#include "scenes/surface/limit_check.h"
#include "scenes/surface/linear_patch.h"
#include "scenes/surface/topology.h"

#include <opensubdiv/bfr/tessellation.h>

#include <cassert>

namespace plumbline {

namespace {

using namespace OpenSubdiv;

// Bfr's default level of 2 deviates from the limit surface by up to 1 % of an object's size. At level 10,
// samples at dyadic (u,v) down to 2^-10 are exact to rounding. Beyond 10, OpenSubdiv 3.5 returns wrong
// results.
constexpr int kApproximationLevel = 10;

/// Converts coordinates on sub-face k, into which Bfr splits a triangle under the bilinear scheme, to
/// coordinates on the triangle as a single patch. The barycentric coordinates are interpolated bilinearly
/// from the sub-face's corners.
BaseSurface::FaceTessellation::Sample onTriangle(int patch, int k, double u, double v) {
    const Vec3 corners =
        makeLinearPatch<Vec3>(3, k, false, [](int i) { return Vec3(i == 0, i == 1, i == 2); }).at(u, v);
    return {patch, corners[1], corners[2]};
}

} // namespace

BaseSurface::Impl::Impl(ControlMesh meshWorld, Scheme schemeOfMesh)
    : mesh(std::move(meshWorld)), scheme(schemeOfMesh) {
    checkControlMesh(mesh, scheme);
    if (scheme != Scheme::None) checkLimitTopology(mesh);
    if (scheme == Scheme::None) {
        if (!mesh.hasNormals()) addAngleWeightedNormals(mesh); // before: they don't depend on the cuts
        cutConcaveFaces(mesh);
    }
    refiner = makeTopology(mesh, scheme);
    if (scheme != Scheme::None) {
        Bfr::SurfaceFactory::Options options;
        options.SetApproxLevelSmooth(kApproximationLevel).SetApproxLevelSharp(kApproximationLevel);
        factory = std::make_unique<LimitSurfaceFactory>(*refiner, options);
        preparedFaces = std::make_unique<PreparedFaces>(*factory, mesh);
    }
    faces = mesh.faces();
    listPatches();
}

void BaseSurface::Impl::listPatches() {
    std::vector<bool> isHole(faces.size());
    for (const SubdivisionTags::Hole& hole : mesh.tags.holes)
        item(isHole, hole.face) = true;
    for (const MeshFace& face : faces) {
        firstPatch.push_back(countOf(patches));
        if (!item(isHole, face.index) && hasLimitSurface(face.index)) addPatches(face);
    }
    firstPatch.push_back(countOf(patches));
    if (patches.empty())
        throw InputError(mesh.name, "no face has a limit surface",
                         "at least one face away from the boundary and no hole");
}

bool BaseSurface::Impl::hasLimitSurface(int face) const {
    if (!factory || factory->FaceHasLimitSurface(face)) return true;
    if (mesh.boundaryFacesSupportOnly) return false;
    throw InputError(whereOfFace(mesh, face), "OpenSubdiv can't evaluate its limit surface");
}

void BaseSurface::Impl::addPatches(const MeshFace& face) {
    if (scheme == Scheme::Loop || (scheme == Scheme::None && face.size == 3)) {
        patches.push_back({face.index, 0, true, false});
    } else if (face.size == 4) {
        patches.push_back({face.index, 0, false, false});
    } else {
        for (int corner = 0; corner < item(mesh.faceSizes, face.index); ++corner)
            patches.push_back({face.index, corner, false, true});
    }
}

BaseSurface::BaseSurface(ControlMesh meshWorld, Scheme scheme)
    : impl_(std::make_unique<Impl>(std::move(meshWorld), scheme)) {
    if (scheme != Scheme::None) checkFacesMeet(*this);
}
BaseSurface::~BaseSurface() = default;

const ControlMesh& BaseSurface::mesh() const {
    return impl_->mesh;
}
const std::vector<BaseSurface::Patch>& BaseSurface::patches() const {
    return impl_->patches;
}
int BaseSurface::vertexCount() const {
    return impl_->refiner->GetLevel(0).GetNumVertices();
}
int BaseSurface::edgeCount() const {
    return impl_->refiner->GetLevel(0).GetNumEdges();
}

std::span<const int> BaseSurface::faceVertices(int face) const {
    const auto vertices = impl_->refiner->GetLevel(0).GetFaceVertices(face);
    return {vertices.begin(), vertices.end()};
}
std::span<const int> BaseSurface::faceEdges(int face) const {
    const auto edges = impl_->refiner->GetLevel(0).GetFaceEdges(face);
    return {edges.begin(), edges.end()};
}
int BaseSurface::edgeStart(int edge) const {
    return impl_->refiner->GetLevel(0).GetEdgeVertices(edge)[0];
}

bool BaseSurface::hasLimit(int face) const {
    return item(impl_->firstPatch, face + 1) > item(impl_->firstPatch, face);
}

int BaseSurface::firstPatch(int face) const {
    assert(hasLimit(face));
    return item(impl_->firstPatch, face);
}

BaseSurface::FaceTessellation BaseSurface::tessellateFace(int face, int rate) const {
    const Bfr::Parameterization parameterization(impl_->refiner->GetSchemeType(),
                                                 item(impl_->mesh.faceSizes, face));
    const Bfr::Tessellation tessellation(parameterization, rate,
                                         Bfr::Tessellation::Options().SetFacetSize(4).PreserveQuads(true));
    const int first = firstPatch(face);
    FaceTessellation result;
    result.boundaryCount = tessellation.GetNumBoundaryCoords();
    std::vector<double> coords(2 * lengthOf(tessellation.GetNumCoords()));
    tessellation.GetCoords(coords.data());
    for (size_t i = 0; i < coords.size(); i += 2) {
        FaceTessellation::Sample sample{first, coords[i], coords[i + 1]};
        if (parameterization.HasSubFaces()) {
            double local[2];
            const int subFace = parameterization.ConvertCoordToNormalizedSubFace(&coords[i], local);
            sample = patch(sample.patch).triangular
                         ? onTriangle(sample.patch, subFace, local[0], local[1])
                         : FaceTessellation::Sample{sample.patch + subFace, local[0], local[1]};
        }
        result.samples.push_back(sample);
    }
    result.facets.resize(lengthOf(tessellation.GetNumFacets()));
    tessellation.GetFacets(result.facets.empty() ? nullptr : result.facets[0].data());
    return result;
}

} // namespace plumbline
