#include "reference/rates/face_role.h"

#include "reference/trace/screen.h"
#include "scenes/core/contains.h"
#include "scenes/scene/camera.h"
#include "scenes/surface/displaced_surface.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {

namespace {

// Segments per edge at whose ends a face is sampled.
constexpr int kSegments = 4;
// Factor by which the bounding sphere of the samples is enlarged, because the surface bulges between them.
constexpr double kBulge = 1.25;
// Cosine between normal and view direction below which a face of a closed object counts as hidden despite its
// relief. Slopes of a relief are rarely steeper, and the certificate reports it if they are.
constexpr double kBackFacingCosine = -0.35;

struct Ball {
    Vec3 center{0};
    double radius = 0;
};

/// Half-spaces of the view volume: inside is normal . p >= offset.
struct Halfspace {
    Vec3 normal;
    double offset;
    double above(const Vec3& p) const { return glm::dot(normal, p) - offset; }
};

std::vector<Halfspace> viewVolume(const Camera& camera) {
    const CameraRays rays(camera);
    const double w = camera.width, h = camera.height;
    const Ray corners[4] = {rays.ray(0, 0), rays.ray(w, 0), rays.ray(w, h), rays.ray(0, h)};
    const Ray middle = rays.ray(0.5 * w, 0.5 * h);
    std::vector<Halfspace> volume{{middle.direction, glm::dot(middle.direction, camera.positionWorld)}};
    for (int k = 0; k < 4; ++k) {
        const Ray &one = corners[k], &next = corners[(k + 1) % 4];
        Vec3 normal = glm::cross(one.direction, next.at(1) - one.origin);
        const double length = glm::length(normal);
        if (!(length > 0)) continue;
        normal /= length;
        if (glm::dot(normal, middle.at(1) - one.origin) < 0) normal = -normal;
        volume.push_back({normal, glm::dot(normal, one.origin)});
    }
    return volume;
}

bool isOutside(const Ball& ball, const std::vector<Halfspace>& volume) {
    return std::ranges::any_of(volume,
                               [&](const Halfspace& half) { return half.above(ball.center) < -ball.radius; });
}

/// Whether a ball's shadow can reach the volume. It can't if the ball is outside a plane and its shadow
/// extends away from it.
bool shadowReaches(const Ball& ball, const Light& light, const std::vector<Halfspace>& volume) {
    return std::ranges::none_of(volume, [&](const Halfspace& half) {
        if (half.above(ball.center) >= -ball.radius) return false;
        if (light.kind == Light::Kind::Directional) return glm::dot(half.normal, light.toLightWorld) >= 0;
        return half.above(light.positionWorld) - half.above(ball.center) >=
               ball.radius; // the light isn't farther outside than the ball
    });
}

class Placer {
  public:
    Placer(const Scene& scene, const BaseSurface& surface, const Relief* relief)
        : scene_(scene), surface_(surface), relief_(relief), rays_(scene.camera),
          screen_(Screen::ofCamera(scene.camera)), volume_(viewVolume(scene.camera)),
          hidesBackFaces_(isClosed(surface) && !(relief && relief->axisWorld)) {
        if (!relief) return;
        low_ = relief->offset - relief->depth * relief->map->maxDepth();
        high_ = relief->offset - relief->depth * relief->map->minDepth();
    }

    FacePlace place(int face, BaseSurface::Evaluator& evaluator) const {
        FacePlace result;
        Bounds bounds;
        std::vector<Vec3> points;
        bool backFacing = hidesBackFaces_;
        for (const auto& at : surface_.tessellateFace(face, kSegments).samples) {
            evaluator.setPatch(at.patch);
            const BasePoint base = evaluator.point(at.u, at.v);
            for (const double height : {low_, high_}) {
                points.push_back(base.position + reliefDirection(base, relief_) * height);
                bounds.add(points.back());
            }
            backFacing &= glm::dot(base.normal, rays_.towardCamera(base.position)) < kBackFacingCosine;
        }
        Ball ball{bounds.center(), 0};
        for (const Vec3& point : points)
            ball.radius = std::max(ball.radius, kBulge * glm::length(point - ball.center));
        if (!backFacing && !isOutside(ball, volume_)) {
            result.role = FaceRole::Seen;
            result.pixelsPerWorld = nearestScale(points, ball.radius);
        } else if (std::ranges::any_of(scene_.lights, [&](const Light& light) {
                       return shadowReaches(ball, light, volume_);
                   })) {
            result.role = FaceRole::Casts;
        }
        return result;
    }

  private:
    static bool isClosed(const BaseSurface& surface) {
        std::vector<int> uses(lengthOf(surface.edgeCount()), 0);
        for (int face = 0; face < surface.mesh().faceCount(); ++face)
            if (surface.hasLimit(face))
                for (const int edge : surface.faceEdges(face))
                    ++item(uses, edge);
        return !contains(uses, 1);
    }

    /// The largest scale of the points, with distances to the camera bounded below by a fraction of the
    /// face's size.
    double nearestScale(const std::vector<Vec3>& points, double radius) const {
        constexpr double kNearestOfRadius = 0.1;
        double largest = 0;
        for (const Vec3& point : points) {
            Vec3 at = screen_.project(point);
            at.z = std::max(at.z, kNearestOfRadius * radius);
            // Perspective stretches lengths off the axis, at most as much as at the image's corner.
            const Vec2 half(scene_.camera.width, scene_.camera.height);
            const Vec2 clamped = glm::clamp(Vec2(at), Vec2(0), half);
            largest = std::max(largest, screen_.pixelsPerWorld({clamped.x, clamped.y, at.z}));
        }
        return largest;
    }

    const Scene& scene_;
    const BaseSurface& surface_;
    const Relief* relief_;
    CameraRays rays_;
    Screen screen_;
    std::vector<Halfspace> volume_;
    bool hidesBackFaces_; // closed, and P is oriented roughly like its base: not along an axis
    double low_ = 0, high_ = 0;
};

} // namespace

std::vector<FacePlace> placeFaces(const Scene& scene, const BaseSurface& surface, const Relief* relief) {
    const Placer placer(scene, surface, relief);
    std::vector<FacePlace> places(lengthOf(surface.mesh().faceCount()));
    tbb::parallel_for(tbb::blocked_range<int>(0, surface.mesh().faceCount()),
                      [&](const tbb::blocked_range<int>& faces) {
                          BaseSurface::Evaluator evaluator(surface);
                          for (int face = faces.begin(); face < faces.end(); ++face)
                              if (surface.hasLimit(face)) item(places, face) = placer.place(face, evaluator);
                      });
    return places;
}

} // namespace plumbline
