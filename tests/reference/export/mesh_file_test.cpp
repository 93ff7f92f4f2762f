// Mesh files read back: identical triangles, unique vertices, a closed surface.
#include "reference/export/mesh_file.h"
#include "reference/export/mesh_numbers.h"
#include "reference/reference.h"
#include "scenes/mesh/shapes/shapes.h"
#include "tests/errors.h"
#include "tests/files.h"
#include "tests/reference/tessellate/micro_mesh_checks.h"
#include "tests/reference/test_scenes.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <gmock/gmock.h>
#include <set>
#include <sstream>
#include <sys/resource.h>

namespace plumbline {
namespace {

using testing::HasSubstr;

struct FileMesh {
    std::vector<std::array<float, 8>> vertices; // position, normal, st
    std::vector<std::array<int32_t, 3>> triangles;
    std::vector<int32_t> objects; // per triangle

    std::vector<Triangle> bag() const {
        std::vector<Triangle> all;
        for (const auto& corners : triangles) {
            Triangle triangle;
            for (size_t k = 0; k < 3; ++k) {
                const auto& v = vertices.at(static_cast<size_t>(corners[k]));
                triangle[k] = Vec3f(v[0], v[1], v[2]);
            }
            all.push_back(triangle);
        }
        return all;
    }
};

FileMesh readPly(const std::string& bytes) {
    std::istringstream stream(bytes);
    std::string line;
    size_t vertices = 0, faces = 0;
    while (std::getline(stream, line) && line != "end_header") {
        if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
        if (line.starts_with("element face ")) faces = std::stoul(line.substr(13));
    }
    FileMesh mesh;
    mesh.vertices.resize(vertices);
    stream.read(reinterpret_cast<char*>(mesh.vertices.data()), static_cast<std::streamsize>(vertices * 32));
    for (size_t face = 0; face < faces; ++face) {
        char count = 0;
        std::array<int32_t, 4> values{};
        stream.read(&count, 1).read(reinterpret_cast<char*>(values.data()), 16);
        EXPECT_EQ(count, 3);
        mesh.triangles.push_back({values[0], values[1], values[2]});
        mesh.objects.push_back(values[3]);
    }
    EXPECT_TRUE(stream) << "too short";
    EXPECT_EQ(stream.peek(), std::char_traits<char>::eof()) << "too long";
    return mesh;
}

FileMesh readObj(const std::string& bytes) {
    std::istringstream stream(bytes);
    FileMesh mesh;
    int32_t object = 0;
    size_t texture = 0, normals = 0;
    for (std::string line, word; std::getline(stream, line);) {
        std::istringstream words(line);
        words >> word;
        if (word == "v") {
            auto& v = mesh.vertices.emplace_back();
            words >> v[0] >> v[1] >> v[2];
        } else if (word == "vt") {
            auto& v = mesh.vertices.at(texture++);
            words >> v[6] >> v[7];
        } else if (word == "vn") {
            auto& v = mesh.vertices.at(normals++);
            words >> v[3] >> v[4] >> v[5];
        } else if (word == "o") {
            ++object;
        } else if (word == "f") {
            auto& triangle = mesh.triangles.emplace_back();
            mesh.objects.push_back(object);
            for (int32_t& corner : triangle) {
                words >> word;
                corner = std::stoi(word) - 1;
                EXPECT_EQ(word, std::to_string(corner + 1) + "/" + std::to_string(corner + 1) + "/" +
                                    std::to_string(corner + 1));
            }
        }
        EXPECT_FALSE(words.fail()) << line;
    }
    return mesh;
}

/// A torus with texture seams along two of its circles, and a square without relief; faces with several
/// rates.
Scene torusAndSquare() {
    std::vector<float> depths;
    for (int k = 0; k < 64; ++k)
        depths.push_back(float((k * 37) % 64) / 63.0f);
    Scene scene = squareScene(nullptr, 0);
    SceneObject torus;
    torus.name = "torus\nof two lines";
    torus.mesh = makeTorus(1.0, 0.4, 8, 4);
    torus.relief = Relief{std::make_shared<HeightMap>("noise", 8, 8, depths), 0.05, 0.0, Vec2(3, 2), Vec2(0)};
    scene.objects.insert(scene.objects.begin(), torus);
    return scene;
}

class MeshFile : public testing::Test {
  protected:
    MeshFile() : scene_(torusAndSquare()), reference_(scene_, options()) {}
    static ReferenceOptions options() {
        ReferenceOptions options;
        options.rate = 32;
        options.microAttributes = true;
        return options;
    }
    std::vector<MeshFileObject> objects() const {
        std::vector<MeshFileObject> all;
        for (size_t k = 0; k < scene_.objects.size(); ++k)
            all.push_back({scene_.objects[k].name, &reference_.microMeshes()[k]});
        return all;
    }
    MeshFileSize write(const std::string& name) {
        return writeMeshFile(folder_ / name, objects(), std::vector<std::string>{"a comment"});
    }

    TemporaryFolder folder_;
    Scene scene_;
    ReferenceScene reference_;
};

std::vector<std::array<float, 9>> sorted(const std::vector<Triangle>& triangles) {
    std::vector<std::array<float, 9>> all(triangles.size());
    for (size_t k = 0; k < triangles.size(); ++k)
        std::memcpy(&all[k], &triangles[k], sizeof all[k]);
    std::sort(all.begin(), all.end());
    return all;
}

TEST_F(MeshFile, ExportedTriangles_EqualTracedBitForBit) {
    std::vector<Triangle> traced;
    for (const MicroMesh& mesh : reference_.microMeshes())
        for (const Triangle& triangle : trianglesWithArea(mesh))
            traced.push_back(triangle);
    for (const char* name : {"a.ply", "a.obj"}) {
        const MeshFileSize size = write(name);
        const std::string bytes = readFile(folder_ / name);
        const FileMesh mesh = std::string(name) == "a.ply" ? readPly(bytes) : readObj(bytes);
        EXPECT_EQ(size.bytes, bytes.size());
        EXPECT_EQ(size.vertices, mesh.vertices.size());
        EXPECT_EQ(size.triangles, mesh.triangles.size());
        EXPECT_EQ(sorted(mesh.bag()), sorted(traced)) << name;
        EXPECT_EQ(std::count(mesh.objects.begin(), mesh.objects.end(), 1), 8 * 4 * 32 * 32 * 2);
        EXPECT_EQ(std::count(mesh.objects.begin(), mesh.objects.end(), 2), 32 * 32 * 2);
    }
    EXPECT_EQ(folder_.fileCount(), 2u); // no temporary file is left
}

TEST_F(MeshFile, Vertices_AreUniqueWithNormalsAndSt) {
    write("a.ply");
    const FileMesh mesh = readPly(readFile(folder_ / "a.ply"));
    const std::set<std::array<float, 8>> different(mesh.vertices.begin(), mesh.vertices.end());
    EXPECT_EQ(different.size(), mesh.vertices.size());
    // V = 8 * 4 * 32^2 on the torus, plus the duplicates at the seams: 8 * 32 along one circle and 4 * 32 + 1
    // along the other, with two more at their crossing; 33^2 on the square. The corners of the circles may
    // differ in the last bit of st.
    const size_t torus = 8 * 4 * 32 * 32 + 8 * 32 + 4 * 32 + 1;
    EXPECT_GE(mesh.vertices.size(), torus + 33 * 33);
    EXPECT_LE(mesh.vertices.size(), torus + 33 * 33 + 2 * (8 + 4));
    const std::vector<Triangle> triangles = mesh.bag();
    for (size_t k = 0; k < triangles.size(); ++k) {
        Vec2 low(1e9), high(-1e9);
        Vec3 normal(0);
        for (const int32_t corner : mesh.triangles[k]) {
            const auto& v = mesh.vertices[static_cast<size_t>(corner)];
            low = glm::min(low, Vec2(v[6], v[7]));
            high = glm::max(high, Vec2(v[6], v[7]));
            const Vec3 n(v[3], v[4], v[5]);
            EXPECT_NEAR(glm::length(n), 1, 1e-6);
            normal += n;
        }
        // A cell is 3/8/32 x 2/4/32 of the map: no triangle spans the whole map at a seam.
        EXPECT_LT(high.x - low.x, 0.04) << k;
        EXPECT_LT(high.y - low.y, 0.04) << k;
        const Vec3 a(triangles[k][0]), b(triangles[k][1]), c(triangles[k][2]);
        EXPECT_GT(glm::dot(normal, glm::cross(b - a, c - a)), 0) << k; // counter-clockwise seen from outside
    }
}

TEST_F(MeshFile, EqualScenes_GiveEqualBytes) {
    write("a.ply");
    write("b.ply");
    EXPECT_EQ(readFile(folder_ / "a.ply"), readFile(folder_ / "b.ply"));
}

TEST_F(MeshFile, NamesWithNewlines_StayOneLine) {
    write("a.ply");
    EXPECT_THAT(readFile(folder_ / "a.ply"), HasSubstr("comment object_id 1: torus of two lines\n"));
    write("a.obj");
    EXPECT_THAT(readFile(folder_ / "a.obj"), HasSubstr("\no torus of two lines\n"));
}

TEST_F(MeshFile, UnwritablePlace_IsRefused) {
    EXPECT_THAT(inputErrorOf([&] { write("a.stl"); }), HasSubstr("a name that ends in .ply or .obj"));
    EXPECT_THAT(inputErrorOf([&] { write("none/a.ply"); }), HasSubstr("does not exist"));
    EXPECT_EQ(folder_.fileCount(), 0u);
}

TEST_F(MeshFile, FullDisk_KeepsOldFile) {
    writeFile(folder_ / "a.ply", "old");
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = old;
    small.rlim_cur = 4096; // less than the mesh
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string error = messageOf<MachineError>([&] { write("a.ply"); });
    setrlimit(RLIMIT_FSIZE, &old);
    EXPECT_THAT(error, HasSubstr("a.ply: can't be written: File too large"));
    EXPECT_EQ(readFile(folder_ / "a.ply"), "old");
    EXPECT_EQ(folder_.fileCount(), 1u);
}

ControlMesh octahedron() {
    ControlMesh mesh;
    mesh.name = "octahedron";
    mesh.points = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.faceSizes.assign(8, 3);
    for (int k = 0; k < 4; ++k) {
        mesh.faceVertices.insert(mesh.faceVertices.end(), {k, (k + 1) % 4, 4});
        mesh.faceVertices.insert(mesh.faceVertices.end(), {(k + 1) % 4, k, 5});
    }
    return mesh;
}

/// Checks only the numbering, including triangular lattices (Loop, none) and faces divided into sub-faces
/// (Catmull-Clark).
TEST(MeshNumbers, ClosedShell_IsClosed) {
    Scene scene = squareScene(nullptr, 0);
    scene.objects[0].mesh = octahedron();
    for (const Scheme scheme : {Scheme::Loop, Scheme::None, Scheme::CatmullClark}) {
        scene.objects[0].scheme = scheme;
        ReferenceOptions options;
        options.rate = 32;
        options.microAttributes = true;
        const ReferenceScene reference(scene, options);
        const MicroMesh& mesh = reference.microMeshes()[0];
        const MeshNumbers numbers = numberVertices(mesh);
        std::map<std::pair<uint32_t, uint32_t>, int> edges;
        forTriangles(mesh, [&](uint32_t a, uint32_t b, uint32_t c) {
            const uint32_t corners[] = {numbers.ofVertex[a], numbers.ofVertex[b], numbers.ofVertex[c]};
            for (int k = 0; k < 3; ++k) {
                ++edges[{corners[k], corners[(k + 1) % 3]}];
                --edges[{corners[(k + 1) % 3], corners[k]}];
            }
        });
        for (const auto& [edge, balance] : edges)
            ASSERT_EQ(balance, 0) << edge.first << " " << edge.second;
        // Euler: V - E + F = 2, E = 3/2 F.
        EXPECT_EQ(int64_t(numbers.vertexCount) - int64_t(numbers.triangleCount) / 2, 2);
    }
}

/// A cube with creased edges: each face has its own normals on them, a corner three.
TEST(MeshNumbers, Crease_HasVertexForEachNormal) {
    Scene scene = squareScene(nullptr, 0);
    scene.objects[0].mesh = makeBox(Vec3(2), 1);
    scene.objects[0].scheme = Scheme::CatmullClark;
    for (const MeshFace& face : scene.objects[0].mesh.faces())
        for (size_t k = 0; k < 4; ++k)
            scene.objects[0].mesh.tags.creases.push_back(
                {scene.objects[0].mesh.faceVertices[face.corner(k)],
                 scene.objects[0].mesh.faceVertices[face.corner(k + 1)], kInfinitelySharp});
    ReferenceOptions options;
    options.rate = 4;
    options.microAttributes = true;
    const ReferenceScene reference(scene, options);
    const MicroMesh& mesh = reference.microMeshes()[0];
    EXPECT_EQ(numberVertices(mesh).vertexCount, 6u * 5 * 5);
    for (size_t i = 0; i < mesh.positionsWorld.size(); ++i) // each is normal to a face it lies in
        EXPECT_NEAR(glm::dot(mesh.positionsWorld[i], mesh.normalsWorld[i]), 1, 1e-6);
}

} // namespace
} // namespace plumbline
