#include "validate/compare/position_space.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr double kBehindPx = 1e9;        // offset of a position that is behind the camera or isn't finite
constexpr size_t kMaxSampleCount = 4096; // pixels evaluated

/// A subset of the covered pixels, evenly spaced in scan order.
std::vector<size_t> sampleCovered(const std::vector<bool>& covered) {
    std::vector<size_t> all;
    for (size_t pixel = 0; pixel < covered.size(); ++pixel)
        if (covered[pixel]) all.push_back(pixel);
    const size_t step = all.size() / kMaxSampleCount + 1;
    std::vector<size_t> chosen;
    for (size_t k = 0; k < all.size(); k += step)
        chosen.push_back(all[k]);
    return chosen;
}

std::vector<PositionSpace> spacesOf(const Camera& camera) {
    const Mat4 zUp(Vec4(1, 0, 0, 0), Vec4(0, 0, -1, 0), Vec4(0, 1, 0, 0), Vec4(0, 0, 0, 1));
    Mat4 flipped(1.0); // pbrt's camera looks along +z
    flipped[2][2] = -1;
    return {{"the world, Y up", Mat4(1.0), 0},
            {"a world with Z up (Blender's importers rotate meshes; (x, z, -y) in ours)", zUp, 0},
            {"pbrt's camera space", glm::inverse(viewFromWorld(camera)) * flipped, 0}};
}

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

std::optional<PositionSpace> findPositionSpace(const std::array<std::span<const float>, 3>& planes,
                                               const std::vector<bool>& covered, const Camera& camera) {
    const std::vector<size_t> samples = sampleCovered(covered);
    if (samples.empty()) return std::nullopt;
    const auto width = static_cast<size_t>(camera.width);
    std::vector<PositionSpace> spaces = spacesOf(camera);
    for (PositionSpace& space : spaces) {
        std::vector<double> offsets;
        for (const size_t pixel : samples) {
            const Vec4 theirs(planes[0][pixel], planes[1][pixel], planes[2][pixel], 1);
            const Vec3 seen = pixelFromWorld(camera, Vec3(space.worldFromTheirs * theirs));
            const double offset = glm::length(Vec2(seen) - pixelCenter(pixel, width));
            offsets.push_back(seen.z > 0 && std::isfinite(offset) ? offset : kBehindPx);
        }
        space.medianOffsetPx = medianOf(std::move(offsets));
    }
    return *std::min_element(spaces.begin(), spaces.end(), [](const auto& a, const auto& b) {
        return a.medianOffsetPx < b.medianOffsetPx;
    });
}

} // namespace plumbline
