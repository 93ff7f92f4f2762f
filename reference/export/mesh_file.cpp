#include "reference/export/mesh_file.h"

#include "reference/export/mesh_numbers.h"
#include "scenes/core/error.h"
#include "scenes/core/printable.h"
#include "scenes/core/replace_file.h"

#include <fmt/format.h>

#include <limits>

namespace plumbline {
namespace {

constexpr size_t kPieceBytes = size_t(1) << 20;

bool isObj(const std::filesystem::path& file) {
    return file.extension() == ".obj";
}

/// Buffers output and writes it in pieces.
class PieceWriter {
  public:
    explicit PieceWriter(OutputStream& stream) : stream_(stream) { piece_.reserve(kPieceBytes + 1024); }
    std::string& piece() { return piece_; }
    /// Must be called after each small addition to the piece.
    void flushIfFull() {
        if (piece_.size() >= kPieceBytes) flush();
    }
    template <class T>
    void binary(const T& value) {
        piece_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void flush() {
        stream_.write(piece_);
        piece_.clear();
    }

  private:
    OutputStream& stream_;
    std::string piece_;
};

std::vector<MeshNumbers> numberObjects(std::span<const MeshFileObject> objects) {
    std::vector<MeshNumbers> numbers;
    for (const MeshFileObject& object : objects)
        numbers.push_back(numberVertices(*object.mesh));
    return numbers;
}

/// Calls visit(vertex) for the micro-vertex of each number, in the order of the numbers.
template <class Visit>
void forNumbers(const MeshNumbers& numbers, Visit&& visit) {
    uint32_t next = 0;
    for (size_t vertex = 0; vertex < numbers.ofVertex.size(); ++vertex)
        if (numbers.ofVertex[vertex] == next) {
            visit(vertex);
            ++next;
        }
}

void writePly(PieceWriter& out, std::span<const MeshFileObject> objects, std::span<const MeshNumbers> numbers,
              const MeshFileSize& size, std::span<const std::string> comments) {
    std::string header = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : comments)
        header += fmt::format("comment {}\n", printable(comment));
    for (size_t k = 0; k < objects.size(); ++k)
        header += fmt::format("comment object_id {}: {}\n", k + 1, printable(objects[k].name));
    header += fmt::format("element vertex {}\n", size.vertices);
    for (const char* property : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
        header += fmt::format("property float {}\n", property);
    out.piece() += fmt::format("{}element face {}\nproperty list uchar int vertex_indices\n"
                               "property int object_id\nend_header\n",
                               header, size.triangles);
    // Embree only runs on little-endian machines.
    for (size_t k = 0; k < objects.size(); ++k)
        forNumbers(numbers[k], [&](size_t vertex) {
            out.binary(objects[k].mesh->positionsWorld[vertex]);
            out.binary(objects[k].mesh->normalsWorld[vertex]);
            out.binary(objects[k].mesh->st[vertex]);
            out.flushIfFull();
        });
    uint32_t first = 0;
    for (size_t k = 0; k < objects.size(); ++k) {
        forTriangles(*objects[k].mesh, [&](uint32_t a, uint32_t b, uint32_t c) {
            out.binary(uint8_t(3));
            for (const uint32_t corner : {a, b, c})
                out.binary(static_cast<int32_t>(first + numbers[k].ofVertex[corner]));
            out.binary(static_cast<int32_t>(k + 1));
            out.flushIfFull();
        });
        first += numbers[k].vertexCount;
    }
}

void writeObj(PieceWriter& out, std::span<const MeshFileObject> objects, std::span<const MeshNumbers> numbers,
              std::span<const std::string> comments) {
    for (const std::string& comment : comments)
        out.piece() += fmt::format("# {}\n", printable(comment));
    uint32_t first = 1;
    for (size_t k = 0; k < objects.size(); ++k) {
        const MicroMesh& mesh = *objects[k].mesh;
        out.piece() += fmt::format("o {}\n", printable(objects[k].name));
        forNumbers(numbers[k], [&](size_t vertex) {
            const Vec3f &p = mesh.positionsWorld[vertex], &n = mesh.normalsWorld[vertex];
            const Vec2f& st = mesh.st[vertex];
            fmt::format_to(std::back_inserter(out.piece()), "v {} {} {}\nvt {} {}\nvn {} {} {}\n", p.x, p.y,
                           p.z, st.x, st.y, n.x, n.y, n.z);
            out.flushIfFull();
        });
        forTriangles(mesh, [&](uint32_t a, uint32_t b, uint32_t c) {
            out.piece() += 'f';
            for (const uint32_t corner : {a, b, c})
                fmt::format_to(std::back_inserter(out.piece()), " {0}/{0}/{0}",
                               first + numbers[k].ofVertex[corner]);
            out.piece() += '\n';
            out.flushIfFull();
        });
        first += numbers[k].vertexCount;
    }
}

} // namespace

void requireMeshFileName(const std::filesystem::path& file) {
    if (file.extension() != ".ply" && !isObj(file))
        throw InputError(
            file.string(),
            fmt::format("'{}' is not a known extension of mesh files", file.extension().string()),
            "a name that ends in .ply or .obj");
}

MeshFileSize writeMeshFile(const std::filesystem::path& file, std::span<const MeshFileObject> objects,
                           std::span<const std::string> comments) {
    requireMeshFileName(file);
    const std::vector<MeshNumbers> numbers = numberObjects(objects);
    MeshFileSize size;
    for (const MeshNumbers& object : numbers) {
        size.vertices += object.vertexCount;
        size.triangles += object.triangleCount;
    }
    if (size.vertices > uint64_t(std::numeric_limits<int32_t>::max()))
        throw InputError(file.string(),
                         fmt::format("{} vertices are too many for a mesh file", size.vertices),
                         "at most 2^31 - 1", "a lower --rate");
    replaceFile(file, [&](OutputStream& stream) {
        PieceWriter out(stream);
        if (isObj(file))
            writeObj(out, objects, numbers, comments);
        else
            writePly(out, objects, numbers, size, comments);
        out.flush();
        size.bytes = stream.position();
    });
    return size;
}

} // namespace plumbline
