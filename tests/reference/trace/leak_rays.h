// Closed displaced surfaces, and rays aimed where leaks are most likely.
#pragma once

#include "reference/tessellate/tessellate.h"
#include "reference/trace/embree_scene.h"
#include "scenes/maps/generate_map.h"
#include "scenes/mesh/shapes/shapes.h"
#include "scenes/surface/displaced_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace plumbline {

/// Twenty triangles with vertices at distance 1.9 from the center; every triangle has its own uvs, so all
/// edges are torn.
inline ControlMesh tornIcosahedron() {
    ControlMesh mesh;
    mesh.name = "icosahedron";
    const double phi = (1 + std::sqrt(5.0)) / 2;
    mesh.points = {{-1, phi, 0},  {1, phi, 0},  {-1, -phi, 0}, {1, -phi, 0}, {0, -1, phi},  {0, 1, phi},
                   {0, -1, -phi}, {0, 1, -phi}, {phi, 0, -1},  {phi, 0, 1},  {-phi, 0, -1}, {-phi, 0, 1}};
    mesh.faceSizes.assign(20, 3);
    mesh.faceVertices = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                         4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                         6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int k = 0; k < 60; ++k) {
        mesh.uvs.push_back(Vec2(0.37 * k, 0.61 * ((k * 7) % 60)));
        mesh.faceUvs.push_back(k);
    }
    return mesh;
}

/// A closed surface as micro-triangles, with data for aiming rays at it.
class LeakTarget {
  public:
    /// The interior: spherical surfaces contain their center, a torus contains its center circle of radius 1.
    enum class Inside { Center, Circle };

    LeakTarget(const ControlMesh& mesh, Scheme scheme, Inside inside, int rate, double scale)
        : inside_(inside), scale_(scale) {
        SceneObject object;
        object.name = mesh.name;
        object.mesh = mesh;
        object.scheme = scheme;
        object.scale = scale;
        object.relief =
            Relief{std::make_shared<HeightMap>(generateMap("cobbles", 32, 1, Wrap::Repeat, Wrap::Repeat)),
                   0.05 * scale, 0.0, Vec2(1), Vec2(0)};
        const auto surface = makeBaseSurface(object);
        meshes.push_back(tessellate(*surface, &*object.relief, uniformRates(*surface, rate), false));
        listTriangles();
    }

    struct Aim {
        Vec3f place;                     // on a micro-edge, at a micro-vertex or inside a micro-triangle
        bool outer = true, inner = true; // all facets there face the origin with this side, and not edge-on
    };
    Aim atTriangle(std::mt19937& random, const Vec3& origin) const {
        const std::array<size_t, 3>& triangle = pickTriangle(random);
        double b = unit(random), c = unit(random);
        if (b + c > 1) b = 1 - b, c = 1 - c;
        return aim((1 - b - c) * at(triangle[0]) + b * at(triangle[1]) + c * at(triangle[2]), triangle, 3,
                   origin);
    }
    Aim atEdge(std::mt19937& random, const Vec3& origin) const {
        const std::array<size_t, 3>& triangle = pickTriangle(random);
        const double b = unit(random);
        return aim((1 - b) * at(triangle[0]) + b * at(triangle[1]), triangle, 2, origin);
    }
    Aim atVertex(std::mt19937& random, const Vec3& origin) const {
        const std::array<size_t, 3>& triangle = pickTriangle(random);
        return aim(at(triangle[0]), triangle, 1, origin);
    }

    Vec3f insidePoint(std::mt19937& random) const {
        const Vec3 wobble = 0.1 * Vec3(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
        if (inside_ == Inside::Center) return scale_ * wobble;
        const double angle = 2 * kPi * unit(random);
        return scale_ * (Vec3(std::cos(angle), 0, std::sin(angle)) + wobble);
    }
    Vec3f outsidePoint(std::mt19937& random) const {
        return scale_ * (4 + 4 * unit(random)) * direction(random);
    }
    static Vec3 direction(std::mt19937& random) {
        const double z = 2 * unit(random) - 1, angle = 2 * kPi * unit(random), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }
    double scale() const { return scale_; }

    std::vector<MicroMesh> meshes; // one

  private:
    static double unit(std::mt19937& random) { return std::uniform_real_distribution<double>()(random); }

    Vec3 at(size_t place) const { return Vec3(places_[place]); }
    const std::array<size_t, 3>& pickTriangle(std::mt19937& random) const {
        return triangles_[std::uniform_int_distribution<size_t>(0, triangles_.size() - 1)(random)];
    }

    /// Only the first `corners` of the triangle are used: their fans contain every facet at the place, and
    /// some adjacent ones.
    Aim aim(const Vec3& place, const std::array<size_t, 3>& triangle, size_t corners,
            const Vec3& origin) const {
        constexpr double kMinCosine = 0.1; // 84 degrees, so that a rounded ray can't change the sign
        const Vec3 direction = glm::normalize(place - origin);
        Aim result{place};
        for (size_t k = 0; k < corners; ++k)
            for (const Vec3& normal : fans_[triangle[k]]) {
                const double cosine = glm::dot(normal, direction);
                result.outer = result.outer && cosine < -kMinCosine;
                result.inner = result.inner && cosine > kMinCosine;
            }
        return result;
    }

    void listTriangles() {
        const auto byCoordinates = [](const Vec3f& a, const Vec3f& b) {
            return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
        };
        std::map<Vec3f, size_t, decltype(byCoordinates)> known(byCoordinates);
        const auto placeOf = [&](const Vec3f& position) {
            const auto [entry, isNew] = known.try_emplace(position, places_.size());
            if (isNew) places_.push_back(position);
            return entry->second;
        };
        const auto add = [&](const Vec3f& a, const Vec3f& b, const Vec3f& c) {
            if (a != b && b != c && c != a) triangles_.push_back({placeOf(a), placeOf(b), placeOf(c)});
        };
        for (const MicroGrid& grid : meshes[0].grids)
            for (uint32_t row = 0; row + 1 < grid.rows; ++row)
                for (uint32_t column = 0; column + 1 < grid.columns; ++column) {
                    const Vec3f* a =
                        &meshes[0].positionsWorld[grid.firstVertex + row * grid.columns + column];
                    add(a[0], a[1], a[grid.columns]);
                    add(a[grid.columns + 1], a[grid.columns], a[1]);
                }
        fans_.resize(places_.size());
        for (const std::array<size_t, 3>& t : triangles_)
            for (const size_t corner : t)
                fans_[corner].push_back(glm::normalize(glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]))));
    }

    Inside inside_;
    double scale_;
    std::vector<Vec3f> places_;
    std::vector<std::array<size_t, 3>> triangles_; // into places_
    std::vector<std::vector<Vec3>> fans_;          // per place: unit normals of the incident facets
};

inline std::vector<LeakTarget> leakTargets(double scale) {
    std::vector<LeakTarget> targets;
    using Inside = LeakTarget::Inside;
    targets.emplace_back(makeSphere(1, 4), Scheme::CatmullClark, Inside::Center, 16, scale);
    targets.emplace_back(makeTorus(1, 0.4, 16, 8), Scheme::CatmullClark, Inside::Circle, 16, scale);
    targets.emplace_back(makeBox(Vec3(2), 1), Scheme::CatmullClark, Inside::Center, 64, scale);
    targets.emplace_back(tornIcosahedron(), Scheme::Loop, Inside::Center, 32, scale);
    return targets;
}

} // namespace plumbline
