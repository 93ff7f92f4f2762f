#include "scenes/draft/draft_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {
namespace {

/// An earlier candidate is kept if it reaches this fraction of the best score: the usual choice is preferred
/// to one that is barely better.
constexpr double kGoodEnough = 0.95;

/// Direction from the object to a camera: from +Z toward +X by the azimuth, then up.
Vec3 viewDirection(double azimuthDegrees, double elevationDegrees) {
    const double azimuth = radians(azimuthDegrees), elevation = radians(elevationDegrees);
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
            std::cos(azimuth) * std::cos(elevation)};
}

/// Projected area of the pieces that face `direction`, as a fraction of the total area.
double shareSeen(const SurfaceSurvey& survey, const Vec3& direction) {
    double seen = 0;
    for (const SurfacePiece& piece : survey.pieces)
        seen += piece.area * std::max(0.0, glm::dot(piece.normal, direction));
    return seen / survey.area;
}

View viewAlong(const Vec3& toCamera) {
    const Vec3 right = glm::normalize(glm::cross(Vec3(0, 1, 0), toCamera));
    return {-toCamera, right, glm::cross(toCamera, right)};
}

/// Places the camera as near as possible such that it looks along `view` and all points lie inside the
/// margin.
///
/// Let x and y be coordinates along right and up, w along forward, c the camera's w, and k the tangent of
/// half the angle inside the margin. A point is inside if |x - cx| <= k (w - c). With a = max(x - k w) and b
/// = max(-x - k w), this means a <= cx - k c and b <= -cx - k c. Such a cx exists if c <= -(a + b) / (2 k);
/// cx = (a - b) / 2 centers the points. The same holds for y.
void placeCamera(Camera& camera, const View& view, const std::vector<Vec3>& points) {
    const double tangentY = std::tan(0.5 * radians(camera.fovYDegrees)) * (1 - 2 * kDraftMargin);
    const Vec2 k(tangentY * camera.width / camera.height, tangentY);
    Vec2 a(-kInfinity), b(-kInfinity);
    Bounds depths;
    for (const Vec3& point : points) {
        const Vec2 across(glm::dot(point, view.right), glm::dot(point, view.up));
        const double w = glm::dot(point, view.forward);
        a = glm::max(a, across - k * w);
        b = glm::max(b, -across - k * w);
        depths.add(Vec3(w));
    }
    const Vec2 farthest = -(a + b) / (2.0 * k), center = 0.5 * (a - b);
    const double c = std::min(farthest.x, farthest.y);
    const Vec3 axis = view.right * center.x + view.up * center.y;
    camera.positionWorld = axis + view.forward * c;
    camera.targetWorld = axis + view.forward * depths.center().x;
}

/// Objects taller than wide get a portrait image.
void chooseFormat(Camera& camera, const View& view, const std::vector<Vec3>& points) {
    Bounds across;
    for (const Vec3& point : points)
        across.add({glm::dot(point, view.right), glm::dot(point, view.up), 0});
    const Vec3 size = across.high - across.low;
    if (size.y > size.x) std::swap(camera.width, camera.height);
}

} // namespace

View chooseView(const SurfaceSurvey& survey, std::string& reason) {
    struct Candidate {
        double azimuth, elevation;
        double share;
    };
    std::vector<Candidate> candidates;
    for (const double elevation : {30.0, -30.0})
        for (const double azimuth : {30.0, -30.0, 60.0, -60.0, 120.0, -120.0, 150.0, -150.0})
            candidates.push_back({azimuth, elevation, shareSeen(survey, viewDirection(azimuth, elevation))});
    const double best = std::ranges::max(candidates, {}, &Candidate::share).share;
    const Candidate& chosen = *std::ranges::find_if(
        candidates, [&](double share) { return share >= kGoodEnough * best; }, &Candidate::share);
    reason = fmt::format(
        "{} degrees {} the horizon, {} degrees off +Z toward {}: the first of 16 views that shows "
        "nearly the largest area.",
        std::abs(chosen.elevation), chosen.elevation > 0 ? "above" : "below", std::abs(chosen.azimuth),
        chosen.azimuth > 0 ? "+X" : "-X");
    return viewAlong(viewDirection(chosen.azimuth, chosen.elevation));
}

void frameWith(Camera& camera, const View& view, const std::vector<Vec3>& points) {
    chooseFormat(camera, view, points);
    placeCamera(camera, view, points);
}

Vec3 chooseLight(const SurfaceSurvey& survey, const View& view, std::string& reason) {
    struct Candidate {
        const char* name;
        double right, up;
        Vec3 toLight{};
        double lit = 0; // mean cosine over the visible surface
    };
    std::array<Candidate, 4> candidates{
        {{"upper left", -1, 1}, {"upper right", 1, 1}, {"lower left", -1, -1}, {"lower right", 1, -1}}};
    const Vec3 toCamera = -view.forward;
    for (Candidate& candidate : candidates) {
        // 0.55 aside, 0.6 up, 0.7 toward the camera: 49 degrees off the view.
        candidate.toLight = glm::normalize(view.right * (0.55 * candidate.right) +
                                           view.up * (0.6 * candidate.up) + toCamera * 0.7);
        double seen = 0;
        for (const SurfacePiece& piece : survey.pieces) {
            const double area = piece.area * std::max(0.0, glm::dot(piece.normal, toCamera));
            seen += area;
            candidate.lit += area * std::max(0.0, glm::dot(piece.normal, candidate.toLight));
        }
        if (seen > 0) candidate.lit /= seen;
    }
    // cos 72.5 degrees: light at a more grazing angle leaves most of a flat relief in shadow.
    constexpr double kLitEnough = 0.3;
    auto chosen = std::ranges::find_if(
        candidates, [](double lit) { return lit >= kLitEnough; }, &Candidate::lit);
    if (chosen == candidates.end()) chosen = std::ranges::max_element(candidates, {}, &Candidate::lit);
    reason =
        fmt::format("Oblique, from the {} of the image, so that the relief casts shadows.", chosen->name);
    return chosen->toLight;
}

} // namespace plumbline
