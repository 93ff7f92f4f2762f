#include "scenes/surface/base_surface_impl.h"
#include "scenes/surface/linear_patch.h"
#include "scenes/surface/lone_corner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {

namespace {

using namespace OpenSubdiv;

// Bounds on the rounding errors of S_u and S_v, as fractions of the largest coordinate of the points that
// they are sums of. Those of a limit patch are rounded by 2^-52, differ by 2^-10 of a face at the finest
// level, and their differences are multiplied by 2^10 again; the sums' weights and OpenSubdiv's own take the
// rest. Measured on turned sheets: up to 2^-39.
constexpr double kLimitNoise = 0x1p-36;
constexpr double kPolygonNoise = 0x1p-48;

// Where S_u x S_v is 0, the normal a little inside the patch takes its place: at the first of these fractions
// of the way to the patch's middle at which it isn't 0.
constexpr std::array<double, 4> kNudges{0x1p-10, 0x1p-7, 0x1p-4, 0.5};

// The limit plane of a corner is used where the surface has come as near to it as this cosine (15 degrees) at
// the first of the nudges. Otherwise it only gets there closer to the corner than OpenSubdiv's finest level.
constexpr double kPlaneReached = 0.966;

double largest(const Vec3& point) {
    return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
}

} // namespace

struct BaseSurface::Evaluator::State {
    const BaseSurface::Impl& surface;
    Patch patch{};
    int faceReady = -1;
    std::shared_ptr<const PreparedFace> smooth;
    LinearPatch<Vec3> position, normal; // Scheme::None
    LinearPatch<Vec2> uv;
    double noise = 0; // bound on the rounding errors of S_u and S_v, world units

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
            noise = kPolygonNoise * std::max({largest(position.a), largest(position.b), largest(position.c),
                                              largest(position.d)});
        } else if (faceReady != patch.face) {
            smooth = surface.preparedFaces->face(patch.face);
            noise = kLimitNoise * smooth->largestCoordinate;
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

    /// Whether S_u and S_v are parallel, or one of them is 0, as far as their rounding errors let it be
    /// known.
    bool isSingular(const Vec3& pu, const Vec3& pv) const {
        return !(glm::length(glm::cross(pu, pv)) > noise * (glm::length(pu) + glm::length(pv)));
    }

    /// The face's corner at (u, v) or within a nudge of it; -1 elsewhere.
    int cornerNear(double u, double v) const {
        const double x = std::round(u), y = std::round(v);
        if (std::abs(u - x) > kNudges[0] || std::abs(v - y) > kNudges[0]) return -1;
        if (patch.subFace) return x == 0 && y == 0 ? patch.corner : -1;
        if (patch.triangular) return x == 0 ? (y == 0 ? 0 : 2) : (y == 0 ? 1 : -1);
        return x == 0 ? (y == 0 ? 0 : 3) : (y == 0 ? 1 : 2);
    }

    /// The limit of the normal where S_u x S_v is 0.
    Vec3 singularNormal(double u, double v) const {
        const double center = patch.triangular ? 1.0 / 3 : 0.5;
        Vec3 inside(0);
        for (const double nudge : kNudges) {
            Vec3 p, pu, pv;
            firstOrder(u + nudge * (center - u), v + nudge * (center - v), p, pu, pv);
            inside = unitOrZero(glm::cross(pu, pv));
            if (!isSingular(pu, pv)) break;
        }
        const int corner = cornerNear(u, v);
        if (corner < 0) return inside;
        Vec3 plane = loneCornerNormal(surface.mesh, item(surface.faces, patch.face), *surface.refiner,
                                      static_cast<size_t>(corner));
        if (glm::dot(plane, inside) < 0) plane = -plane; // the surface folds over at a reflex corner
        return glm::dot(plane, inside) >= kPlaneReached ? plane : inside;
    }

    BasePoint point(double u, double v) const {
        BasePoint result;
        Vec3 pu, pv;
        firstOrder(u, v, result.position, pu, pv);
        result.normal = surface.scheme == Scheme::None ? unitOrZero(normal.at(u, v))
                        : isSingular(pu, pv)           ? singularNormal(u, v)
                                                       : unitOrZero(glm::cross(pu, pv));
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
            s.singular = isSingular(s.positionU, s.positionV);
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
            s.singular = isSingular(s.positionU, s.positionV);
            if (s.singular) {
                s.normal = singularNormal(u, v);
                return s;
            }
            raw = glm::cross(s.positionU, s.positionV);
            rawU = glm::cross(puu, s.positionV) + glm::cross(s.positionU, puv);
            rawV = glm::cross(puv, s.positionV) + glm::cross(s.positionU, pvv);
            s.normal = unitOrZero(raw);
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
