// Irregular faces are prepared once, whoever asks for them; regular ones each time.
#include "scenes/surface/limit_check.h"
#include "scenes/surface/prepared_faces.h"
#include "scenes/surface/topology.h"

#include <gtest/gtest.h>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>

#include <numbers>
#include <thread>

namespace plumbline {
namespace {

/// Triangles around vertex 0.
ControlMesh fan(int valence) {
    ControlMesh mesh;
    mesh.name = "fan";
    mesh.points.emplace_back(0, 0.5, 0);
    for (int i = 0; i < valence; ++i) {
        const double angle = 2 * std::numbers::pi * i / valence;
        mesh.points.emplace_back(std::cos(angle), 0, -std::sin(angle));
        mesh.faceSizes.push_back(3);
        mesh.faceVertices.insert(mesh.faceVertices.end(), {0, 1 + i, 1 + (i + 1) % valence});
    }
    return mesh;
}

/// n x n quads.
ControlMesh sheet(int n) {
    ControlMesh mesh;
    mesh.name = "sheet";
    for (int i = 0; i < (n + 1) * (n + 1); ++i)
        mesh.points.emplace_back(i % (n + 1), 0, -(i / (n + 1)));
    for (int i = 0; i < n * n; ++i) {
        const int corner = i / n * (n + 1) + i % n;
        mesh.faceSizes.push_back(4);
        mesh.faceVertices.insert(mesh.faceVertices.end(),
                                 {corner, corner + 1, corner + n + 2, corner + n + 1});
    }
    return mesh;
}

struct Subdivision {
    ControlMesh mesh;
    std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> refiner = makeTopology(mesh, Scheme::CatmullClark);
    OpenSubdiv::Bfr::RefinerSurfaceFactory<> factory{*refiner};
    PreparedFaces faces{factory, mesh};
};

TEST(PreparedFaces, irregular_face_from_two_threads_is_the_same_object) {
    Subdivision subdivision{fan(64)};
    std::vector<std::shared_ptr<const PreparedFace>> first(64), second(64);
    const auto prepareAll = [&](auto& into) {
        for (int face = 0; face < 64; ++face)
            into[static_cast<size_t>(face)] = subdivision.faces.face(face);
    };
    std::thread other([&] { prepareAll(second); });
    prepareAll(first);
    other.join();
    for (int face = 0; face < 64; ++face) {
        const auto kept = subdivision.faces.face(face);
        EXPECT_EQ(kept, subdivision.faces.face(face)) << face;
        EXPECT_EQ(kept->patchPoints, first[static_cast<size_t>(face)]->patchPoints) << face;
        EXPECT_EQ(kept->patchPoints, second[static_cast<size_t>(face)]->patchPoints) << face;
    }
}

TEST(PreparedFaces, faces_around_a_vertex_of_the_highest_valence_fit) {
    Subdivision subdivision{fan(kMaxLimitEdges)};
    EXPECT_LE(kMaxLimitEdges * subdivision.faces.face(0)->bytes(), kMaxKeptBytes);
}

TEST(PreparedFaces, regular_face_isnt_kept) {
    Subdivision subdivision{sheet(3)};
    const auto inner = subdivision.faces.face(4);
    ASSERT_TRUE(inner->surface.IsRegular());
    EXPECT_NE(inner, subdivision.faces.face(4));
}

} // namespace
} // namespace plumbline
