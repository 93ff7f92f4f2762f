// Concave polygons, outlines that touch or cross themselves, and faces that name a vertex twice.
#include "scenes/mesh/cut_faces.h"
#include "scenes/mesh/mesh_defects.h"
#include "scenes/mesh/outline.h"
#include "scenes/surface/base_surface.h"
#include "tests/errors.h"
#include "tests/scenes/mesh/mesh_checks.h"
#include "tests/scenes/mesh/test_meshes.h"

#include <glm/gtc/quaternion.hpp>

#include <gmock/gmock.h>
#include <random>

namespace plumbline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Triangles = std::vector<std::array<size_t, 3>>;

double shoelace(const std::vector<Vec2>& points) {
    double twice = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec2 &a = points[i], &b = points[(i + 1) % points.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

double areaOf(const std::vector<Vec2>& points, const std::array<size_t, 3>& triangle) {
    return shoelace({points[triangle[0]], points[triangle[1]], points[triangle[2]]});
}

/// One face, its vertices in the plane y = 0 and facing up.
ControlMesh polygon(const std::vector<Vec2>& points) {
    ControlMesh mesh;
    mesh.name = "polygon";
    mesh.faceSizes = {countOf(points)};
    for (const Vec2& point : points) {
        mesh.faceVertices.push_back(countOf(mesh.points));
        mesh.points.push_back(Vec3(point.x, 0, -point.y));
    }
    return mesh;
}

OutlineKind kindOf(const std::vector<Vec2>& points) {
    const ControlMesh mesh = polygon(points);
    return outlineOf(mesh, mesh.faces()[0]).kind;
}

double surfaceArea(const ControlMesh& mesh) {
    double area = 0;
    for (const MeshFace& face : mesh.faces())
        for (size_t k = 1; k + 1 < face.size; ++k)
            area += 0.5 * glm::length(
                              glm::cross(mesh.pointAt(face.corner(k)) - mesh.pointAt(face.firstCorner),
                                         mesh.pointAt(face.corner(k + 1)) - mesh.pointAt(face.firstCorner)));
    return area;
}

const std::vector<Vec2> kL{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};                 // area 5
const std::vector<Vec2> kU{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}; // area 7
const std::vector<Vec2> kArrow{{0, 0}, {2, 1}, {0, 2}, {0.5, 1}}; // turns right at the last; area 1.5
const std::vector<Vec2> kBowTie{{0, 0}, {2, 2}, {2, 0}, {0, 1}};

TEST(Outline, Kinds_AreTold) {
    EXPECT_EQ(kindOf({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), OutlineKind::Convex);
    EXPECT_EQ(kindOf({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}), OutlineKind::Convex);    // straight at (1, 0)
    EXPECT_EQ(kindOf({{0, 0}, {1, 1e-6}, {2, 0}, {2, 1}, {0, 1}}), OutlineKind::Convex); // by rounding
    EXPECT_EQ(kindOf({{0, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 1}}), OutlineKind::Convex);    // two at one place
    EXPECT_EQ(kindOf({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), OutlineKind::Convex);            // no area
    EXPECT_EQ(kindOf(kL), OutlineKind::Concave);
    EXPECT_EQ(kindOf(kArrow), OutlineKind::Concave);
    EXPECT_EQ(kindOf(kBowTie), OutlineKind::Crossing);
    EXPECT_EQ(kindOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), OutlineKind::Crossing); // its areas cancel
    std::vector<Vec2> star; // turns left everywhere, twice around
    for (int k = 0; k < 5; ++k)
        star.emplace_back(std::cos(0.8 * kPi * k), std::sin(0.8 * kPi * k));
    EXPECT_EQ(kindOf(star), OutlineKind::Crossing);
}

/// Cuts an outline and checks that the triangles are its inside.
void expectCut(const std::vector<Vec2>& points) {
    const Triangles triangles = cutOutline(points);
    double area = 0;
    std::map<std::pair<size_t, size_t>, int> uses;
    for (const auto& triangle : triangles) {
        EXPECT_GT(areaOf(points, triangle), 0);
        area += areaOf(points, triangle);
        for (size_t k = 0; k < 3; ++k) {
            ++uses[{triangle[k], triangle[(k + 1) % 3]}];
            --uses[{triangle[(k + 1) % 3], triangle[k]}];
        }
    }
    EXPECT_NEAR(area, shoelace(points), 1e-9 * std::abs(area));
    EXPECT_EQ(triangles.size(), points.size() - 2);
    for (size_t i = 0; i < points.size(); ++i) // inner edges cancel
        EXPECT_EQ((uses[{i, (i + 1) % points.size()}]), 1) << i;
}

TEST(CutOutline, Letters_KeepTheirInside) {
    expectCut(kL);
    expectCut(kU);
    expectCut(kArrow);
    expectCut({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}); // with a straight corner
}

TEST(CutOutline, RandomOutlines_KeepTheirInside) {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int run = 0; run < 300; ++run) {
        SCOPED_TRACE(run);
        const int corners = 4 + run % 60;
        std::vector<Vec2> points; // around a center, or a comb along a line
        for (int k = 0; k < corners; ++k)
            points.push_back(run % 2 ? between(0.1, 1) * Vec2(std::cos(2 * kPi * k / corners),
                                                              std::sin(2 * kPi * k / corners))
                                     : Vec2(k, k % 2 ? between(1, 9) : between(0.1, 0.9)));
        if (run % 2 == 0) { // back below the comb
            std::reverse(points.begin(), points.end());
            points.push_back({0, 0});
            points.push_back({corners - 1, 0});
        }
        expectCut(points);
    }
}

TEST(CutConcaveFaces, TurnedPolygons_KeepTheirArea) {
    std::mt19937 random(8);
    const auto number = [&] { return std::normal_distribution<double>(0, 1)(random); };
    for (const auto& [points, area] : {std::pair(kL, 5.0), std::pair(kU, 7.0), std::pair(kArrow, 1.5)})
        for (int run = 0; run < 20; ++run) {
            ControlMesh mesh = polygon(points);
            const glm::dquat turn = glm::normalize(glm::dquat(number(), number(), number(), number()));
            for (Vec3& point : mesh.points)
                point = turn * point;
            const Vec3 up = turn * Vec3(0, 1, 0);
            const BaseSurface surface(mesh, Scheme::None);
            EXPECT_EQ(surface.mesh().faceCount(), countOf(points) - 2);
            EXPECT_NEAR(surfaceArea(surface.mesh()), area, 1e-12);
            BaseSurface::Evaluator evaluator(surface);
            for (int patch = 0; patch < countOf(surface.patches()); ++patch) {
                evaluator.setPatch(patch);
                const BaseSample sample = evaluator.sample(0.3, 0.3);
                EXPECT_GT(glm::dot(glm::cross(sample.positionU, sample.positionV), up), 0);
                EXPECT_NEAR(glm::dot(sample.normal, up), 1, 1e-12);
            }
        }
}

TEST(CutConcaveFaces, ConvexFaces_StayAsTheyAre) {
    ControlMesh mesh = prismMesh(7);
    const ControlMesh before = mesh;
    cutConcaveFaces(mesh);
    EXPECT_EQ(mesh.faceSizes, before.faceSizes);
    EXPECT_EQ(mesh.faceVertices, before.faceVertices);
    EXPECT_THAT(mesh.faceNumbers, IsEmpty());
}

TEST(CutConcaveFaces, UvsNormalsLinesAndHoles_FollowTheirFaces) {
    ControlMesh mesh = polygon(kArrow);
    mesh.points.insert(mesh.points.end(), {{5, 0, 0}, {6, 0, 0}, {6, 0, -1}});
    addFace(mesh, {4, 5, 6});
    mesh.uvs = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}};
    mesh.faceUvs = {0, 1, 2, 3, 4, 5, 6};
    mesh.faceLines = {11, 12};
    mesh.tags.holes = {{1}};
    cutConcaveFaces(mesh);
    ASSERT_EQ(mesh.faceCount(), 3);
    EXPECT_EQ(mesh.faceUvs, mesh.faceVertices);
    EXPECT_THAT(mesh.faceLines, ElementsAre(11, 11, 12));
    EXPECT_EQ(whereOfFace(mesh, 2), "polygon:12: face 2");
    ASSERT_EQ(mesh.tags.holes.size(), 1u);
    EXPECT_EQ(mesh.tags.holes[0].face, 2);
}

TEST(CutConcaveFaces, OutlineThatCrossesItself_IsLeftOutWithWarning) {
    ControlMesh mesh = polygon(kBowTie);
    EXPECT_THAT(inputErrorOf([&] { BaseSurface(mesh, Scheme::None); }), HasSubstr("cross themselves"));
    mesh.points.insert(mesh.points.end(), {{5, 0, 0}, {6, 0, 0}, {6, 0, -1}});
    addFace(mesh, {4, 5, 6});
    EXPECT_EQ(BaseSurface(mesh, Scheme::None).patches().size(), 1u);
    EXPECT_THAT(meshWarnings(mesh, Scheme::None),
                ElementsAre("polygon: face 1 crosses its own outline: it has no inside and is left out"));
}

TEST(CutConcaveFaces, TooManyCorners_AreRefused) {
    std::vector<Vec2> comb{{20000, -1}, {0, -1}};
    for (int k = 0; k < 10001; ++k)
        comb.push_back({k, k % 2});
    std::reverse(comb.begin(), comb.end());
    ControlMesh mesh = polygon(comb);
    EXPECT_THAT(inputErrorOf([&] { cutConcaveFaces(mesh); }),
                HasSubstr("10003 corners and a concave outline"));
    comb.erase(comb.begin() + 10, comb.begin() + 20);
    expectCut(comb); // within seconds
}

ControlMesh repaired(std::initializer_list<int> vertices) {
    // 0 to 3: a square of side 3; 4 to 7: one of side 1 inside it, clockwise; 8 to 10: a triangle beside
    // them.
    ControlMesh mesh =
        polygon({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {5, 0}, {6, 0}, {5, 1}});
    mesh.faceSizes.clear();
    mesh.faceVertices.clear();
    addFace(mesh, vertices);
    addFace(mesh, {8, 9, 10});
    repairFaces(mesh);
    checkControlMesh(mesh, Scheme::CatmullClark);
    return mesh;
}

TEST(RepairFaces, VertexAfterItself_CountsOnce) {
    const ControlMesh mesh = repaired({0, 0, 1, 2, 2, 2, 3, 0});
    EXPECT_THAT(mesh.faceVertices, ElementsAre(0, 1, 2, 3, 8, 9, 10));
    EXPECT_THAT(mesh.warnings, ElementsAre("polygon: face 1 names vertex 1 twice: once counts"));
}

TEST(RepairFaces, EdgesThereAndBack_AreRemoved) {
    EXPECT_THAT(repaired({0, 1, 4, 1, 2, 3}).faceVertices, ElementsAre(0, 1, 2, 3, 8, 9, 10));
    EXPECT_THAT(repaired({0, 1, 4, 5, 4, 1, 2, 3}).faceVertices, ElementsAre(0, 1, 2, 3, 8, 9, 10));
    EXPECT_THAT(repaired({4, 0, 1, 2, 3, 0}).faceVertices, ElementsAre(0, 1, 2, 3, 8, 9, 10));
    EXPECT_THAT(repaired({0, 1, 2, 3, 0, 4}).faceVertices, ElementsAre(0, 1, 2, 3, 8, 9, 10));
}

TEST(RepairFaces, HoleJoinedToOutline_IsKept) {
    const ControlMesh mesh = repaired({0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
    EXPECT_THAT(mesh.warnings, ElementsAre("polygon: face 1 names vertex 1 twice: it is cut into triangles"));
    EXPECT_EQ(mesh.faceCount(), 8 + 1);
    EXPECT_NEAR(surfaceArea(mesh), 9 - 1 + 0.5, 1e-12);
}

TEST(RepairFaces, TwoLoopsAtOneVertex_AreBothKept) {
    const ControlMesh mesh = repaired({0, 1, 7, 2, 3, 7}); // pinched at (2, 1)
    EXPECT_THAT(mesh.warnings, ElementsAre(HasSubstr("names vertex 8 twice")));
    EXPECT_NEAR(surfaceArea(mesh), 1.5 + 3 + 0.5, 1e-12);
}

TEST(RepairFaces, OutlineTwiceAround_CountsOnce) {
    EXPECT_NEAR(surfaceArea(repaired({0, 1, 2, 3, 0, 1, 2, 3})), 9 + 0.5, 1e-12);
}

TEST(RepairFaces, RandomFaces_AreFacesOrLeftOut) {
    std::mt19937 random(9);
    for (int run = 0; run < 3000; ++run) {
        ControlMesh mesh = polygon({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0.5}});
        mesh.points.insert(mesh.points.end(), {{8, 0, 0}, {9, 0, 0}, {9, 0, -1}});
        mesh.faceSizes = {3 + run % 9};
        mesh.faceVertices.clear();
        for (int k = 0; k < mesh.faceSizes[0]; ++k)
            mesh.faceVertices.push_back(static_cast<int>(random() % 6));
        addFace(mesh, {6, 7, 8});
        repairFaces(mesh);
        checkControlMesh(mesh, Scheme::CatmullClark);
        EXPECT_EQ(BaseSurface(mesh, Scheme::None).mesh().faceVertices.back(), 8);
    }
}

TEST(RepairFaces, NothingLeft_IsDropped) {
    for (const std::initializer_list<int>& vertices :
         std::initializer_list<std::initializer_list<int>>{{0, 1, 0, 1}, {0, 1, 1}, {2, 2, 2, 2}}) {
        const ControlMesh mesh = repaired(vertices);
        EXPECT_EQ(mesh.faceCount(), 1);
        EXPECT_THAT(mesh.warnings, ElementsAre(HasSubstr("twice: it is left out")));
        EXPECT_EQ(whereOfFace(mesh, 0), "polygon: face 2");
    }
}

} // namespace
} // namespace plumbline
