// The camera of both renderers: a pixel is sampled by the ray through its center.
//
// View space: right-handed, the camera looks down -Z, +Y up. Pixel (0,0) is the top-left one, as in the EXR
// file; pixel centers lie at +0.5. Planar depth Z = -z_view, positive in front of the camera, world units.
#pragma once

#include "scenes/core/math.h"

#include <cstddef>

namespace plumbline {

struct Camera {
    enum class Projection { Perspective, Orthographic };

    Vec3 positionWorld{0, 0, 3};
    Vec3 targetWorld{0, 0, 0};
    Vec3 upWorld{0, 1, 0};
    Projection projection = Projection::Perspective;
    double fovYDegrees = 40; // perspective: vertical field of view
    double viewHeight = 2;   // orthographic: world units from the bottom to the top of the picture
    int width = 800;         // pixels
    int height = 600;

    bool operator==(const Camera&) const = default;
};

/// World to view space: a rotation and a translation.
Mat4 viewFromWorld(const Camera& camera);

/// View to clip space of OpenGL (NDC z in [-1,1]); `near` and `far` are planar depths, 0 < near < far.
/// NDC x = -1 is the left edge of the picture and y = +1 its top.
Mat4 clipFromView(const Camera& camera, double near, double far);

/// Pixels and planar depth of a world point: x right, y down, (0.5, 0.5) the center of the top-left pixel;
/// z is the planar depth (<= 0 for points behind a perspective camera, where x and y are meaningless).
Vec3 pixelFromWorld(const Camera& camera, const Vec3& positionWorld);

/// Center of the pixel with that index in a picture `width` pixels wide, rows from the top: in pixels, as
/// CameraRays::ray takes it.
inline Vec2 pixelCenter(size_t pixel, size_t width) {
    const size_t column = pixel % width, row = pixel / width;
    return {static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
}

/// Generates rays for many pixels; the basis is computed once.
class CameraRays {
  public:
    explicit CameraRays(const Camera& camera);
    /// Ray through (x, y) in pixels; pass i + 0.5 for a center. Perspective rays start at the camera,
    /// orthographic rays on the camera plane.
    Ray ray(double x, double y) const;
    Ray ray(const Vec2& pixel) const { return ray(pixel.x, pixel.y); }
    /// Planar depth of a world point.
    double planarDepth(const Vec3& positionWorld) const {
        return glm::dot(positionWorld - origin_, forward_);
    }
    /// Unit vector from a world point toward the camera.
    Vec3 towardCamera(const Vec3& positionWorld) const;

  private:
    Vec3 origin_, right_, up_, forward_; // right_ and up_ span one pixel (perspective: at unit depth)
    double centerX_, centerY_;           // pixels
    bool perspective_;
};

} // namespace plumbline
