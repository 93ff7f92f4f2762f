#include "reference/export/mesh_numbers.h"

#include <bit>
#include <cassert>
#include <cstring>

namespace plumbline {
namespace {

constexpr uint32_t kNone = ~uint32_t(0);

struct VertexBits {
    std::array<uint32_t, 8> words;
    bool operator==(const VertexBits&) const = default;

    VertexBits(const MicroMesh& mesh, uint32_t vertex) {
        std::memcpy(&words[0], &mesh.positionsWorld[vertex], 12);
        std::memcpy(&words[3], &mesh.normalsWorld[vertex], 12);
        std::memcpy(&words[6], &mesh.st[vertex], 8);
    }
    /// FNV-1a over words, with the high bits folded into the low ones that the table uses.
    size_t hash() const {
        uint64_t value = 14695981039346656037u;
        for (const uint32_t word : words)
            value = (value ^ word) * 1099511628211u;
        return value ^ (value >> 32);
    }
};

/// A hash table of vertices by value with open addressing; it stores indices into the mesh, which must not
/// move.
class VertexTable {
  public:
    VertexTable(const MicroMesh& mesh, size_t mostVertices)
        : mesh_(mesh), slots_(std::bit_ceil(2 * mostVertices + 1), kNone) {}

    /// The first vertex looked up that equals this one; the vertex itself if there was none.
    uint32_t firstLike(uint32_t vertex) {
        const VertexBits bits(mesh_, vertex);
        for (size_t slot = bits.hash();; ++slot) {
            uint32_t& entry = slots_[slot & (slots_.size() - 1)];
            if (entry == kNone) entry = vertex;
            if (entry == vertex || VertexBits(mesh_, entry) == bits) return entry;
        }
    }

  private:
    const MicroMesh& mesh_;
    std::vector<uint32_t> slots_;
};

/// Whether a vertex may be a duplicate. In the interior of a square patch's grid each vertex has its own (u,
/// v); beyond a triangle's hypotenuse vertices are duplicated.
bool mayBeRepeated(const MicroMesh& mesh, const MicroGrid& grid, int column, int row) {
    return column == 0 || row == 0 || column == grid.columns - 1 || row == grid.rows - 1 ||
           mesh.lattices[grid.patch].triangular;
}

template <class Visit>
void forVertices(const MicroMesh& mesh, Visit&& visit) {
    for (const MicroGrid& grid : mesh.grids)
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column)
                visit(grid.vertex(column, row), mayBeRepeated(mesh, grid, column, row));
}

} // namespace

MeshNumbers numberVertices(const MicroMesh& mesh) {
    assert(mesh.normalsWorld.size() == mesh.positionsWorld.size() &&
           mesh.st.size() == mesh.positionsWorld.size());
    size_t repeatable = 0;
    forVertices(mesh, [&](uint32_t, bool mayRepeat) { repeatable += mayRepeat; });
    VertexTable table(mesh, repeatable);
    MeshNumbers numbers;
    numbers.ofVertex.resize(mesh.positionsWorld.size());
    forVertices(mesh, [&](uint32_t vertex, bool mayRepeat) {
        const uint32_t first = mayRepeat ? table.firstLike(vertex) : vertex;
        numbers.ofVertex[vertex] = first == vertex ? numbers.vertexCount++ : numbers.ofVertex[first];
    });
    forTriangles(mesh, [&](uint32_t, uint32_t, uint32_t) { ++numbers.triangleCount; });
    return numbers;
}

} // namespace plumbline
