#include "scenes/surface/base_surface.h"

#include "scenes/core/error.h"
#include "scenes/mesh/vertex_normals.h"
#include "scenes/surface/limit_check.h"
#include "scenes/surface/linear_patch.h"
#include "scenes/surface/prepared_faces.h"
#include "scenes/surface/topology.h"

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/bfr/tessellation.h>

#include <array>
#include <cassert>
#include <mutex>
#include <shared_mutex>

namespace plumbline {

namespace {

using namespace OpenSubdiv;

using SurfaceCache = Bfr::SurfaceFactoryCacheThreaded<std::shared_mutex, std::shared_lock<std::shared_mutex>,
                                                      std::unique_lock<std::shared_mutex>>;
using SurfaceFactory = Bfr::RefinerSurfaceFactory<SurfaceCache>;

// Bfr's default level of 2 deviates from the limit surface by up to 1 % of an object's size. At level 10,
// samples at dyadic (u,v) down to 2^-10 are exact to rounding. Beyond 10, OpenSubdiv 3.5 returns wrong
// results.
constexpr int kApproximationLevel = 10;

// The normal is undefined if |S_u x S_v| is below this fraction of |S_u||S_v|. 2^-40 is far above rounding
// (2^-52) and far below the sine for any patch with area.
constexpr double kDegenerateSine = 0x1p-40;

// Where a patch's normal is undefined, the normal at a point this far inside in parameter space is used.
constexpr double kNudge = 0x1p-10;

/// Converts coordinates on sub-face k, into which Bfr splits a triangle under the bilinear scheme, to
/// coordinates on the triangle as a single patch. The barycentric coordinates are interpolated bilinearly
/// from the sub-face's corners.
BaseSurface::FaceTessellation::Sample onTriangle(int patch, int k, double u, double v) {
    const Vec3 corners =
        makeLinearPatch<Vec3>(3, k, false, [](int i) { return Vec3(i == 0, i == 1, i == 2); }).at(u, v);
    return {patch, corners[1], corners[2]};
}

} // namespace

struct BaseSurface::Impl {
    ControlMesh mesh;
    Scheme scheme;
    std::unique_ptr<Far::TopologyRefiner> refiner;
    std::unique_ptr<SurfaceFactory> factory;      // null for Scheme::None
    std::unique_ptr<PreparedFaces> preparedFaces; // likewise
    std::vector<MeshFace> faces;
    std::vector<int> firstPatch; // per face, plus the end; indices into patches
    std::vector<Patch> patches;

    Impl(ControlMesh meshWorld, Scheme schemeOfMesh) : mesh(std::move(meshWorld)), scheme(schemeOfMesh) {
        checkControlMesh(mesh, scheme);
        if (scheme != Scheme::None) checkLimitTopology(mesh);
        refiner = makeTopology(mesh, scheme);
        if (scheme != Scheme::None) {
            Bfr::SurfaceFactory::Options options;
            options.SetApproxLevelSmooth(kApproximationLevel).SetApproxLevelSharp(kApproximationLevel);
            factory = std::make_unique<SurfaceFactory>(*refiner, options);
            preparedFaces = std::make_unique<PreparedFaces>(*factory, mesh);
        } else if (!mesh.hasNormals()) {
            addAngleWeightedNormals(mesh);
        }
        faces = mesh.faces();
        listPatches();
    }

    Bfr::Parameterization parameterization(int face) const {
        return {refiner->GetSchemeType(), item(mesh.faceSizes, face)};
    }

    void listPatches() {
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

    /// False for a face that only supports its neighbors. Throws InputError for any other face without a
    /// limit surface.
    bool hasLimitSurface(int face) const {
        if (!factory || factory->FaceHasLimitSurface(face)) return true;
        if (mesh.boundaryFacesSupportOnly) return false;
        throw InputError(whereOfFace(mesh, face), "OpenSubdiv can't evaluate its limit surface");
    }

    void addPatches(const MeshFace& face) {
        if (scheme == Scheme::Loop || (scheme == Scheme::None && face.size == 3)) {
            patches.push_back({face.index, 0, true, false});
        } else if (face.size == 4) {
            patches.push_back({face.index, 0, false, false});
        } else {
            for (int corner = 0; corner < item(mesh.faceSizes, face.index); ++corner)
                patches.push_back({face.index, corner, false, true});
        }
    }
};

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
    const Bfr::Parameterization parameterization = impl_->parameterization(face);
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

struct BaseSurface::Evaluator::State {
    const BaseSurface::Impl& surface;
    Patch patch{};
    int faceReady = -1;
    std::shared_ptr<const PreparedFace> smooth;
    LinearPatch<Vec3> position, normal; // Scheme::None
    LinearPatch<Vec2> uv;

    explicit State(const BaseSurface::Impl& s) : surface(s) {}

    /// Interpolates an attribute of the face's corners over the patch.
    template <class T>
    LinearPatch<T> linearPatch(const std::vector<T>& values, const std::vector<int>& ofCorners) const {
        const std::span<const int> indices = item(surface.faces, patch.face).of(ofCorners);
        return makeLinearPatch<T>(countOf(indices), patch.subFace ? patch.corner : -1, patch.triangular,
                                  [&](int k) { return item(values, item(indices, k)); });
    }

    void setPatch(const Patch& next) {
        patch = next;
        const ControlMesh& mesh = surface.mesh;
        if (mesh.hasUvs()) uv = linearPatch(mesh.uvs, mesh.faceUvs);
        if (surface.scheme == Scheme::None) {
            position = linearPatch(mesh.points, mesh.faceVertices);
            normal = linearPatch(mesh.normals, mesh.faceNormals);
        } else if (faceReady != patch.face) {
            smooth = surface.preparedFaces->face(patch.face);
            faceReady = patch.face;
        }
    }

    /// Converts patch coordinates to Bfr's, where sub-face k covers half of its own unit tile.
    std::array<double, 2> bfrCoord(double u, double v) const {
        std::array<double, 2> coord{u, v};
        if (patch.subFace) {
            const std::array<double, 2> local{u, v};
            smooth->surface.GetParameterization().ConvertNormalizedSubFaceToCoord(patch.corner, local.data(),
                                                                                  coord.data());
        }
        return coord;
    }
    double coordScale() const { return patch.subFace ? 0.5 : 1.0; } // d(Bfr coordinate) / d(patch coordinate)

    /// Position and first derivatives, without the normal.
    void firstOrder(double u, double v, Vec3& p, Vec3& pu, Vec3& pv) const {
        if (surface.scheme == Scheme::None) {
            p = position.at(u, v);
            pu = position.byU(v);
            pv = position.byV(u);
            return;
        }
        const auto coord = bfrCoord(u, v);
        smooth->surface.Evaluate(coord.data(), smooth->patchPoints.data(), 3, &p.x, &pu.x, &pv.x);
        pu *= coordScale();
        pv *= coordScale();
    }

    Vec3 smoothNormal(double u, double v, const Vec3& pu, const Vec3& pv) const {
        const Vec3 cross = glm::cross(pu, pv);
        const double length = glm::length(cross);
        if (length > kDegenerateSine * glm::length(pu) * glm::length(pv)) return cross / length;
        const double center = patch.triangular ? 1.0 / 3 : 0.5;
        Vec3 p, nudgedU, nudgedV;
        firstOrder(u + kNudge * (center - u), v + kNudge * (center - v), p, nudgedU, nudgedV);
        return unitOrZero(glm::cross(nudgedU, nudgedV));
    }

    BasePoint point(double u, double v) const {
        BasePoint result;
        Vec3 pu, pv;
        firstOrder(u, v, result.position, pu, pv);
        result.normal =
            surface.scheme == Scheme::None ? unitOrZero(normal.at(u, v)) : smoothNormal(u, v, pu, pv);
        result.uv = uv.at(u, v);
        return result;
    }

    BaseSample sample(double u, double v) const {
        BaseSample s;
        s.uv = uv.at(u, v);
        s.uvU = uv.byU(v);
        s.uvV = uv.byV(u);
        Vec3 raw, rawU, rawV; // an unnormalized normal and its derivatives
        if (surface.scheme == Scheme::None) {
            firstOrder(u, v, s.position, s.positionU, s.positionV);
            raw = normal.at(u, v);
            rawU = normal.byU(v);
            rawV = normal.byV(u);
            s.normal = unitOrZero(raw);
        } else {
            Vec3 puu, puv, pvv;
            const auto coord = bfrCoord(u, v);
            smooth->surface.Evaluate(coord.data(), smooth->patchPoints.data(), 3, &s.position.x,
                                     &s.positionU.x, &s.positionV.x, &puu.x, &puv.x, &pvv.x);
            const double scale = coordScale();
            s.positionU *= scale;
            s.positionV *= scale;
            puu *= scale * scale;
            puv *= scale * scale;
            pvv *= scale * scale;
            raw = glm::cross(s.positionU, s.positionV);
            rawU = glm::cross(puu, s.positionV) + glm::cross(s.positionU, puv);
            rawV = glm::cross(puv, s.positionV) + glm::cross(s.positionU, pvv);
            s.normal = smoothNormal(u, v, s.positionU, s.positionV);
        }
        // n = raw / |raw|, so n' is the component of raw' orthogonal to n, divided by |raw|.
        const double length = glm::length(raw);
        const double inverse = length > 0 ? 1 / length : 0;
        s.normalU = (rawU - s.normal * glm::dot(s.normal, rawU)) * inverse;
        s.normalV = (rawV - s.normal * glm::dot(s.normal, rawV)) * inverse;
        return s;
    }
};

BaseSurface::Evaluator::Evaluator(const BaseSurface& surface)
    : state_(std::make_unique<State>(*surface.impl_)) {}
BaseSurface::Evaluator::~Evaluator() = default;
void BaseSurface::Evaluator::setPatch(int patch) {
    state_->setPatch(item(state_->surface.patches, patch));
}
BasePoint BaseSurface::Evaluator::point(double u, double v) const {
    return state_->point(u, v);
}
BaseSample BaseSurface::Evaluator::sample(double u, double v) const {
    return state_->sample(u, v);
}

} // namespace plumbline
