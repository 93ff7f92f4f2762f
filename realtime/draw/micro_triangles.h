// Draws the reference's micro-meshes, the geometry of the control technique.
#pragma once

#include "realtime/gl/gl_objects.h"
#include "realtime/gl/gl_program.h"
#include "scenes/surface/micro_mesh.h"

#include <map>
#include <utility>
#include <vector>

namespace plumbline {

/// Uploads the grids in chunks through one buffer, so that GPU memory doesn't depend on the number of
/// micro-triangles.
class MicroTriangleDrawer {
  public:
    MicroTriangleDrawer();
    /// Draws one object with the program in use: attributes position (relative to the origin), normal, st.
    void draw(const MicroMesh& mesh, const Vec3& originWorld);

  private:
    struct VertexData {
        Vec3f position, normal;
        Vec2f st;
    };
    /// Grids of equal size share an index buffer.
    using Shape = std::pair<int, int>; // columns, rows

    void add(const MicroMesh& mesh, const MicroGrid& grid, const Vec3& originWorld);
    void flush();
    GLsizei bindIndices(const Shape& shape);

    GlVertexArray vertexArray_;
    GlBuffer vertices_;
    std::map<Shape, GlBuffer> indices_;
    std::vector<VertexData> chunk_;
    std::map<Shape, std::vector<GLint>> firstVertices_; // of the grids in the chunk
};

} // namespace plumbline
