// Linear interpolation of a corner attribute (position, normal, uv) over a patch of BaseSurface.
#pragma once

namespace plumbline {

/// Bilinear over the unit square, or barycentric over u, v >= 0, u + v <= 1 (then d is unused).
template <typename T>
struct LinearPatch {
    T a{}, b{}, c{}, d{}; // at (0,0), (1,0), (0,1), (1,1)
    bool triangular = false;

    T at(double u, double v) const {
        if (triangular) return a * (1 - u - v) + b * u + c * v;
        return (a * (1 - u) + b * u) * (1 - v) + (c * (1 - u) + d * u) * v;
    }
    T byU(double v) const { return triangular ? b - a : (b - a) * (1 - v) + (d - c) * v; }
    T byV(double u) const { return triangular ? c - a : (c - a) * (1 - u) + (d - b) * u; }
};

/// `value(k)`: the attribute at corner k of the face. `subFaceCorner` < 0: the face is a single patch (a
/// quad, or a triangle if `triangular`); otherwise the sub-face at that corner of a face of any size.
template <typename T, typename Value>
LinearPatch<T> makeLinearPatch(int faceSize, int subFaceCorner, bool triangular, Value value) {
    if (triangular) return {value(0), value(1), value(2), T{}, true};
    if (subFaceCorner < 0) return {value(0), value(1), value(3), value(2), false};
    const int k = subFaceCorner;
    T center{};
    for (int i = 0; i < faceSize; ++i)
        center += value(i);
    center /= faceSize;
    return {value(k), 0.5 * (value(k) + value((k + 1) % faceSize)),
            0.5 * (value(k) + value((k + faceSize - 1) % faceSize)), center, false};
}

} // namespace plumbline
