// What the built-in shapes share: checks of their parameters and rectangular grids of quads.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline {

/// "shape 'torus'": where an error about a shape is.
std::string whereOfShape(std::string_view shape);

/// Throws InputError "shape 'torus': minor = -1; expected a positive number" unless value is positive and
/// finite.
void requirePositive(std::string_view shape, std::string_view parameter, double value);
void requireFinite(std::string_view shape, std::string_view parameter, double value);
void requireSegments(std::string_view shape, std::string_view parameter, int value, int fewest, int most);
/// Throws unless a cage of so many faces is within kMostShapeFaces.
void requireFaces(std::string_view shape, int64_t faces);

/// Appends quads of a grid of columns x rows faces. `vertex(i, j)` and `uv(i, j)` give indices for lattice
/// places 0 <= i <= columns, 0 <= j <= rows; i to the right, j up, seen from outside.
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

/// Appends the uvs of a lattice of (columns + 1) x (rows + 1) places, from `low` to `high`; returns the
/// first's index. Place (i, j) is at index first + j * (columns + 1) + i.
int appendUvLattice(ControlMesh& mesh, int columns, int rows, const Vec2& low, const Vec2& high);

} // namespace plumbline
