#include "scenes/draft/scene_draft.h"

#include "scenes/core/error.h"
#include "scenes/core/numbers.h"
#include "scenes/draft/draft_view.h"
#include "scenes/mesh/merge_vertices.h"
#include "scenes/scene/scene_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

/// Control cages have fewer faces. A mesh with more is smooth enough already, and computing its limit surface
/// takes minutes.
constexpr int kFineMesh = 20000;
/// Polygons a proxy should have: fine enough for the outline of a simple object, coarse enough for real time.
constexpr int kProxyPolygons = 500;
/// Fraction of the radius: deep enough that search methods make visible errors, shallow enough that the
/// object keeps its shape.
constexpr double kDepthShare = 0.04;
/// The relief depth is at most this fraction of the smallest radius of curvature.
constexpr double kTightShare = 0.5;
/// The width of one repetition of the map, as a fraction of the object's diagonal.
constexpr double kMapShare = 1.0 / 3;
/// Objects whose center is farther from the origin than this many radii are translated there: rays and
/// shaders are single precision, whose errors would become visible (2^-24 of 100 radii is a few thousandths
/// of a pixel).
constexpr double kFarAway = 100;

Scheme chooseScheme(const ControlMesh& mesh, std::string& reason) {
    const auto triangles = std::count(mesh.faceSizes.begin(), mesh.faceSizes.end(), 3);
    if (mesh.faceCount() > kFineMesh) {
        reason = fmt::format("{} faces are fine enough as they are; \"catmull-clark\" or \"loop\" would "
                             "treat them as a control mesh and smooth them.",
                             mesh.faceCount());
        return Scheme::None;
    }
    if (triangles == mesh.faceCount()) {
        reason = "All faces are triangles, which Loop subdivision smooths; \"none\" keeps the polygons as "
                 "they are.";
        return Scheme::Loop;
    }
    reason = fmt::format("Faces with more than three corners ({} of {}): treated as a Catmull-Clark control "
                         "mesh; \"none\" keeps "
                         "the polygons as they are.",
                         mesh.faceCount() - triangles, mesh.faceCount());
    return Scheme::CatmullClark;
}

/// Rounded to two significant digits by formatting and parsing, so that the scene file shows exactly this
/// value.
double rounded(double value) {
    return parseNumber<double>(fmt::format("{:.2g}", value)).value();
}

double chooseDepth(const SurfaceSurvey& survey, std::string& reason) {
    const double share = kDepthShare * survey.radius(), tight = kTightShare * survey.tightRadius;
    reason = share <= tight
                 ? fmt::format("depth: {} % of half the mesh's diagonal.", 100 * kDepthShare)
                 : "depth: half the smallest radius of curvature, so that the relief doesn't self-intersect.";
    return rounded(std::min(share, tight));
}

std::string depthGiven(const SurfaceSurvey& survey, double depth) {
    if (depth <= survey.tightRadius) return "depth: as given.";
    return fmt::format("depth: as given; 5 % of the surface has a radius of curvature below {:.2g}, "
                       "where a relief this deep self-intersects.",
                       survey.tightRadius);
}

/// The highest and the lowest possible point of the relief above each sample.
std::vector<Vec3> reliefHull(const SurfaceSurvey& survey, const HeightMap& map, double depth) {
    std::vector<Vec3> hull;
    for (const BasePoint& sample : survey.samples)
        for (const float d : {map.minDepth(), map.maxDepth()})
            hull.push_back(sample.position - sample.normal * (depth * static_cast<double>(d)));
    return hull;
}

/// Size of a pixel at the object's center, in world units.
double pixelSide(const Camera& camera) {
    const double distance = glm::length(camera.targetWorld - camera.positionWorld);
    return 2 * std::tan(0.5 * radians(camera.fovYDegrees)) * distance / camera.height;
}

/// Describes the texel size that results from a tile, for the scene file's comment.
std::string texelText(const Vec2& uvScale, const Vec2& tile, const HeightMap& map, double pixel) {
    const double s = uvScale.x / std::abs(tile.x) / map.width(),
                 t = uvScale.y / std::abs(tile.y) / map.height();
    return fmt::format("A texel is about {:.2g} x {:.2g} world units, {:.2g} x {:.2g} pixels.", s, t,
                       s / pixel, t / pixel);
}

Vec2 chooseTile(const ControlMesh& mesh, const SurfaceSurvey& survey, const HeightMap& map,
                const Camera& camera, std::string& reason) {
    if (!survey.uvScale)
        throw InputError(mesh.name, "its texture coordinates have no area", "uvs spread over the surface",
                         "--tile S,T doesn't need it");
    const double width = map.width(), height = map.height();
    const double fromObject = kMapShare * 2 * survey.radius(),
                 fromPixels = pixelSide(camera) * std::sqrt(width * height);
    const double side = std::max(fromObject, fromPixels);
    const Vec2 wanted = *survey.uvScale / (side * Vec2(std::sqrt(width / height), std::sqrt(height / width)));
    // Integers, so that the map is continuous where texture coordinates wrap around the mesh. Never below 1:
    // if the uvs themselves repeat, their author intended it.
    Vec2 tile = glm::max(Vec2(1), glm::round(wanted));
    reason = fromObject >= fromPixels ? "tile: one map is about a third of the object, texels about square, "
                                        "integers so that seams are continuous."
                                      : "tile: a texel is about a pixel or larger, texels about square, "
                                        "integers so that seams are continuous.";
    if (map.wrapS() == Wrap::Clamp) tile.x = 1;
    if (map.wrapT() == Wrap::Clamp) tile.y = 1;
    if (map.wrapS() == Wrap::Clamp || map.wrapT() == Wrap::Clamp)
        reason += " A map that clamps is not repeated.";
    return tile;
}

int chooseProxyRate(const SurfaceSurvey& survey, Scheme scheme, std::string& reason) {
    int rate = 1;
    if (scheme == Scheme::None || survey.flat) {
        reason = fmt::format("The polygons real-time techniques get: {}.",
                             survey.flat ? "the surface is flat, so its faces suffice" : "the mesh's own");
        return rate;
    }
    rate = std::clamp(
        static_cast<int>(std::ceil(std::sqrt(kProxyPolygons / static_cast<double>(survey.patchCount)))), 1,
        kMaxProxyRate);
    reason =
        fmt::format("Segments per edge of the polygons real-time techniques get: about {} polygons in all.",
                    survey.patchCount * rate * rate);
    return rate;
}

void requireUsableSize(const ControlMesh& mesh, const Bounds& bounds) {
    constexpr double kLargest = kLargestLength / 100; // the camera is a few object sizes away
    const double size = bounds.diagonal();
    if (!(size >= kSmallestLength && size <= kLargest))
        throw InputError(mesh.name, fmt::format("the mesh is {:.3g} world units large", size),
                         fmt::format("from {} to {}", kSmallestLength, kLargest), "scale it");
}

} // namespace

SceneDraft draftScene(const ControlMesh& mesh, const HeightMap& map, const DraftWishes& wishes) {
    if (!mesh.hasUvs())
        throw InputError(mesh.name, "has no uvs" + (mesh.uvsMissing.empty() ? "" : ": " + mesh.uvsMissing),
                         "a mesh with a uv index at every corner, because uvs place the map");
    Bounds bounds;
    for (const Vec3& point : mesh.points)
        bounds.add(point);
    requireUsableSize(mesh, bounds);

    SceneDraft draft;
    draft.scheme = wishes.scheme ? *wishes.scheme : chooseScheme(mesh, draft.reasons.scheme);
    ControlMesh placed = mesh;
    if (const size_t edges = countEdgesOnEdges(mesh)) {
        draft.merge = true;
        draft.reasons.merge =
            fmt::format("{} boundary edges lie on another one: their vertices are merged, or a "
                        "relief would part the faces.",
                        edges);
        mergeVertices(placed, samePlaceDistance(mesh));
    }
    draft.lengthStep = 5e-4 * bounds.diagonal(); // a quarter of a pixel if the object fills the image
    if (glm::length(bounds.center()) > kFarAway * 0.5 * bounds.diagonal()) {
        draft.translate = -bounds.center();
        draft.reasons.translate = "To the origin: far from it, single precision is coarse.";
        for (Vec3& point : placed.points)
            point += draft.translate;
    }
    const SurfaceSurvey survey = surveySurface(placed, draft.scheme);
    draft.proxyRate = chooseProxyRate(survey, draft.scheme, draft.reasons.proxyRate);
    draft.depth = wishes.depth ? *wishes.depth : chooseDepth(survey, draft.reasons.depth);
    if (wishes.depth) draft.reasons.depth = depthGiven(survey, *wishes.depth);

    const View view = chooseView(survey, draft.reasons.camera);
    const std::vector<Vec3> hull = reliefHull(survey, map, draft.depth);
    frameWith(draft.camera, view, hull);
    draft.reasons.camera += fmt::format(
        " The whole relief is in the image, with a margin of {:.0f} % on each side.", 100 * kDraftMargin);
    draft.toLight = chooseLight(survey, view, draft.reasons.light);
    draft.tile =
        wishes.tile ? *wishes.tile : chooseTile(placed, survey, map, draft.camera, draft.reasons.tile);
    if (wishes.tile) draft.reasons.tile = "tile: as given.";
    if (survey.uvScale)
        draft.reasons.tile +=
            fmt::format(" {}", texelText(*survey.uvScale, draft.tile, map, pixelSide(draft.camera)));
    return draft;
}

} // namespace plumbline
