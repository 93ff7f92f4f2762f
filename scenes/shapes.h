// Built-in control meshes: the `shape = { kind = … }` of a scene file. All have uvs.
#pragma once

#include "control_mesh.h"

#include <string>
#include <vector>

namespace plumbline {

/// A plane in the xz plane facing +Y, centred; uv (0,0) at (-x, +z), so that seen from above it isn't mirrored.
ControlMesh makePlane(double width, double depth, int segmentsX, int segmentsZ);

/// z = a x^2 + b y^2 over [-halfSize, halfSize]^2, facing +z: exact as a bicubic limit surface.
ControlMesh makeQuadric(double a, double b, double halfSize, int segments);

/// Six grids of a cube pushed out to a sphere; uv runs once over each face.
ControlMesh makeSphere(double radius, int segmentsPerCubeEdge);

/// Around Y, centred, without caps; uv runs once around and once from bottom to top.
ControlMesh makeCylinder(double radius, double height, int segmentsAround, int segmentsUp);

/// Around Y; u runs once around the axis, v once around the tube.
ControlMesh makeTorus(double major, double minor, int segmentsMajor, int segmentsMinor);

/// Edge lengths along x, y, z; uv runs once over each face.
ControlMesh makeBox(const Vec3& size, int segments);

/// The classic teapot: its 32 bicubic Bezier patches meshed with `segments` quads a side, coincident vertices joined;
/// y up, standing on y = 0, about 3.15 high.
ControlMesh makeTeapot(int segments);

} // namespace plumbline
