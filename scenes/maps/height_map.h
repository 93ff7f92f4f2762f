// The relief depth d(s,t): the only C++ definition of displacement (the GLSL version is
// realtime/shaders/height_map.glsl; a test checks that the two agree).
//
// Conventions: d in [0,1], 0 = top of the relief layer, 1 = deepest. Row 0 is the bottom row (image rows are
// flipped on load). Texel (i,j) has its center at ((i+0.5)/width, (j+0.5)/height). Bilinear at the base
// level, exact: no mip level, no 8-bit filter weights.
#pragma once

#include "scenes/core/index.h"
#include "scenes/core/math.h"

#include <string>
#include <vector>

namespace plumbline {

enum class Wrap { Repeat, Clamp };

class HeightMap {
  public:
    /// `depths`: width x height values in [0,1], row 0 = bottom. Throws InputError naming `name` for a number
    /// of values other than width x height, or a value that is NaN or outside [0,1].
    HeightMap(std::string name, int width, int height, std::vector<float> depths, Wrap wrapS = Wrap::Repeat,
              Wrap wrapT = Wrap::Repeat);
    /// The same depth everywhere.
    static HeightMap constant(std::string name, float depth);

    const std::string& name() const { return name_; }
    int width() const { return width_; }
    int height() const { return height_; }
    Wrap wrapS() const { return wrapS_; }
    Wrap wrapT() const { return wrapT_; }
    const std::vector<float>& depths() const { return depths_; }
    /// Smallest and largest of the depths.
    float minDepth() const { return minDepth_; }
    float maxDepth() const { return maxDepth_; }
    /// Texel by index, wrapped.
    float texel(int i, int j) const;
    /// The bilinear patch between texels (i, j) and (i+1, j+1), wrapped: d_xy at x right, y up.
    struct Cell {
        double d00, d10, d01, d11;
    };
    Cell cell(int i, int j) const;

    /// Relief depth at texture coordinates st, which may be any real numbers. NaN if st is NaN, or infinite
    /// along an axis that repeats. Along an axis that clamps, an infinite coordinate gives the border texel.
    double depth(const Vec2& st) const;

    /// Depth and its gradient (d_s, d_t) per unit of s and t, from the bilinear patch that contains st. On
    /// the border between patches, the gradient is that of the patch to the right and above. NaN where
    /// depth() is NaN.
    struct Sample {
        double depth;
        Vec2 gradient;
    };
    Sample sample(const Vec2& st) const;

  private:
    const float* rowOf(int j) const { return depths_.data() + indexIn(width_, 0, j); }

    std::string name_;
    int width_, height_;
    std::vector<float> depths_;
    Wrap wrapS_, wrapT_;
    float minDepth_, maxDepth_;
};

} // namespace plumbline
