// Compares quadrics of rings and of limit surfaces with surfaces of known curvature.
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/proxy_mesh.h"
#include "scenes/surface/quadric_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace plumbline {
namespace {

/// Points of z = height(x, y) around the origin, `count` of them at a distance `reach`, the first at the
/// angle `turn`.
std::vector<Vec3> ringOn(const std::function<double(double, double)>& height, double reach, int count,
                         double turn = 0.2) {
    std::vector<Vec3> ring;
    for (int i = 0; i < count; ++i) {
        const double angle = turn + 2 * kPi * i / count, x = reach * std::cos(angle),
                     y = reach * std::sin(angle);
        ring.push_back({x, y, height(x, y)});
    }
    return ring;
}

/// Tangents rotated by `angle` from the axes, with the angle `apart` between them.
QuadricFrame frameAt(double angle, double apart = kPi / 2) {
    return {Vec3(0), Vec3(std::cos(angle), std::sin(angle), 0),
            3.0 * Vec3(std::cos(angle + apart), std::sin(angle + apart), 0), Vec3(0, 0, 1)};
}

TEST(QuadricFit, PointsOnQuadric_GiveItsCoefficients) {
    // z = -(0.3 x^2 - 0.2 x y - 0.1 y^2), in its own frame, up to rounding, at every scale: coefficients are
    // proportional to 1 / size.
    for (const double size : {1e-3, 1.0, 1e3}) {
        const auto height = [&](double x, double y) {
            return -(0.3 * x * x - 0.2 * x * y - 0.1 * y * y) / size;
        };
        const RingFit fit = fitQuadric(frameAt(0), ringOn(height, 0.2 * size, 7));
        EXPECT_NEAR(fit.threeTerms.a * size, 0.3, 1e-12);
        EXPECT_NEAR(fit.threeTerms.b * size, -0.1, 1e-12);
        EXPECT_NEAR(fit.threeTerms.c * size, -0.2, 1e-12);
        EXPECT_GE(fit.condition, 1);
        EXPECT_LT(fit.condition, 10);
    }
    // With oblique tangents 50 degrees apart it is the same surface, so the heights at the same points are
    // equal.
    const auto height = [](double x, double y) { return -(0.3 * x * x - 0.2 * x * y - 0.1 * y * y); };
    const QuadricFrame oblique = frameAt(0.4, 50 * kPi / 180);
    const QuadricCoefficients found = fitQuadric(oblique, ringOn(height, 0.2, 7)).threeTerms;
    for (const Vec2& p : {Vec2(1, 0), Vec2(0, 1), Vec2(0.5, -2)}) {
        const Vec3 place = p.x * glm::normalize(oblique.tangentS) + p.y * glm::normalize(oblique.tangentT);
        EXPECT_NEAR(-(found.a * p.x * p.x + found.c * p.x * p.y + found.b * p.y * p.y),
                    height(place.x, place.y), 1e-12);
    }
}

TEST(QuadricFit, SaddleXY_NeedsCrossTerm) {
    // z = x y has no curvature along its axes; rotated by 45 degrees it is (x^2 - y^2) / 2.
    const auto ring = ringOn([](double x, double y) { return x * y; }, 0.1, 8);
    const RingFit along = fitQuadric(frameAt(0), ring), turned = fitQuadric(frameAt(kPi / 4), ring);
    EXPECT_NEAR(along.twoTerms.a, 0, 1e-12);
    EXPECT_NEAR(along.twoTerms.b, 0, 1e-12);
    EXPECT_NEAR(along.threeTerms.c, -1, 1e-12);
    EXPECT_NEAR(turned.twoTerms.a, -0.5, 1e-12);
    EXPECT_NEAR(turned.twoTerms.b, 0.5, 1e-12);
    EXPECT_NEAR(turned.threeTerms.c, 0, 1e-12);
}

TEST(QuadricFit, UndeterminedRing_IsReported) {
    const auto bowl = [](double x, double y) { return -(x * x + y * y); };
    // On the axes x y = 0, so A and B are determined but C isn't; x^2 y^2 = 0 gives the best possible
    // condition number.
    const RingFit axes = fitQuadric(frameAt(0), ringOn(bowl, 0.1, 4, 0));
    EXPECT_NEAR(axes.threeTerms.a, 1, 1e-12);
    EXPECT_NEAR(axes.threeTerms.b, 1, 1e-12);
    EXPECT_EQ(axes.threeTerms.c, 0);
    EXPECT_NEAR(axes.condition, 1, 1e-12);
    // On the diagonals x^2 = y^2, so only A + B is determined.
    const RingFit diagonals = fitQuadric(frameAt(0), ringOn(bowl, 0.1, 4, kPi / 4));
    EXPECT_EQ(diagonals.condition, kInfinity);
    EXPECT_EQ(diagonals.twoTerms.a, 0);
    EXPECT_EQ(diagonals.threeTerms.b, 0);
    // Nearly singular, by 0.01: x^2 and y^2 differ by 2 %. Correlation 1 - 2 * 0.02^2 / 4 ... the condition
    // is (1 + r) / (1 - r).
    const RingFit near = fitQuadric(frameAt(0), ringOn(bowl, 0.1, 4, kPi / 4 + 0.01));
    EXPECT_NEAR(near.condition * std::pow(std::tan(0.02), 2), 1, 0.01);
    EXPECT_NEAR(near.twoTerms.a, 1, 1e-9);
    EXPECT_EQ(fitQuadric(frameAt(0), {}).condition, kInfinity);
    EXPECT_EQ(fitQuadric(frameAt(0, 1e-4), ringOn(bowl, 0.1, 7)).condition,
              kInfinity); // nearly parallel tangents
}

TEST(QuadricFit, DerivativesPushedOut_StopAtCenterOfCurvature) {
    // Radii of curvature 2 and 4 along s and t, for tangents of any length. With an inward offset of 1 they
    // are 1 and 3; with 2, the first is singular.
    const auto pushed = [](double offset) {
        return quadricOfDerivatives({3, 0, 0}, {0, 0.1, 0}, {3 / 2.0, 0, 0}, {0, 0.1 / 4, 0}, offset);
    };
    EXPECT_NEAR(2 * pushed(0).a, 1 / 2.0, 1e-12);
    EXPECT_NEAR(2 * pushed(-1).a, 1 / 1.0, 1e-12);
    EXPECT_NEAR(2 * pushed(-1).b, 1 / 3.0, 1e-12);
    EXPECT_NEAR(pushed(-1).c, 0, 1e-12);
    EXPECT_EQ(pushed(-2).a, 0);
    EXPECT_EQ(pushed(-2).b, 0);
}

SceneObject reliefOn(ControlMesh mesh, int rate, double offset = 0) {
    SceneObject object;
    object.name = mesh.name;
    object.mesh = std::move(mesh);
    object.proxyRate = rate;
    object.relief =
        Relief{std::make_shared<HeightMap>(HeightMap::constant("flat", 0)), 0.1, offset, Vec2(3, 2), Vec2(0)};
    return object;
}

TEST(ProxyQuadrics, Sphere_HasHalfItsCurvature) {
    // z = -(X^2 + Y^2) / (2 R) in right-angled coordinates, so with tangents whose cosine is g A = B = 1 / (2
    // R) and C = g / R. A ring at distance r is r^2 / (2 R) (1 + r^2 / (4 R^2)) below the tangent plane: r <=
    // 0.07 adds 0.1 %. The curvature of the limit surface of a sphere with 16 segments per edge is accurate
    // to 3 % around the centers of the cube's faces, where it is tested (worse at the cube's corners).
    const ProxyMesh proxy = buildProxyMesh(reliefOn(makeSphere(1, 16), 2));
    int seen = 0, square = 0;
    for (const ProxyVertex& vertex : proxy.vertices) {
        const Vec3 reach = glm::abs(vertex.position);
        if (std::max({reach.x, reach.y, reach.z}) < 0.9) continue;
        ++seen;
        const double cosine = glm::dot(glm::normalize(vertex.positionS), glm::normalize(vertex.positionT));
        for (const QuadricCoefficients& quadric : {vertex.ringQuadric.threeTerms, vertex.limitQuadric}) {
            EXPECT_NEAR(2 * quadric.a, 1, 0.03); // > 0: convex
            EXPECT_NEAR(2 * quadric.b, 1, 0.03);
            EXPECT_NEAR(quadric.c, cosine, 0.03);
        }
        EXPECT_GE(vertex.ringQuadric.condition, 1);
        EXPECT_LT(vertex.ringQuadric.condition, 10);
        if (std::abs(cosine) > 0.02) continue;
        ++square;
        EXPECT_NEAR(2 * vertex.ringQuadric.twoTerms.a, 1, 0.05);
        EXPECT_NEAR(2 * vertex.ringQuadric.twoTerms.b, 1, 0.05);
    }
    EXPECT_GT(seen, 500);
    EXPECT_GT(square, 50);
}

TEST(ProxyQuadrics, ScaledPatch_HasScaledCoefficients) {
    for (const double size : {1e-3, 1e3}) {
        SceneObject one = reliefOn(makeQuadric(0.4, -0.2, 1, 6), 2), scaled = one;
        scaled.scale = size;
        const ProxyMesh a = buildProxyMesh(one), b = buildProxyMesh(scaled);
        ASSERT_EQ(a.vertices.size(), b.vertices.size());
        for (size_t i = 0; i < a.vertices.size(); ++i) {
            EXPECT_NEAR(b.vertices[i].ringQuadric.threeTerms.a * size, a.vertices[i].ringQuadric.threeTerms.a,
                        1e-9);
            EXPECT_NEAR(b.vertices[i].ringQuadric.threeTerms.c * size, a.vertices[i].ringQuadric.threeTerms.c,
                        1e-9);
            EXPECT_NEAR(b.vertices[i].limitQuadric.b * size, a.vertices[i].limitQuadric.b, 1e-9);
            EXPECT_NEAR(b.vertices[i].ringQuadric.condition / a.vertices[i].ringQuadric.condition, 1, 1e-6);
        }
    }
}

TEST(ProxyQuadrics, SaddleTurned45Degrees_HasCrossTerm) {
    // The uvs of the patch z = 0.3 (x^2 - y^2) are rotated by 45 degrees, so it has no curvature along s and
    // t, only the cross term.
    ControlMesh mesh = makeQuadric(0.3, -0.3, 1, 8);
    for (Vec2& uv : mesh.uvs)
        uv = Vec2(uv.x + uv.y, uv.y - uv.x);
    const ProxyMesh proxy = buildProxyMesh(reliefOn(mesh, 2));
    int seen = 0;
    for (const ProxyVertex& vertex : proxy.vertices) {
        if (std::hypot(vertex.position.x, vertex.position.y) > 0.2)
            continue; // slope 0.12: curvatures 2 % off
        ++seen;
        EXPECT_NEAR(vertex.ringQuadric.twoTerms.a, 0, 0.01);
        EXPECT_NEAR(vertex.ringQuadric.twoTerms.b, 0, 0.01);
        // z = -(A x^2 + C x y + B y^2) with x, y at 45 degrees to p, q of +-0.3 (p^2 - q^2): C = +-0.6.
        EXPECT_NEAR(std::abs(vertex.ringQuadric.threeTerms.c), 0.6, 0.02);
        EXPECT_NEAR(vertex.limitQuadric.c, vertex.ringQuadric.threeTerms.c, 0.01);
        EXPECT_NEAR(vertex.limitQuadric.a, 0, 1e-9);
    }
    EXPECT_GT(seen, 5);
}

/// W with dn = W dP in the tangent plane, along the unit tangents of s and t: the inverse first fundamental
/// form times minus the second.
glm::dmat2 shapeOperator(const ProxyVertex& vertex) {
    const double cosine = glm::dot(glm::normalize(vertex.positionS), glm::normalize(vertex.positionT));
    const QuadricCoefficients& q = vertex.limitQuadric;
    return glm::inverse(glm::dmat2(1, cosine, cosine, 1)) * glm::dmat2(2 * q.a, q.c, q.c, 2 * q.b);
}

TEST(ProxyQuadrics, LimitCoefficients_AreThoseOfOffsetSurface) {
    // With an outward offset o, radii of curvature grow by o in the same principal directions: dn = W dP = W'
    // dP' with P' = P + o n, so W' (1 + o W) = W for any tangents; a vertex has those of P. Also tests
    // rotated uvs, whose tangents aren't the principal directions.
    for (const bool turned : {false, true}) {
        ControlMesh mesh = makeTorus(1, 0.4, 24, 16);
        if (turned)
            for (Vec2& uv : mesh.uvs)
                uv = Vec2(uv.x + uv.y, uv.y - 0.5 * uv.x);
        const ProxyMesh plain = buildProxyMesh(reliefOn(mesh, 2)),
                        pushed = buildProxyMesh(reliefOn(mesh, 2, 0.2));
        ASSERT_EQ(plain.vertices.size(), pushed.vertices.size());
        size_t crossed = 0;
        for (size_t i = 0; i < plain.vertices.size(); ++i) {
            const glm::dmat2 before = shapeOperator(plain.vertices[i]),
                             after = shapeOperator(pushed.vertices[i]),
                             miss = after * (glm::dmat2(1) + 0.2 * before) - before;
            crossed += std::abs(plain.vertices[i].limitQuadric.c) > 0.1;
            for (int column = 0; column < 2; ++column)
                ASSERT_LT(glm::length(miss[column]), 1e-9) << i;
        }
        EXPECT_GT(plain.vertices.size(), 1000u);
        if (turned) {
            EXPECT_GT(crossed, plain.vertices.size() / 2);
        }
    }
    const ProxyMesh plain = buildProxyMesh(reliefOn(makeTorus(1, 0.4, 24, 16), 2));
    double outermost = 0, a = 0, b = 0;
    for (const ProxyVertex& vertex : plain.vertices)
        if (const double radius = std::hypot(vertex.position.x, vertex.position.z); radius > outermost) {
            outermost = radius;
            a = vertex.limitQuadric.a;
            b = vertex.limitQuadric.b;
        }
    EXPECT_NEAR(std::min(a, b) * 2, 1 / outermost, 0.02);
    EXPECT_NEAR(std::max(a, b) * 2, 1 / 0.4, 0.1);
    // The ring of a coarse proxy consists of chords and agrees to a few per cent.
    EXPECT_GT(outermost, 1.3);
}

} // namespace
} // namespace plumbline
