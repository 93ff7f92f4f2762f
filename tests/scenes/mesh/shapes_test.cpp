// Built-in shapes: limit surfaces in closed form, topology and errors.
#include "scenes/mesh/shapes/limit_points.h"
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/base_surface.h"
#include "tests/errors.h"
#include "tests/scenes/mesh/mesh_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <gmock/gmock.h>

namespace plumbline {
namespace {

/// Calls `visit` with samples of the limit surface, only at the vertices (steps 1) or also in between.
void forSamples(const ControlMesh& mesh, int steps, const std::function<void(const BasePoint&)>& visit,
                Scheme scheme = Scheme::CatmullClark) {
    const BaseSurface surface(mesh, scheme);
    BaseSurface::Evaluator evaluator(surface);
    for (int patch = 0; patch < static_cast<int>(surface.patches().size()); ++patch) {
        evaluator.setPatch(patch);
        for (int j = 0; j <= steps; ++j)
            for (int i = 0; i <= steps; ++i)
                visit(evaluator.point(double(i) / steps, double(j) / steps));
    }
}

/// Largest value of `error` over the samples.
double worst(const ControlMesh& mesh, int steps, const std::function<double(const BasePoint&)>& error) {
    double result = 0;
    forSamples(mesh, steps, [&](const BasePoint& p) { result = std::max(result, std::abs(error(p))); });
    return result;
}

double torusError(const BasePoint& p) { // of a torus with radii 1 and 0.4
    return std::hypot(std::hypot(p.position.x, p.position.z) - 1, p.position.y) - 0.4;
}

// Rounding: sums of about 16 products of coordinates near 1, in OpenSubdiv and in the shape.
constexpr double kRounding = 1e-13;
// The tolerance of interpolateLimit, for sizes of about 2.
constexpr double kInterpolated = 5e-12;

TEST(Shapes, Plane_IsRectangle) {
    const ControlMesh mesh = makePlane(3, 2, 4, 5);
    const Topology topology = topologyOf(mesh);
    EXPECT_EQ(topology.faces, 20);
    EXPECT_EQ(topology.euler(), 1); // a disc
    EXPECT_TRUE(topology.consistent);
    forSamples(mesh, 4, [](const BasePoint& p) {
        // uv (0,0) at (-x, +z), (1,1) at (+x, -z)
        EXPECT_LT(glm::length(p.position - Vec3(3 * p.uv.x - 1.5, 0, 1 - 2 * p.uv.y)), kRounding);
        EXPECT_LT(glm::length(p.normal - Vec3(0, 1, 0)), kRounding);
    });
}

TEST(Shapes, Quadric_LimitIsExact) {
    const double a = 0.7, b = -0.3, halfSize = 1.25;
    for (const int segments : {1, 2, 5}) {
        const ControlMesh mesh = makeQuadric(a, b, halfSize, segments);
        EXPECT_EQ(BaseSurface(mesh, Scheme::CatmullClark).patches().size(), size_t(segments * segments));
        Bounds bounds;
        forSamples(mesh, 8, [&](const BasePoint& p) {
            const auto [x, y, z] = std::tuple(p.position.x, p.position.y, p.position.z);
            EXPECT_NEAR(z, a * x * x + b * y * y, kRounding);
            EXPECT_LT(glm::length(Vec2(x, y) - (p.uv * 2.0 - 1.0) * halfSize), kRounding);
            EXPECT_LT(glm::length(p.normal - glm::normalize(Vec3(-2 * a * x, -2 * b * y, 1))), kRounding);
            bounds.add(p.position);
        });
        EXPECT_NEAR(bounds.low.x, -halfSize, kRounding);
        EXPECT_NEAR(bounds.high.x, halfSize, kRounding);
        EXPECT_NEAR(bounds.low.y, -halfSize, kRounding);
        EXPECT_NEAR(bounds.high.y, halfSize, kRounding);
    }
}

TEST(Shapes, TorusVertices_LimitsLieOnTorus) {
    EXPECT_LT(worst(makeTorus(1, 0.4, 16, 8), 1, torusError), kRounding);
    EXPECT_LT(worst(makeTorus(1, 0.4, 3, 3), 1, torusError), kRounding);
    // Between vertices, the interpolation error of cubic splines is of fourth order, h^4 (1 + c h^2):
    // doubling the segments reduces it to 1/16, slightly less at finite h; c h^2 is below 1/10 from 32
    // segments on.
    const double coarse = worst(makeTorus(1, 0.4, 32, 16), 4, torusError);
    const double fine = worst(makeTorus(1, 0.4, 64, 32), 4, torusError);
    EXPECT_NEAR(coarse / fine, 16, 1.6);
    // 0.12 % of the radius at 8 segments (shapes.h), plus the error of the 16 segments around the axis, 1/16
    // of that for the radius 1.4.
    EXPECT_LT(worst(makeTorus(1, 0.4, 16, 8), 8, torusError), 0.0015 * 0.4);
}

TEST(Shapes, Torus_HasTopologyAndUvs) {
    const Topology topology = topologyOf(makeTorus(1, 0.4, 16, 8));
    EXPECT_EQ(topology.faces, 128);
    EXPECT_EQ(topology.euler(), 0);
    EXPECT_EQ(topology.boundaryEdges, 0);
    EXPECT_EQ(topology.seamEdges, 0);
    EXPECT_TRUE(topology.consistent);
    forSamples(makeTorus(1, 0.4, 16, 8), 1, [](const BasePoint& p) {
        const double angle = 2 * kPi * p.uv.x, tube = 2 * kPi * p.uv.y, distance = 1 + 0.4 * std::cos(tube);
        const Vec3 expected(distance * std::cos(angle), 0.4 * std::sin(tube), -distance * std::sin(angle));
        EXPECT_LT(glm::length(p.position - expected), kRounding);
        // By symmetry, the limit normal at a vertex lies in the half-plane of the axis and points out of the
        // tube, up to the slope error of the spline (third order; 2 degrees at 8 segments is a generous
        // bound).
        const Vec3 outward(std::cos(tube) * std::cos(angle), std::sin(tube),
                           -std::cos(tube) * std::sin(angle));
        EXPECT_GT(glm::dot(p.normal, outward), std::cos(radians(2.0)));
    });
}

TEST(Shapes, CylinderVertices_LimitsLieOnCylinder) {
    const ControlMesh mesh = makeCylinder(2, 3, 8, 3);
    const Topology topology = topologyOf(mesh);
    EXPECT_EQ(topology.euler(), 0);
    EXPECT_EQ(topology.boundaryEdges, 16);
    EXPECT_EQ(topology.seamEdges, 0);
    EXPECT_TRUE(topology.consistent);
    const auto error = [](const BasePoint& p) { return std::hypot(p.position.x, p.position.z) - 2; };
    EXPECT_LT(worst(mesh, 1, error), kRounding);
    EXPECT_LT(worst(mesh, 8, error), 0.0012 * 2); // the header's 0.12 %
    forSamples(mesh, 4, [](const BasePoint& p) {
        EXPECT_NEAR(p.position.y, 3 * (p.uv.y - 0.5), kRounding); // straight up, ends exact
        EXPECT_GT(glm::dot(p.normal, glm::normalize(Vec3(p.position.x, 0, p.position.z))), 0.99);
    });
    forSamples(mesh, 1, [](const BasePoint& p) {
        const double angle = 2 * kPi * p.uv.x;
        EXPECT_NEAR(p.position.x, 2 * std::cos(angle), kRounding);
        EXPECT_NEAR(p.position.z, -2 * std::sin(angle), kRounding);
    });
}

TEST(Shapes, SphereVertices_LimitsLieOnSphere) {
    const auto error = [](const BasePoint& p) { return glm::length(p.position) - 1.5; };
    for (const int segments : {1, 2, 3, 8}) {
        const ControlMesh mesh = makeSphere(1.5, segments);
        EXPECT_LT(worst(mesh, 1, error), kInterpolated) << segments;
        const Topology topology = topologyOf(mesh);
        EXPECT_EQ(topology.faces, 6 * segments * segments);
        EXPECT_EQ(topology.euler(), 2);
        EXPECT_EQ(topology.boundaryEdges, 0);
        EXPECT_TRUE(topology.consistent);
        // Top and bottom have three seams each (shapes.h).
        EXPECT_EQ(topology.seamEdges, 6 * segments);
        forSamples(mesh, 2, [](const BasePoint& p) {
            EXPECT_GT(glm::dot(p.normal, glm::normalize(p.position)), 0.9);
        });
    }
    EXPECT_LT(worst(makeSphere(1.5, 4), 8, error), 0.0024 * 1.5); // the header's 0.24 %
}

TEST(Shapes, BoxUnderNone_HasHardEdges) {
    const ControlMesh mesh = makeBox({1, 2, 3}, 2);
    const Topology topology = topologyOf(mesh);
    EXPECT_EQ(topology.euler(), 2);
    EXPECT_EQ(topology.boundaryEdges, 0);
    EXPECT_TRUE(topology.consistent);
    EXPECT_THAT(partVolumes(mesh), testing::ElementsAre(testing::DoubleNear(6, kRounding)));
    int corners = 0;
    forSamples(
        mesh, 3,
        [&](const BasePoint& p) {
            const Vec3 relative = p.position / Vec3(0.5, 1, 1.5);
            // The normal is one axis, and along it the point is on the surface.
            EXPECT_NEAR(glm::dot(p.normal, relative), 1, kRounding);
            EXPECT_NEAR(std::abs(p.normal.x) + std::abs(p.normal.y) + std::abs(p.normal.z), 1, kRounding);
            if (glm::length(glm::abs(relative) - 1.0) < kRounding) ++corners;
        },
        Scheme::None);
    EXPECT_EQ(corners, 24); // each of the eight in three faces
}

TEST(Shapes, ClosedShapes_FaceOutward) {
    EXPECT_GT(partVolumes(makeSphere(1, 2)).front(), 0);
    EXPECT_GT(partVolumes(makeTorus(1, 0.4, 8, 6)).front(), 0);
    EXPECT_GT(partVolumes(makeCylinder(1, 1, 6, 2)).front(), 0);
}

TEST(LimitPoints, BuiltInShapes_EqualOpenSubdiv) {
    // An n-gon of every kind, boundaries, corners and poles: the teapot's coarsest mesh, and a few n-gons.
    // OpenSubdiv refines ten times toward an extraordinary vertex; coordinates are up to 4 here.
    const double bound = 10 * 4 * kRounding;
    ControlMesh pentagon;
    pentagon.name = "pentagon";
    for (int k = 0; k < 5; ++k)
        pentagon.points.push_back(Vec3(std::cos(k * 1.2), std::sin(k * 1.2), 0.1 * k * k));
    pentagon.points.push_back(Vec3(0.1, 0.2, 1));
    pentagon.faceSizes = {5, 3, 3};
    pentagon.faceVertices = {0, 1, 2, 3, 4, 1, 0, 5, 2, 1, 5}; // vertex 1 is adjacent to the boundary
    for (const ControlMesh& mesh : {makeTeapot(2), makeBox({1, 2, 3}, 1), pentagon}) {
        const std::vector<Vec3> limits = limitPoints(mesh);
        const BaseSurface surface(mesh, Scheme::CatmullClark);
        BaseSurface::Evaluator evaluator(surface);
        for (size_t patch = 0; patch < surface.patches().size(); ++patch) {
            const BaseSurface::Patch& p = surface.patches()[patch];
            evaluator.setPatch(static_cast<int>(patch));
            const auto vertex = static_cast<size_t>(surface.faceVertices(p.face)[size_t(p.corner)]);
            EXPECT_LT(glm::length(evaluator.point(0, 0).position - limits[vertex]), bound) << mesh.name;
        }
    }
}

// ------------------------------------------------------------------------------------------------- teapot

Vec3 bezier(const std::array<Vec3, 16>& patch, double u, double v) { // de Casteljau, y up
    const auto curve = [](std::array<Vec3, 4> p, double t) {
        for (size_t level = 3; level > 0; --level)
            for (size_t k = 0; k < level; ++k)
                p[k] = p[k] * (1 - t) + p[k + 1] * t;
        return p[0];
    };
    std::array<Vec3, 4> rows;
    for (size_t r = 0; r < 4; ++r)
        rows[r] = curve({patch[4 * r], patch[4 * r + 1], patch[4 * r + 2], patch[4 * r + 3]}, u);
    const Vec3 p = curve(rows, v);
    return {p.x, p.z, -p.y};
}

/// Border k of a patch: bottom, right, top, left row of control points.
std::array<Vec3, 4> border(const std::array<Vec3, 16>& patch, int k) {
    constexpr size_t kIndices[4][4] = {{0, 1, 2, 3}, {3, 7, 11, 15}, {12, 13, 14, 15}, {0, 4, 8, 12}};
    std::array<Vec3, 4> result;
    for (size_t i = 0; i < 4; ++i)
        result[i] = patch[kIndices[k][i]];
    return result;
}

bool sameCurve(const std::array<Vec3, 4>& a, const std::array<Vec3, 4>& b) {
    const auto near = [](const Vec3& p, const Vec3& q) { return glm::length(p - q) < 1e-9; };
    bool forward = true, backward = true;
    for (size_t i = 0; i < 4; ++i) {
        forward = forward && near(a[i], b[i]);
        backward = backward && near(a[i], b[3 - i]);
    }
    return forward || backward;
}

TEST(Teapot, ThirtyTwoPatches_ShareBorders) {
    const auto patches = teapotPatches();
    ASSERT_EQ(patches.size(), 32u);
    int open = 0, poles = 0;
    for (size_t p = 0; p < patches.size(); ++p)
        for (int k = 0; k < 4; ++k) {
            const auto curve = border(patches[p], k);
            if (glm::length(curve[0] - curve[1]) + glm::length(curve[0] - curve[3]) < 1e-9) {
                ++poles;
                continue;
            }
            int partners = 0;
            for (size_t q = 0; q < patches.size(); ++q)
                for (int m = 0; m < 4; ++m)
                    if ((q != p || m != k) && sameCurve(curve, border(patches[q], m))) ++partners;
            EXPECT_LE(partners, 1) << "patch " << p << " border " << k;
            if (partners == 0) ++open;
        }
    EXPECT_EQ(poles, 8); // four of the lid's top, four of the bottom's center
    // Four each of the rim's inner and the lid's outer edge, two at each end of handle and spout; the bottom
    // is closed.
    EXPECT_EQ(open, 4 + 4 + 2 * 2 + 2 * 2);
}

/// The control points next to border k of a patch.
std::array<Vec3, 4> innerRow(const std::array<Vec3, 16>& patch, int k) {
    constexpr size_t kIndices[4][4] = {{4, 5, 6, 7}, {2, 6, 10, 14}, {8, 9, 10, 11}, {1, 5, 9, 13}};
    std::array<Vec3, 4> result;
    for (size_t i = 0; i < 4; ++i)
        result[i] = patch[kIndices[k][i]];
    return result;
}

TEST(Teapot, PatchBorders_AreTangentContinuous) {
    // Newell's patches are smooth across every shared border: adjacent control points on both sides are
    // collinear with the border's. This detects typing errors in the data near borders.
    const auto patches = teapotPatches();
    int borders = 0;
    for (size_t p = 0; p < patches.size(); ++p)
        for (size_t q = 0; q < patches.size(); ++q)
            for (int k = 0; k < 4; ++k)
                for (int m = 0; m < 4; ++m) {
                    const auto curve = border(patches[p], k), other = border(patches[q], m);
                    if ((p == q && k == m) || !sameCurve(curve, other)) continue;
                    if (glm::length(curve[0] - curve[3]) < 1e-9) continue; // a pole
                    ++borders;
                    const bool forward = glm::length(curve[0] - other[0]) < 1e-9;
                    for (size_t i = 0; i < 4; ++i) {
                        const Vec3 in = innerRow(patches[p], k)[i] - curve[i];
                        const Vec3 out = innerRow(patches[q], m)[forward ? i : 3 - i] - curve[i];
                        EXPECT_LT(glm::length(glm::cross(in, out)), 1e-9) << p << " " << q;
                        EXPECT_LE(glm::dot(in, out), 0) << p << " " << q;
                    }
                }
    // 32 patches have 128 borders, 8 of them poles and 16 open; each of the others is visited from both of
    // its patches.
    EXPECT_EQ(borders, 128 - 8 - 16);
}

TEST(Teapot, Bounds_AreThoseOfClassicData) {
    Bounds bounds;
    for (const auto& patch : teapotPatches())
        for (int j = 0; j <= 64; ++j)
            for (int i = 0; i <= 64; ++i)
                bounds.add(bezier(patch, i / 64.0, j / 64.0));
    // Known extent of the surface (not of its control points): x -3 ... 3.43, y -2 ... 2, z 0 ... 3.15, z up.
    // The spout's tip is an extremum between samples, with an error of less than (1/128)^2 of its patch.
    EXPECT_NEAR(bounds.low.x, -3, 1e-9);
    EXPECT_NEAR(bounds.high.x, 3.434, 1e-3);
    EXPECT_NEAR(bounds.low.y, 0, 1e-9);
    EXPECT_NEAR(bounds.high.y, 3.15, 1e-9);
    EXPECT_NEAR(bounds.low.z, -2, 1e-9);
    EXPECT_NEAR(bounds.high.z, 2, 1e-9);
}

TEST(Teapot, Shells_AreFour) {
    for (const int segments : {2, 4}) {
        const ControlMesh mesh = makeTeapot(segments);
        const Topology topology = topologyOf(mesh);
        EXPECT_EQ(topology.faces, 32 * segments * segments);
        EXPECT_TRUE(topology.consistent);
        // Body with bottom, and lid, are discs; handle and spout are tubes.
        EXPECT_EQ(topology.euler(), 1 + 1 + 0 + 0);
        EXPECT_EQ(topology.boundaryEdges, (4 + 4 + 2 * 2 + 2 * 2) * segments);
        const std::vector<double> volumes = partVolumes(mesh);
        ASSERT_EQ(volumes.size(), 4u);
        EXPECT_GT(volumes.front(), 0.05); // every part's faces look outwards
    }
}

TEST(Teapot, Uvs_AreContinuousExceptAtPoles) {
    const int segments = 3;
    // At a pole each triangle has its own u: 4 x segments edges end there, lid and bottom.
    EXPECT_EQ(topologyOf(makeTeapot(segments)).seamEdges, 2 * 4 * segments);
}

TEST(Teapot, Vertices_LimitsLieOnBezierPatches) {
    const int segments = 3;
    std::vector<Vec3> lattice;
    for (const auto& patch : teapotPatches())
        for (int j = 0; j <= segments; ++j)
            for (int i = 0; i <= segments; ++i)
                lattice.push_back(bezier(patch, double(i) / segments, double(j) / segments));
    const ControlMesh mesh = makeTeapot(segments);
    const BaseSurface surface(mesh, Scheme::CatmullClark);
    BaseSurface::Evaluator evaluator(surface);
    for (size_t patch = 0; patch < surface.patches().size(); ++patch) {
        evaluator.setPatch(static_cast<int>(patch));
        const Vec3 corner = evaluator.point(0, 0).position;
        const auto nearest =
            std::min_element(lattice.begin(), lattice.end(), [&](const Vec3& a, const Vec3& b) {
                return glm::length(a - corner) < glm::length(b - corner);
            });
        EXPECT_LT(glm::length(*nearest - corner), 1e-11); // interpolateLimit's 1e-12 of a size near 8
    }
}

// ------------------------------------------------------------------------------------------------- errors

TEST(ShapeErrors, BadParameter_NamesShapeAndParameter) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(inputErrorOf([] { makePlane(0, 1, 1, 1); }),
              "shape 'plane': width = 0; expected a positive, finite number");
    EXPECT_EQ(inputErrorOf([&] { makePlane(1, nan, 1, 1); }),
              "shape 'plane': depth = nan; expected a positive, finite number");
    EXPECT_EQ(inputErrorOf([] { makePlane(1, 1, 0, 1); }),
              "shape 'plane': segments[0] = 0; expected a whole number from 1 to 4096");
    EXPECT_EQ(inputErrorOf([] { makePlane(1, 1, 1, 4097); }),
              "shape 'plane': segments[1] = 4097; expected a whole number from 1 to 4096");
    EXPECT_EQ(
        inputErrorOf([] { makePlane(1, 1, 4096, 4096); }),
        "shape 'plane': 16777216 faces; expected at most 262144; a control mesh is coarse; the reference "
        "subdivides it as far as the relief needs");
    EXPECT_EQ(inputErrorOf([&] { makeQuadric(nan, 0, 1, 1); }),
              "shape 'quadric': a = nan; expected a finite number");
    EXPECT_EQ(inputErrorOf([] { makeQuadric(0, kInfinity, 1, 1); }),
              "shape 'quadric': b = inf; expected a finite number");
    EXPECT_EQ(inputErrorOf([] { makeQuadric(0, 0, -1, 1); }),
              "shape 'quadric': half_size = -1; expected a positive, finite number");
    EXPECT_EQ(inputErrorOf([] { makeQuadric(0, 0, 1, 4095); }),
              "shape 'quadric': segments = 4095; expected a whole number from 1 to 4094");
    EXPECT_EQ(inputErrorOf([] { makeSphere(-2, 1); }),
              "shape 'sphere': radius = -2; expected a positive, finite number");
    EXPECT_EQ(inputErrorOf([] { makeSphere(1, 0); }),
              "shape 'sphere': segments = 0; expected a whole number from 1 to 4096");
    EXPECT_EQ(inputErrorOf([] { makeCylinder(1, 1, 2, 1); }),
              "shape 'cylinder': segments[0] = 2; expected a whole number from 3 to 4096");
    EXPECT_EQ(inputErrorOf([] { makeCylinder(1, 0, 8, 1); }),
              "shape 'cylinder': height = 0; expected a positive, finite number");
    EXPECT_EQ(inputErrorOf([] { makeTorus(1, 1, 8, 8); }),
              "shape 'torus': minor = 1; expected less than major = 1");
    EXPECT_EQ(inputErrorOf([] { makeTorus(1, 0.4, 2, 8); }),
              "shape 'torus': segments[0] = 2; expected a whole number from 3 to 4096");
    EXPECT_EQ(inputErrorOf([] { makeTorus(1, 0.4, 8, 2); }),
              "shape 'torus': segments[1] = 2; expected a whole number from 3 to 4096");
    EXPECT_EQ(inputErrorOf([] {
                  makeBox({1, 0, 1}, 1);
              }),
              "shape 'box': size[1] = 0; expected a positive, finite number");
    EXPECT_EQ(inputErrorOf([] { makeTeapot(65); }),
              "shape 'teapot': segments = 65; expected a whole number from 2 to 64");
}

} // namespace
} // namespace plumbline
