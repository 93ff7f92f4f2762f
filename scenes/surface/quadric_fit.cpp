#include "scenes/surface/quadric_fit.h"

#include <array>
#include <cassert>

namespace plumbline {
namespace {

// A determinant below this fraction of its largest possible value counts as zero. (The absolute bound of
// 0.001 in the listing of Watt and Policarpo (2005), chapter 5, would reject every small mesh: a ring of
// radius 0.3 on a unit sphere has 3e-4.) Of a matrix with ones on its diagonal, whose eigenvalues add up to
// n, the smallest eigenvalue is then at least 5e-7 for two terms and, as the other two multiply to at most
// (3/2)^2, 4.4e-7 for three: the same bound serves both.
constexpr double kSingularFraction = 1e-6;
// Tangents are considered parallel if the squared sine of their angle is below this.
constexpr double kSmallestSineSquared = 1e-6;

/// The normal equations' sums over the ring: products of x^2, y^2 and x y with each other and with the
/// distance below the tangent plane.
struct Sums {
    std::array<std::array<double, 3>, 3> products{};
    std::array<double, 3> withFall{};
};

/// Coordinates along two unit tangents that need not be orthogonal, computed with the inverse Gram matrix
/// (Premecz, Iterative parallax mapping with slope information, section 1.1).
struct ObliqueAxes {
    ObliqueAxes(const Vec3& alongS, const Vec3& alongT)
        : s(glm::normalize(alongS)), t(glm::normalize(alongT)), cosine(glm::dot(s, t)) {}
    Vec3 s, t;
    double cosine;

    double sineSquared() const { return 1 - cosine * cosine; }
    bool areTwo() const { return sineSquared() >= kSmallestSineSquared; }
    Vec2 coordinates(const Vec3& offset) const {
        const double alongS = glm::dot(offset, s), alongT = glm::dot(offset, t);
        return Vec2(alongS - cosine * alongT, alongT - cosine * alongS) / sineSquared();
    }
};

Sums sumRing(const QuadricFrame& frame, std::span<const Vec3> ring) {
    Sums sums;
    const ObliqueAxes axes(frame.tangentS, frame.tangentT);
    if (!axes.areTwo()) return sums;
    for (const Vec3& neighbor : ring) {
        const Vec3 offset = neighbor - frame.origin;
        const Vec2 p = axes.coordinates(offset);
        const std::array<double, 3> row{p.x * p.x, p.y * p.y, p.x * p.y};
        const double fall = -glm::dot(offset, frame.normal);
        for (size_t i = 0; i < 3; ++i) {
            for (size_t j = 0; j < 3; ++j)
                sums.products[i][j] += row[i] * row[j];
            sums.withFall[i] += row[i] * fall;
        }
    }
    return sums;
}

/// The normal equations with unknowns scaled so that the matrix has a unit diagonal.
struct ScaledSystem {
    std::array<double, 3> scale{}, right{}; // unknown = scaled unknown / scale
    double ab = 0, ac = 0, bc = 0;          // off-diagonal
};

ScaledSystem scaled(const Sums& sums) {
    ScaledSystem system;
    for (size_t i = 0; i < 3; ++i) {
        system.scale[i] = std::sqrt(sums.products[i][i]);
        system.right[i] = system.scale[i] > 0 ? sums.withFall[i] / system.scale[i] : 0;
    }
    const auto correlation = [&](size_t i, size_t j) {
        const double scale = system.scale[i] * system.scale[j];
        return scale > 0 ? sums.products[i][j] / scale : 0;
    };
    system.ab = correlation(0, 1);
    system.ac = correlation(0, 2);
    system.bc = correlation(1, 2);
    return system;
}

/// The second fundamental form along the unit tangents of the given surface, without an offset.
QuadricCoefficients alongOwnTangents(const Vec3& positionS, const Vec3& positionT, const Vec3& normalS,
                                     const Vec3& normalT) {
    const double s = glm::length(positionS), t = glm::length(positionT);
    if (!(s > 0 && t > 0)) return {};
    // The distance below the tangent plane is minus half the second fundamental form, whose entries are
    // -positionS . normalS and so on.
    return {0.5 * glm::dot(positionS, normalS) / (s * s), 0.5 * glm::dot(positionT, normalT) / (t * t),
            0.5 * (glm::dot(positionS, normalT) + glm::dot(positionT, normalS)) / (s * t)};
}

} // namespace

RingFit fitQuadric(const QuadricFrame& frame, std::span<const Vec3> ring) {
    assert(glm::length(frame.tangentS) > 0 && glm::length(frame.tangentT) > 0);
    RingFit fit;
    const auto [scale, right, ab, ac, bc] = scaled(sumRing(frame, ring));
    const double determinant2 = 1 - ab * ab;
    if (!(scale[0] > 0 && scale[1] > 0 && determinant2 > kSingularFraction)) return fit;
    fit.condition = (1 + std::abs(ab)) / (1 - std::abs(ab));
    fit.twoTerms.a = (right[0] - ab * right[1]) / (determinant2 * scale[0]);
    fit.twoTerms.b = (right[1] - ab * right[0]) / (determinant2 * scale[1]);

    fit.threeTerms = fit.twoTerms;
    const double determinant3 = determinant2 - ac * ac - bc * bc + 2 * ab * ac * bc;
    // The sum of (x y)^2 equals that of x^2 y^2. If all ring points lie on the axes, ab is 0 and the column
    // of x y consists of rounding errors.
    if (!(ab > kSingularFraction && determinant3 > kSingularFraction)) return fit;
    // The adjugate of the symmetric matrix.
    const double a = (1 - bc * bc) * right[0] + (ac * bc - ab) * right[1] + (ab * bc - ac) * right[2];
    const double b = (ac * bc - ab) * right[0] + (1 - ac * ac) * right[1] + (ab * ac - bc) * right[2];
    const double c = (ab * bc - ac) * right[0] + (ab * ac - bc) * right[1] + determinant2 * right[2];
    fit.threeTerms = {a / (determinant3 * scale[0]), b / (determinant3 * scale[1]),
                      c / (determinant3 * scale[2])};
    return fit;
}

QuadricCoefficients quadricOfDerivatives(const Vec3& positionS, const Vec3& positionT, const Vec3& normalS,
                                         const Vec3& normalT, double offset) {
    if (offset == 0) return alongOwnTangents(positionS, positionT, normalS, normalT);
    if (!(glm::length(positionS) > 0 && glm::length(positionT) > 0)) return {};
    const Vec3 pushedS = positionS + offset * normalS, pushedT = positionT + offset * normalT;
    const ObliqueAxes axes(positionS, positionT), pushed(pushedS, pushedT);
    if (!pushed.areTwo()) return {};
    const auto [a, b, c] = alongOwnTangents(pushedS, pushedT, normalS, normalT);
    const Vec2 s = pushed.coordinates(axes.s), t = pushed.coordinates(axes.t);
    return {a * s.x * s.x + c * s.x * s.y + b * s.y * s.y, a * t.x * t.x + c * t.x * t.y + b * t.y * t.y,
            2 * a * s.x * t.x + c * (s.x * t.y + s.y * t.x) + 2 * b * s.y * t.y};
}

} // namespace plumbline
