// The outline of a polygon in the plane that fits it best: whether it is convex, and its division into
// triangles if it isn't.
#pragma once

#include "scenes/mesh/control_mesh.h"

#include <array>
#include <vector>

namespace plumbline {

enum class OutlineKind {
    Convex,   // also one without area
    Concave,  // may touch itself
    Crossing, // crosses itself, so that it has no inside
};

struct Outline {
    OutlineKind kind = OutlineKind::Convex;
    std::vector<Vec2> points; // counterclockwise; empty if it is convex
};

/// The outline of a face's corners, orthogonal to the face's area vector. Corners that turn the wrong way by
/// less than 1e-4 (sine) count as straight.
Outline outlineOf(const ControlMesh& mesh, const MeshFace& face);

/// Corners of a face beyond which a concave outline isn't cut: the time grows with the square.
inline constexpr size_t kMaxConcaveCorners = 10000;

/// Cuts a concave outline into triangles, counterclockwise, as indices into its points: n - 2 of them, less
/// those without area where it touches itself. All of its edges remain edges. Ear clipping (Meisters:
/// Polygons have ears, 1975).
std::vector<std::array<size_t, 3>> cutOutline(const std::vector<Vec2>& points);

} // namespace plumbline
