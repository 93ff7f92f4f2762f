// Exact Euclidean distance transform: the distance from any pixel of an image to the nearest one of a set.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace plumbline {

/// x right, y down; centers have integer coordinates.
struct Pixel {
    int x = 0, y = 0;
};

/// Columns [x0, x1) of rows [y0, y1); empty until something is included.
struct PixelBox {
    int x0 = std::numeric_limits<int>::max(), y0 = x0, x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    void include(const Pixel& pixel);
    void include(std::span<const Pixel> pixels);
};

/// Exact distances to a set of pixels within a box, axis by axis (Felzenszwalb and Huttenlocher 2012,
/// "Distance transforms of sampled functions", Theory of Computing 8): first along columns, then for each row
/// the lower envelope of the parabolas (x - column)^2 + (distance in that column)^2.
class DistanceTransform {
  public:
    static constexpr int64_t kFar = std::numeric_limits<int64_t>::max();

    /// `set`: inside `box`. Distances above `reach` pixels may be returned as kFar, which is faster.
    DistanceTransform(std::span<const Pixel> set, const PixelBox& box,
                      int reach = std::numeric_limits<int>::max());

    /// Squared distance, in pixels squared, of every pixel of `from` to the nearest of the set, in the order
    /// of `from`; kFar where there is none. `from`: inside the box; fast if sorted by rows, left to right.
    std::vector<int64_t> squaredDistancesOf(std::span<const Pixel> from);

  private:
    static constexpr int kNone = std::numeric_limits<int>::max(); // no pixel of the set in this column

    /// (x - column)^2 + height, the lowest parabola from its `begin` to that of the next one.
    struct Parabola {
        int column;
        int64_t height;
        double begin;
    };

    int* row(int y);
    void spread(const int* from, int* to) const;
    void buildEnvelope(const int* inColumn);

    PixelBox box_;
    int reach_;
    std::vector<int> inColumn_; // per pixel of the box: distance to the nearest set pixel above or below
    std::vector<Parabola> envelope_;
};

} // namespace plumbline
