#include "scenes/surface/proxy_mesh.h"

#include "scenes/surface/base_surface.h"
#include "scenes/surface/displaced_surface.h"
#include "scenes/surface/shared_samples.h"
#include "scenes/surface/weld.h"

#include <algorithm>

namespace plumbline {

namespace {

// A determinant below this fraction of its largest possible value counts as zero.
constexpr double kSingularFraction = 1e-6;
// Where the parametrization is singular at a corner (a pole), the derivatives are evaluated this far inside
// the patch.
constexpr double kNudge = 0x1p-10;
// Likewise where S_u and S_v are parallel, as at a smooth corner: they spread with the distance from it, and
// frames are interpolated from here across a whole triangle.
constexpr double kSpreadNudge = 0x1p-3;

struct Derivatives {
    Vec3 byS{0}, byT{0}, normalByS{0}, normalByT{0};
};

/// Computes derivatives with respect to s and t from those with respect to u and v and the Jacobian of st.
/// Returns false where the Jacobian is singular.
bool solveDerivatives(const BaseSample& base, const Vec2& tile, Derivatives& result) {
    const Vec2 stU = tile * base.uvU, stV = tile * base.uvV;
    const double determinant = stU.x * stV.y - stU.y * stV.x;
    if (std::abs(determinant) <= kSingularFraction * glm::length(stU) * glm::length(stV)) return false;
    result.byS = (base.positionU * stV.y - base.positionV * stU.y) / determinant;
    result.byT = (base.positionV * stU.x - base.positionU * stV.x) / determinant;
    result.normalByS = (base.normalU * stV.y - base.normalV * stU.y) / determinant;
    result.normalByT = (base.normalV * stU.x - base.normalU * stV.x) / determinant;
    return glm::length(result.byS) > 0 && glm::length(result.byT) > 0;
}

/// Collects proxy vertices. Each refers to its place, a position on the surface that vertices of several
/// faces may share.
class ProxyBuilder {
  public:
    ProxyBuilder(const SceneObject& object, const BaseSurface& surface)
        : relief_(object.relief ? &*object.relief : nullptr), rate_(object.proxyRate), surface_(surface),
          shared_(surface, object.proxyRate), evaluator_(surface), places_(shared_.count()) {}

    ProxyMesh build() {
        for (int face = 0; face < surface_.mesh().faceCount(); ++face)
            if (surface_.hasLimit(face)) addFace(face);
        pushOut();
        fitQuadrics();
        proxy_.placeCount = places_.size();
        return std::move(proxy_);
    }

  private:
    struct Place {
        Vec3 position{0};
        std::vector<Displacement> byFaces; // by the offset, along each face's relief direction
        bool sampled = false;
        std::vector<size_t> ring;
    };

    void addFace(int face) {
        const BaseSurface::FaceTessellation cut = surface_.tessellateFace(face, rate_);
        const size_t first = proxy_.vertices.size();
        for (int i = 0; i < countOf(cut.samples); ++i) {
            size_t place = places_.size();
            if (i < cut.boundaryCount)
                place = shared_.onEdge(face, i / rate_, i % rate_);
            else
                places_.emplace_back();
            addVertex(item(cut.samples, i), place);
        }
        for (const std::array<int, 4>& facet : cut.facets)
            addFacet(facet, first);
    }

    void addVertex(const BaseSurface::FaceTessellation::Sample& at, size_t place) {
        evaluator_.setPatch(at.patch);
        const BaseSample base = evaluator_.sample(at.u, at.v);
        ProxyVertex vertex{};
        vertex.normal = base.normal;
        vertex.st = textureCoordinates(base, relief_);
        vertex.uv = base.uv;
        vertex.place = place;
        const Vec2 tile = relief_ ? relief_->tile : Vec2(1);
        Derivatives derivatives{};
        const bool solved = solveDerivatives(base, tile, derivatives);
        if (!solved || base.singular) {
            const double center = surface_.patch(at.patch).triangular ? 1.0 / 3 : 0.5;
            const double nudge = solved ? kSpreadNudge : kNudge;
            const BaseSample inside =
                evaluator_.sample(at.u + nudge * (center - at.u), at.v + nudge * (center - at.v));
            if (!solveDerivatives(inside, tile, derivatives)) derivatives = Derivatives{};
        }
        vertex.positionS = derivatives.byS;
        vertex.positionT = derivatives.byT;
        // An offset along a constant axis doesn't change the curvature.
        const double offset = relief_ && !relief_->axisWorld ? relief_->offset : 0;
        vertex.limitQuadric = quadricOfDerivatives(derivatives.byS, derivatives.byT, derivatives.normalByS,
                                                   derivatives.normalByT, offset);

        Place& here = places_[place];
        if (!here.sampled) here.position = base.position;
        here.sampled = true;
        here.byFaces.push_back({reliefDirection(base, relief_), relief_ ? relief_->offset : 0});
        proxy_.vertices.push_back(vertex);
    }

    /// Quads are split along the diagonal between their second and fourth corners.
    void addFacet(const std::array<int, 4>& facet, size_t first) {
        const auto index = [&](int k) { return static_cast<unsigned>(first + lengthOf(item(facet, k))); };
        const auto placeOf = [&](unsigned vertex) { return proxy_.vertices[vertex].place; };
        const int corners = facet[3] < 0 ? 3 : 4;
        if (corners == 3)
            proxy_.triangles.insert(proxy_.triangles.end(), {index(0), index(1), index(2)});
        else
            proxy_.triangles.insert(proxy_.triangles.end(),
                                    {index(0), index(1), index(3), index(1), index(2), index(3)});
        for (int i = 0; i < corners; ++i)
            for (int j = 0; j < corners; ++j)
                if (i != j) places_[placeOf(index(i))].ring.push_back(placeOf(index(j)));
    }

    /// Moves each place by the offset along the mean relief direction, once per place, so that the proxy
    /// stays closed.
    void pushOut() {
        const double offset = relief_ ? relief_->offset : 0;
        for (Place& place : places_) {
            Vec3 direction(0);
            for (const Displacement& side : weldedSides(std::move(place.byFaces), std::abs(offset)))
                direction += side.direction;
            const double length = glm::length(direction);
            if (length > 0) place.position += direction * (offset / length);
            std::ranges::sort(place.ring);
            place.ring.erase(std::unique(place.ring.begin(), place.ring.end()), place.ring.end());
        }
        for (ProxyVertex& vertex : proxy_.vertices)
            vertex.position = places_[vertex.place].position;
    }

    void fitQuadrics() {
        std::vector<Vec3> ring;
        for (ProxyVertex& vertex : proxy_.vertices) {
            if (glm::length(vertex.positionS) == 0) continue;
            ring.clear();
            for (const size_t neighbor : places_[vertex.place].ring)
                ring.push_back(places_[neighbor].position);
            vertex.ringQuadric =
                fitQuadric({vertex.position, vertex.positionS, vertex.positionT, vertex.normal}, ring);
        }
    }

    const Relief* relief_;
    int rate_;
    const BaseSurface& surface_;
    SharedSamples shared_;
    BaseSurface::Evaluator evaluator_;
    std::vector<Place> places_;
    ProxyMesh proxy_;
};

} // namespace

ProxyMesh buildProxyMesh(const SceneObject& object) {
    const std::unique_ptr<BaseSurface> surface = makeBaseSurface(object);
    return ProxyBuilder(object, *surface).build();
}

ControlMesh proxyPolygons(const SceneObject& object) {
    const ProxyMesh proxy = buildProxyMesh(object);
    ControlMesh mesh;
    mesh.name = object.mesh.name;
    mesh.faceSizes.assign(proxy.triangles.size() / 3, 3);
    mesh.points.resize(proxy.placeCount); // places of faces without a limit surface stay unused
    for (const ProxyVertex& vertex : proxy.vertices) {
        mesh.points[vertex.place] = vertex.position;
        mesh.normals.push_back(vertex.normal);
        if (object.mesh.hasUvs()) mesh.uvs.push_back(vertex.uv);
    }
    for (const unsigned vertex : proxy.triangles) {
        mesh.faceVertices.push_back(static_cast<int>(proxy.vertices[vertex].place));
        mesh.faceNormals.push_back(static_cast<int>(vertex));
    }
    if (object.mesh.hasUvs()) mesh.faceUvs = mesh.faceNormals;
    return mesh;
}

} // namespace plumbline
