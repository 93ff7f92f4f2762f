#include "realtime/draw/micro_triangles.h"

#include <cstddef>
#include <cstdint>

namespace plumbline {
namespace {

// Vertices per upload: 8 MiB.
constexpr size_t kChunkVertices = size_t(1) << 18;

GLsizei indexCount(int columns, int rows) {
    return static_cast<GLsizei>(6 * (columns - 1) * (rows - 1));
}

/// The triangles a b c and d c b of every cell (scenes/surface/micro_mesh.h).
std::vector<uint16_t> gridIndices(int columns, int rows) {
    std::vector<uint16_t> indices;
    indices.reserve(static_cast<size_t>(indexCount(columns, rows)));
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const auto a = static_cast<uint16_t>(row * columns + column);
            const auto b = static_cast<uint16_t>(a + 1), c = static_cast<uint16_t>(a + columns),
                       d = static_cast<uint16_t>(a + columns + 1);
            indices.insert(indices.end(), {a, b, c, d, c, b});
        }
    return indices;
}

void describeAttribute(GLuint location, GLint components, GLsizei stride, size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(
        location, components, GL_FLOAT, GL_FALSE, stride,
        reinterpret_cast<const void*>(offset)); // NOLINT(performance-no-int-to-ptr): OpenGL's interface
}

} // namespace

MicroTriangleDrawer::MicroTriangleDrawer()
    : vertexArray_(GlVertexArray::make()), vertices_(GlBuffer::make()) {
    chunk_.reserve(kChunkVertices);
    glBindVertexArray(vertexArray_.get());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    constexpr auto stride = static_cast<GLsizei>(sizeof(VertexData));
    describeAttribute(0, 3, stride, offsetof(VertexData, position));
    describeAttribute(1, 3, stride, offsetof(VertexData, normal));
    describeAttribute(4, 2, stride, offsetof(VertexData, st));
}

void MicroTriangleDrawer::draw(const MicroMesh& mesh, const Vec3& originWorld) {
    glBindVertexArray(vertexArray_.get());
    for (const MicroGrid& grid : mesh.grids) {
        const size_t count = static_cast<size_t>(grid.columns) * grid.rows;
        if (chunk_.size() + count > kChunkVertices) flush();
        add(mesh, grid, originWorld);
    }
    flush();
}

void MicroTriangleDrawer::add(const MicroMesh& mesh, const MicroGrid& grid, const Vec3& originWorld) {
    const Shape shape(grid.columns, grid.rows);
    firstVertices_[shape].push_back(static_cast<GLint>(chunk_.size()));
    const size_t end = grid.firstVertex + static_cast<size_t>(grid.columns) * grid.rows;
    for (size_t i = grid.firstVertex; i < end; ++i)
        chunk_.push_back(
            {Vec3f(Vec3(mesh.positionsWorld[i]) - originWorld), mesh.normalsWorld[i], mesh.st[i]});
}

GLsizei MicroTriangleDrawer::bindIndices(const Shape& shape) {
    GlBuffer& buffer = indices_[shape];
    const bool isNew = !buffer;
    if (isNew) buffer = GlBuffer::make();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.get());
    if (isNew) {
        const std::vector<uint16_t> indices = gridIndices(shape.first, shape.second);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(uint16_t)),
                     indices.data(), GL_STATIC_DRAW);
    }
    return indexCount(shape.first, shape.second);
}

void MicroTriangleDrawer::flush() {
    if (chunk_.empty()) return;
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(chunk_.size() * sizeof(VertexData)), chunk_.data(),
                 GL_STREAM_DRAW);
    for (auto& [shape, firsts] : firstVertices_) {
        const std::vector<GLsizei> counts(firsts.size(), bindIndices(shape));
        const std::vector<const void*> offsets(firsts.size(), nullptr);
        glMultiDrawElementsBaseVertex(GL_TRIANGLES, counts.data(), GL_UNSIGNED_SHORT, offsets.data(),
                                      static_cast<GLsizei>(firsts.size()), firsts.data());
        firsts.clear();
    }
    chunk_.clear();
}

} // namespace plumbline
