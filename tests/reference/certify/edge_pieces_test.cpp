// Pieces of contour edges: short on the screen, everywhere the edge is near the picture, and nowhere else.
#include "reference/certify/edge_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plumbline {
namespace {

constexpr int kWidth = 64, kHeight = 48;

Camera cameraAt(const Vec3& position, Camera::Projection projection) {
    Camera camera;
    camera.width = kWidth;
    camera.height = kHeight;
    camera.positionWorld = position;
    camera.targetWorld = Vec3(0);
    camera.projection = projection;
    camera.viewHeight = 3;
    return camera;
}

std::vector<EdgePiece> piecesOf(const Screen& screen, const ContourEdge& edge) {
    std::vector<EdgePiece> pieces;
    forEachPiece(screen, edge, Vec2(kWidth, kHeight),
                 [&](const EdgePiece& piece) { pieces.push_back(piece); });
    return pieces;
}

double distanceToPicture(const Vec2& pixel) {
    return glm::length(glm::max(glm::max(-pixel, pixel - Vec2(kWidth, kHeight)), Vec2(0)));
}

/// Where the edges below pass the picture, as a share of their length.
constexpr double kThroughShare = 1 / 1.37;

/// From `scale` far away to the other side of the picture and beyond.
ContourEdge edgeThrough(std::mt19937& random, double scale, double errorWorld) {
    std::normal_distribution<double> normal;
    const auto direction = [&] {
        return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
    };
    const Vec3 through = 0.7 * direction(), along = direction();
    return {through - along * scale, through + along * (scale * (1 / kThroughShare - 1)),
            through + direction(), errorWorld};
}

class EdgePiecesScales : public testing::TestWithParam<std::tuple<Camera::Projection, double>> {};

TEST_P(EdgePiecesScales, cover_exactly_what_is_near_the_picture_in_short_pieces) {
    const auto [projection, scale] = GetParam();
    const Screen screen = Screen::ofCamera(cameraAt({1, 2, 3}, projection));
    std::mt19937 random(7);
    int inPicture = 0;
    for (int run = 0; run < 200; ++run) {
        const ContourEdge edge = edgeThrough(random, scale, 0.01);
        const auto pieces = piecesOf(screen, edge);
        double length = 0;
        for (const EdgePiece& piece : pieces) {
            length += glm::length(Vec2(piece.b - piece.a));
            // Half a pixel or a quarter of the largest reach of the edge, which isn't the piece's own.
            EXPECT_LE(glm::length(Vec2(piece.b - piece.a)),
                      std::max(0.5, 0.25 * std::hypot(kWidth, kHeight)) * (1 + 1e-6));
        }
        // Across the picture, and a reach of at most a diagonal on both sides.
        EXPECT_LE(length, 3 * std::hypot(kWidth, kHeight) * std::numbers::sqrt2) << run;
        EXPECT_LE(pieces.size(), 2 * 3 * std::hypot(kWidth, kHeight) * std::numbers::sqrt2) << run;
        for (int i = 0; i <= 1000; ++i) {
            const double share =
                kThroughShare + std::min(0.5, 3 / scale) * (i / 500.0 - 1); // near the picture
            const Vec3 world = glm::mix(edge.a, edge.b, std::clamp(share, 0.0, 1.0)),
                       at = screen.project(world);
            if (!screen.inFront(at) || distanceToPicture(Vec2(at)) > 0) continue;
            ++inPicture;
            double nearest = kInfinity;
            for (const EdgePiece& piece : pieces)
                nearest = std::min(nearest, glm::length(Vec2(piece.nearest(Vec2(at)) - at)));
            // Rounding of a point `scale` away, in pixels.
            EXPECT_LE(nearest, 1e-9 + scale * 1e-13 * screen.pixelsPerWorld(at)) << run << ", " << i;
        }
    }
    EXPECT_GT(inPicture, 1000);
}

INSTANTIATE_TEST_SUITE_P(Scales, EdgePiecesScales,
                         testing::Combine(testing::Values(Camera::Projection::Perspective,
                                                          Camera::Projection::Orthographic),
                                          testing::Values(1.0, 10.0, 1e4, 1e9)));

TEST(EdgePieces, edge_toward_a_perspective_viewer_has_pieces_of_equal_length) {
    const Screen screen = Screen::ofCamera(cameraAt({0, 0, 3}, Camera::Projection::Perspective));
    const auto pieces = piecesOf(screen, {{0.1, 0.05, 2.7}, {-0.4, -0.3, -20}, {1, 0, 0}, 1e-6});
    ASSERT_GT(pieces.size(), 10u);
    const double first = glm::length(Vec2(pieces.front().b - pieces.front().a));
    for (const EdgePiece& piece : pieces)
        EXPECT_NEAR(glm::length(Vec2(piece.b - piece.a)), first, 1e-9);
    EXPECT_LE(first, 0.5);
}

TEST(EdgePieces, edge_beside_the_picture_farther_than_its_reach_has_none) {
    const Screen screen = Screen::ofCamera(cameraAt({0, 0, 3}, Camera::Projection::Orthographic));
    // 16 pixels a world unit; the picture ends at x = 2.
    EXPECT_TRUE(piecesOf(screen, {{2.2, -1, 0}, {2.2, 1, 0}, {3, 0, 0}, 0.1}).empty());
    EXPECT_FALSE(piecesOf(screen, {{2.2, -1, 0}, {2.2, 1, 0}, {3, 0, 0}, 0.3}).empty());
}

} // namespace
} // namespace plumbline
