// The quadric z = -(A x^2 + C x y + B y^2) that approximates a surface at a point, for relief on curved bases
// (Oliveira, Policarpo, UFRGS RP-351 (2005), section 3).
//
// x and y are in world units along the unit tangents of s and t, which need not be orthogonal; z is along the
// outward unit normal. A > 0 where the surface is convex along s: this is the sign required by their Eqs 6
// and 7, not that of their fit in section 3.1. Coefficients are in world units^-1. The cross term C is an
// addition of this project.
#pragma once

#include "scenes/core/math.h"

#include <span>

namespace plumbline {

struct QuadricCoefficients {
    double a = 0, b = 0, c = 0;
};

/// The frame in which a quadric is fitted. `tangentS` and `tangentT` may have any nonzero length; `normal` is
/// unit.
struct QuadricFrame {
    Vec3 origin, tangentS, tangentT, normal;
};

/// Quadrics fitted to one ring of points.
struct RingFit {
    QuadricCoefficients twoTerms; // A and B by least squares, C = 0; all 0 if the ring doesn't determine them
    QuadricCoefficients threeTerms; // A, B and C; equals twoTerms if the ring doesn't determine all three
    /// Condition number of twoTerms' normal matrix, scaled to a unit diagonal: 1 at best, infinite if it is
    /// singular.
    double condition = kInfinity;
};

/// Least-squares fit to the ring (section 3.1).
RingFit fitQuadric(const QuadricFrame& frame, std::span<const Vec3> ring);

/// Computes the quadric from the derivatives of position and unit normal along s and t, as the second
/// fundamental form of the surface offset by `offset` along its normals. It is expressed along the unit
/// tangents of the original surface, which differ from those of the offset surface unless they are the
/// principal directions. 0 at a center of curvature and where a tangent is 0.
QuadricCoefficients quadricOfDerivatives(const Vec3& positionS, const Vec3& positionT, const Vec3& normalS,
                                         const Vec3& normalT, double offset);

} // namespace plumbline
