// Normals where S_u and S_v are parallel: smooth corners of boundaries and of faces between creases.
#include "scenes/surface/base_surface.h"
#include "scenes/surface/displaced_surface.h"
#include "scenes/surface/patch_place.h"
#include "tests/scenes/mesh/test_meshes.h"

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <random>

namespace plumbline {
namespace {

// The normals around a corner are exact to about 1e-10, from which that of the corner takes its side; its own
// is a product of two control edges. Positions are within 20 of the origin.
constexpr double kExact = 1e-12;

/// Turned and moved at random.
struct Motion {
    glm::dquat turn;
    Vec3 shift;
    explicit Motion(std::mt19937& random) {
        const auto number = [&] { return std::normal_distribution<double>(0, 1)(random); };
        turn = glm::normalize(glm::dquat(number(), number(), number(), number()));
        shift = 5.0 * Vec3(number(), number(), number());
    }
    void apply(ControlMesh& mesh) const {
        for (Vec3& point : mesh.points)
            point = turn * point + shift;
    }
};

/// A sheet of n x n squares facing +Y, bent by `bend`, its boundary rounded; triangles: each cut in two.
ControlMesh sheet(int side, double bend, bool triangles) {
    ControlMesh mesh;
    mesh.name = "sheet";
    mesh.tags.boundaryCornersRound = true;
    for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i)
            mesh.points.push_back(Vec3(i, bend * (std::sin(1.3 * i + 0.4 * j) + 0.2 * i * j), -j));
    const int row = side + 1;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const int a = j * row + i;
            if (!triangles)
                addFace(mesh, {a, a + 1, a + row + 1, a + row});
            else {
                addFace(mesh, {a, a + 1, a + row});
                addFace(mesh, {a + 1, a + row + 1, a + row});
            }
        }
    return mesh;
}

/// Calls visit(normal, face, k) for each corner of each face.
template <class Visit>
void forCorners(const BaseSurface& surface, Visit visit) {
    BaseSurface::Evaluator evaluator(surface);
    for (const MeshFace& face : surface.mesh().faces())
        for (size_t k = 0; k < face.size; ++k) {
            const PatchPlace place = placeOnEdge(surface, face.index, static_cast<int>(k), 0);
            evaluator.setPatch(place.patch);
            visit(evaluator.sample(place.uv.x, place.uv.y), face, k);
        }
}

TEST(SmoothCorner, FlatSheetsTurnedAnyWay_HaveItsNormal) {
    std::mt19937 random(1);
    for (int run = 0; run < 200; ++run) {
        const bool triangles = run % 2 == 1;
        ControlMesh mesh = sheet(1 + run % 4, 0, triangles);
        const Motion motion(random);
        motion.apply(mesh);
        const BaseSurface surface(mesh, triangles ? Scheme::Loop : Scheme::CatmullClark);
        const Vec3 up = motion.turn * Vec3(0, 1, 0);
        forCorners(surface, [&](const BaseSample& sample, const MeshFace& face, size_t k) {
            // Normals of other corners are quotients of rounding errors of up to 2^-40.
            const double tolerance = sample.singular ? kExact : 1e-9;
            EXPECT_LT(glm::length(sample.normal - up), tolerance)
                << "run " << run << ", face " << face.index << ", corner " << k;
        });
    }
}

TEST(SmoothCorner, BentSheets_HaveTheirLimitPlane) {
    std::mt19937 random(2);
    int singular = 0;
    for (int run = 0; run < 100; ++run) {
        const bool triangles = run % 2 == 1;
        ControlMesh mesh = sheet(3, 0.1 + 0.002 * run, triangles);
        Motion(random).apply(mesh);
        const BaseSurface surface(mesh, triangles ? Scheme::Loop : Scheme::CatmullClark);
        forCorners(surface, [&](const BaseSample& sample, const MeshFace& face, size_t k) {
            if (!sample.singular) return;
            ++singular;
            // OpenSubdiv's limit tangents (Sdc: tan1 = (0, 1, -1), tan2 = (-6, 3, 3) of the vertex and both
            // neighbors), which span the plane of the three.
            const Vec3 &v = mesh.pointAt(face.corner(k)), &a = mesh.pointAt(face.corner(k + 1)),
                       &b = mesh.pointAt(face.corner(k + face.size - 1));
            const Vec3 expected = glm::normalize(glm::cross(a - b, 3.0 * a + 3.0 * b - 6.0 * v));
            EXPECT_LT(glm::length(sample.normal - expected), kExact) << "run " << run;
            EXPECT_EQ(sample.normalU, Vec3(0));
            EXPECT_EQ(sample.normalV, Vec3(0));
        });
    }
    EXPECT_EQ(singular, 50 * 4 + 50 * 2); // a square cut in two leaves two corners with one triangle
}

TEST(SmoothCorner, FaceAloneInsideCrease_HasItsPlane) {
    ControlMesh mesh = cubeMesh();
    const int cap[] = {4, 5, 7, 6};
    for (int k = 0; k < 4; ++k)
        mesh.tags.creases.push_back({cap[k], cap[(k + 1) % 4], kInfinitelySharp});
    const BaseSurface surface(mesh, Scheme::CatmullClark);
    int singular = 0;
    forCorners(surface, [&](const BaseSample& sample, const MeshFace& face, size_t) {
        if (face.index != 1) return;
        singular += sample.singular;
        EXPECT_LT(glm::length(sample.normal - Vec3(0, 0, 1)), kExact);
    });
    EXPECT_EQ(singular, 4);
}

TEST(SmoothCorner, PolygonsOfAnySize_HaveTheirPlane) {
    std::mt19937 random(3);
    for (int size = 3; size <= 9; ++size) {
        ControlMesh mesh;
        mesh.name = "polygon";
        mesh.tags.boundaryCornersRound = true;
        mesh.faceSizes = {size};
        for (int k = 0; k < size; ++k) {
            mesh.points.push_back(Vec3(std::cos(2 * kPi * k / size), std::sin(2 * kPi * k / size), 0));
            mesh.faceVertices.push_back(k);
        }
        const Motion motion(random);
        motion.apply(mesh);
        const BaseSurface surface(mesh, Scheme::CatmullClark);
        forCorners(surface, [&](const BaseSample& sample, const MeshFace&, size_t k) {
            EXPECT_TRUE(sample.singular);
            EXPECT_LT(glm::length(sample.normal - motion.turn * Vec3(0, 0, 1)), kExact) << size << ", " << k;
        });
    }
}

/// A semi-sharp or sharp corner at v leaves its plane what it is.
TEST(SmoothCorner, AnySharpness_HasSamePlane) {
    std::mt19937 random(4);
    for (const double sharpness : {0.0, 0.5, 2.0, 3.7, 9.0, 10.0}) {
        ControlMesh mesh = sheet(3, 0, false);
        mesh.tags.corners.push_back({0, sharpness});
        mesh.tags.creases.push_back({5, 6, sharpness});
        mesh.tags.creases.push_back({5, 9, sharpness});
        const Motion motion(random);
        motion.apply(mesh);
        const BaseSurface surface(mesh, Scheme::CatmullClark);
        forCorners(surface, [&](const BaseSample& sample, const MeshFace& face, size_t k) {
            EXPECT_LT(glm::length(sample.normal - motion.turn * Vec3(0, 1, 0)), 1e-9)
                << "sharpness " << sharpness << ", face " << face.index << ", corner " << k;
        });
    }
}

/// Collinear neighbors leave the plane to the rest of the face, whichever way rounding turns them. It is
/// taken a little inside, where the sine of S_u and S_v is 2^-10.
TEST(SmoothCorner, StraightCorner_HasPlaneOfFace) {
    std::mt19937 random(5);
    for (int run = 0; run < 100; ++run) {
        ControlMesh mesh;
        mesh.name = "kite";
        mesh.tags.boundaryCornersRound = run % 2 == 0;
        mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {-1, 0, 0}};
        addFace(mesh, {0, 1, 2, 3});
        const Motion motion(random);
        motion.apply(mesh);
        const BaseSurface surface(mesh, Scheme::CatmullClark);
        forCorners(surface, [&](const BaseSample& sample, const MeshFace&, size_t k) {
            EXPECT_LT(glm::length(sample.normal - motion.turn * Vec3(0, 0, 1)), 1e-8) << run << ", " << k;
        });
    }
}

TEST(SmoothCorner, ConstantRelief_KeepsNormal) {
    const Relief relief{std::make_shared<HeightMap>(HeightMap::constant("top", 0)), 0.3, 0.3};
    std::mt19937 random(6);
    ControlMesh mesh = sheet(3, 0, false);
    mesh.uvs.assign(1, Vec2(0));
    mesh.faceUvs.assign(mesh.faceVertices.size(), 0);
    const Motion motion(random);
    motion.apply(mesh);
    const Vec3 up = motion.turn * Vec3(0, 1, 0);
    const BaseSurface surface(mesh, Scheme::CatmullClark);
    forCorners(surface, [&](const BaseSample& sample, const MeshFace&, size_t) {
        const DisplacedSample displaced = displace(sample, &relief);
        EXPECT_LT(glm::length(displaced.normal - up), 1e-9);
        EXPECT_LT(glm::length(displaced.position - sample.position - 0.3 * up), 1e-9);
    });
}

} // namespace
} // namespace plumbline
