// Helpers shared by the built-in shapes: parameter checks and rectangular grids of quads.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline {

/// "shape 'torus'": the location in error messages about a shape.
std::string whereOfShape(std::string_view shape);

/// Throws InputError "shape 'torus': minor = -1; expected a positive number" unless value is positive and
/// finite.
void requirePositive(std::string_view shape, std::string_view parameter, double value);
void requireFinite(std::string_view shape, std::string_view parameter, double value);
void requireSegments(std::string_view shape, std::string_view parameter, int value, int fewest, int most);
/// Throws if the number of faces exceeds kMaxShapeFaces.
void requireFaces(std::string_view shape, int64_t faces);

/// Appends quads of a grid of columns x rows faces. `vertex(i, j)` and `uv(i, j)` return indices for lattice
/// points 0 <= i <= columns, 0 <= j <= rows; seen from outside, i increases to the right and j upwards.
template <typename VertexIndex, typename UvIndex>
void appendQuads(ControlMesh& mesh, int columns, int rows, VertexIndex vertex, UvIndex uv) {
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            mesh.faceSizes.push_back(4);
            constexpr int kCorners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
            for (const auto& corner : kCorners) {
                mesh.faceVertices.push_back(vertex(i + corner[0], j + corner[1]));
                mesh.faceUvs.push_back(uv(i + corner[0], j + corner[1]));
            }
        }
}

/// Appends the uvs of a lattice of (columns + 1) x (rows + 1) points from `low` to `high` and returns the
/// index of the first. Point (i, j) has index first + j * (columns + 1) + i.
int appendUvLattice(ControlMesh& mesh, int columns, int rows, const Vec2& low, const Vec2& high);

} // namespace plumbline
