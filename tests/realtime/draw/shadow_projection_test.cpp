// Projections of shadow maps, without OpenGL.
#include "realtime/draw/shadow_projection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

Bounds boxOf(const Vec3& low, const Vec3& high) {
    Bounds bounds;
    bounds.add(low);
    bounds.add(high);
    return bounds;
}

Light sun(const Vec3& toLight) {
    Light light;
    light.toLightWorld = glm::normalize(toLight);
    return light;
}

Light lamp(const Vec3& position) {
    Light light;
    light.kind = Light::Kind::Point;
    light.positionWorld = position;
    return light;
}

std::vector<Vec3> cornersOf(const Bounds& b) {
    std::vector<Vec3> corners;
    for (const double x : {b.low.x, b.high.x})
        for (const double y : {b.low.y, b.high.y})
            for (const double z : {b.low.z, b.high.z})
                corners.emplace_back(x, y, z);
    return corners;
}

Vec3 clipped(const CameraUniforms& camera, const Vec3& relative) {
    const Vec4 clip = Mat4(camera.clipFromRelative) * Vec4(relative, 1);
    return Vec3(clip) / clip.w;
}

TEST(ShadowProjection, Sun_EnclosesBoundsTightly) {
    const Bounds bounds = boxOf({-3, 1, 5}, {1, 2, 7});
    const Vec3 origin(0.5, 1, 6);
    for (const Vec3& toLight : {Vec3(0, 1, 0), Vec3(0, 0, -1), Vec3(1, 2, 3), Vec3(-0.2, 1, 0.01)}) {
        const ShadowProjection light = shadowProjections({sun(toLight)}, bounds, origin, 64)[0];
        ASSERT_EQ(light.layers.size(), 1u);
        Vec3 low(kInfinity), high(-kInfinity), lowClip(kInfinity), highClip(-kInfinity);
        for (const Vec3& corner : cornersOf(bounds)) {
            const Vec3 place(Mat4(light.placeFromRelative) * Vec4(corner - origin, 1));
            low = glm::min(low, place);
            high = glm::max(high, place);
            lowClip = glm::min(lowClip, clipped(light.layers[0], corner - origin));
            highClip = glm::max(highClip, clipped(light.layers[0], corner - origin));
            EXPECT_NEAR(place.z, -glm::dot(glm::normalize(toLight), corner), 1e-5); // along the light's rays
        }
        // Matrices are float. Front and back have a clipping margin of 1/1000.
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(low[axis], 0, 1e-5);
            EXPECT_NEAR(high[axis], 1, 1e-5);
            EXPECT_NEAR(lowClip[axis], -1, 1e-5);
            EXPECT_NEAR(highClip[axis], 1, 1e-5);
        }
        // Distances have the camera's margin on both sides.
        EXPECT_NEAR(low.z - 0.5 * bounds.diagonal(), light.nearest, 1e-5);
        EXPECT_NEAR(high.z + 0.5 * bounds.diagonal(), light.farthest, 1e-5);
        EXPECT_GT(lowClip.z, -1);
        EXPECT_LT(highClip.z, 1);
    }
    // From above the map is 4 x 2.
    EXPECT_NEAR(shadowProjections({sun({0, 1, 0})}, bounds, origin, 64)[0].halfDiagonal,
                0.5 * std::hypot(4, 2) / 64, 1e-12);
}

TEST(ShadowProjection, Sun_TakesSmallestRectangle) {
    // Compared with 1000 rectangles rotated around the light. The map's width and height follow from the
    // mapping of two points.
    const Bounds bounds = boxOf({-3, 0, 0}, {1, 1, 2});
    for (const Vec3& direction : {Vec3(1, 2, 3), Vec3(5, 1, 0.3), Vec3(-1, 1, 1)}) {
        const Vec3 toLight = glm::normalize(direction);
        const Mat4 place(shadowProjections({sun(direction)}, bounds, Vec3(0), 64)[0].placeFromRelative);
        const Vec3 u(place[0][0], place[1][0], place[2][0]), v(place[0][1], place[1][1], place[2][1]);
        const double area = 1 / (glm::length(u) * glm::length(v));
        double smallest = kInfinity;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 any = glm::normalize(glm::cross(toLight, Vec3(0.3, -0.5, 0.8)));
            const Vec3 right =
                any * std::cos(kPi * i / 1000) + glm::cross(toLight, any) * std::sin(kPi * i / 1000);
            const Vec3 up = glm::cross(toLight, right);
            Vec2 low(kInfinity), high(-kInfinity);
            for (const Vec3& corner : cornersOf(bounds)) {
                low = glm::min(low, Vec2(glm::dot(right, corner), glm::dot(up, corner)));
                high = glm::max(high, Vec2(glm::dot(right, corner), glm::dot(up, corner)));
            }
            smallest = std::min(smallest, (high.x - low.x) * (high.y - low.y));
        }
        EXPECT_LE(area, smallest * (1 + 1e-5));
    }
}

TEST(ShadowProjection, Lamp_HasFaceForEveryDirection) {
    const Vec3 position(0.5, -1, 2), origin(0.1, 0.2, 0.3);
    const auto lights = shadowProjections({sun({0, 1, 0}), lamp(position), lamp(Vec3(9, 9, 9))},
                                          boxOf({-3, -3, -3}, {3, 3, 3}), origin, 100);
    EXPECT_EQ(lights[0].firstLayer, 0);
    EXPECT_EQ(lights[1].firstLayer, 1);
    EXPECT_EQ(lights[2].firstLayer, 7);
    EXPECT_EQ(layerCount(lights), 13);
    EXPECT_EQ(lights[1].nearest, 0);                  // the light is inside
    const double margin = 0.5 * glm::length(Vec3(6)); // as for the camera
    EXPECT_NEAR(lights[2].nearest, glm::length(Vec3(6)) - margin, 1e-9);
    EXPECT_NEAR(lights[1].farthest, glm::length(Vec3(3.5, 4, 5)) + margin, 1e-9);
    EXPECT_NEAR(lights[1].halfDiagonal, std::sqrt(2.0) / 100, 1e-12);
    // Each direction is inside exactly one face: in front of it and between -1 and 1.
    for (int i = 0; i < 500; ++i) {
        const double height = -1 + (i + 0.5) / 250, angle = 2.399963 * i; // points of a Fibonacci sphere
        const double across = std::sqrt(1 - height * height);
        const Vec3 direction(across * std::cos(angle), height, across * std::sin(angle));
        int faces = 0, longest = 0;
        for (int axis = 1; axis < 3; ++axis)
            if (std::abs(direction[axis]) > std::abs(direction[longest])) longest = axis;
        for (size_t face = 0; face < 6; ++face) {
            const Vec3 relative = position - origin + 2.0 * direction;
            const Vec4 clip = Mat4(lights[1].layers[face].clipFromRelative) * Vec4(relative, 1);
            const bool inside = clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
            faces += inside;
            if (!inside) continue;
            EXPECT_EQ(face, 2 * static_cast<size_t>(longest) + (direction[longest] < 0));
            EXPECT_LE(std::abs(clip.z), clip.w);
        }
        EXPECT_EQ(faces, 1) << direction.x << " " << direction.y << " " << direction.z;
    }
}

TEST(ShadowProjection, EmptyOrFlatScene_GivesFiniteNumbers) {
    for (const Bounds& bounds : {Bounds{}, boxOf(Vec3(1), Vec3(1)), boxOf({-1, 0, -1}, {1, 0, 1})})
        for (const Light& light : {sun({1, 0, 0}), sun({0, 1, 0}), lamp({0, 0, 0}), lamp({1, 1, 1})}) {
            const ShadowProjection projection = shadowProjections({light}, bounds, Vec3(1), 64)[0];
            for (const CameraUniforms& camera : projection.layers)
                for (int column = 0; column < 4; ++column)
                    for (int row = 0; row < 4; ++row)
                        EXPECT_TRUE(std::isfinite(camera.clipFromRelative[column][row]));
            EXPECT_GT(projection.farthest, projection.nearest);
            EXPECT_TRUE(std::isfinite(projection.halfDiagonal));
        }
}

} // namespace
} // namespace plumbline
