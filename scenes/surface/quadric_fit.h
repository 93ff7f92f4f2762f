// The quadric z = -(A x^2 + C x y + B y^2) that bends like a surface at a point, for relief on curved bases
// (Oliveira, Policarpo, UFRGS RP-351 (2005), section 3).
//
// x and y are world units along the unit tangents of s and t, which need not be at a right angle; z along the
// unit normal, outward. A > 0 where the surface is convex along s: the sign their Eqs 6 and 7 need, not that
// of their fit of section 3.1. Coefficients are world units^-1. The cross term is this project's.
#pragma once

#include "scenes/core/math.h"

#include <span>

namespace plumbline {

struct QuadricCoefficients {
    double a = 0, b = 0, c = 0;
};

/// Where a quadric is fitted: `tangentS` and `tangentT` of any length, none zero; `normal` unit.
struct QuadricFrame {
    Vec3 origin, tangentS, tangentT, normal;
};

/// What one ring of points around a place says of it.
struct RingFit {
    QuadricCoefficients twoTerms; // A and B by least squares, C = 0; 0 where the ring doesn't determine them
    QuadricCoefficients threeTerms; // A, B and C; as twoTerms where the ring doesn't determine all three
    /// Of twoTerms' normal matrix, scaled to a diagonal of ones: 1 at best, infinity where it is singular.
    double condition = kInfinity;
};

/// Section 3.1: least squares through the points around.
RingFit fitQuadric(const QuadricFrame& frame, std::span<const Vec3> ring);

/// From the derivatives of position and unit normal along s and t: the second fundamental form of the surface
/// pushed out by `offset` along its normals. Along the unit tangents of the one that wasn't, from which its
/// own differ wherever they aren't the principal directions. 0 at a center of curvature, and where a tangent
/// is 0.
QuadricCoefficients quadricOfDerivatives(const Vec3& positionS, const Vec3& positionT, const Vec3& normalS,
                                         const Vec3& normalT, double offset);

} // namespace plumbline
