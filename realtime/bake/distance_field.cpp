// Bakes a distance field of the relief on a voxel grid, for sphere tracing.
//
// Voxel (i, j, k) is the box [i, i+1]/W x [j, j+1]/H of st around the center of texel (i, j), and
// [k, k+1]/slices of relief depth. It is solid if any point of it lies on or below the bilinear relief.
// Space: a map width has the length sx/sz, a map height sy/sz, and the relief depth 1; so all distances are
// in units of the relief's depth.
//
// Channel 0 is the minimum distance between any point of this voxel and any point of a solid one: with voxel
// sides h and index differences k along each axis, sqrt(sum (h max(|k| - 1, 0))^2). Every point of the
// surface lies in a solid voxel, so this is a lower bound of the distance to the surface for all points of
// the voxel, and a technique can use the nearest voxel's value without a correction. A ray outside the grid
// uses the nearest voxel, and the bound still holds:
//   above the top (d < 0)      everything solid has d >= 0, so the distance isn't smaller than from the
//                              projection to the top
//   beside a clamped border    the relief continues the border's texels, and the border's voxel is solid
//                              wherever a voxel beyond it is (its footprint contains that profile) and is
//                              nearer to every voxel of the map
//   below the last slice       solid, like the last slice: the distance is 0
//
// Channel 1 is the published field, the distance between voxel centers. It is 0 in solid voxels, which for
// this channel are those whose center is on or below the texel's depth. Everything below the last slice is
// solid, so that a floor at depth 1 is found. It is no bound: the surface may be nearer by half a voxel's
// diagonal at either end, and anywhere between two texels.
//
// Both are exact and computed axis by axis (Felzenszwalb, Huttenlocher, Distance transforms of sampled
// functions, 2012): the nearest solid voxel of a column is known, then squared distances are minimized along
// s and along t. A sum is always (depth + s) + t. Rounding is monotonic, so the minimum over s may be taken
// before t is added, and the result is bit-identical to the minimum over all solid voxels, for any division
// of the work.
#include "realtime/bake/bake_kinds.h"
#include "realtime/bake/scale_ratios.h"
#include "scenes/core/free_memory.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {
namespace {

constexpr size_t kChannels = 2;
constexpr int kLanes = 32; // adjacent columns processed together, for vectorization

/// Squared distances between voxels 0, 1, 2 … apart on one axis.
std::vector<double> squaredGaps(int count, double side, int touching) {
    std::vector<double> squares(static_cast<size_t>(count));
    for (int steps = 0; steps < count; ++steps) {
        const double gap = side * std::max(steps - touching, 0);
        squares[static_cast<size_t>(steps)] = gap * gap;
    }
    return squares;
}

/// Minimum depth of the bilinear relief over the box around texel (i, j). It is at a corner of one of the
/// box's four pieces, each a quarter of a patch.
double minDepthAround(const HeightMap& map, int i, int j) {
    const auto depth = [&](int column, int row) { return static_cast<double>(map.texel(column, row)); };
    double least = depth(i, j);
    for (const int across : {-1, 1}) {
        least = std::min(
            {least, (depth(i, j) + depth(i + across, j)) / 2, (depth(i, j) + depth(i, j + across)) / 2});
        for (const int up : {-1, 1})
            least = std::min(
                least,
                (depth(i, j) + depth(i + across, j) + depth(i, j + up) + depth(i + across, j + up)) / 4);
    }
    return least;
}

/// The differences between the two channels.
struct Measure {
    size_t channel;
    int touching;                                                      // voxels this close have distance 0
    int (*firstSolid)(const HeightMap& map, int i, int j, int slices); // slice; all below are solid
    float (*toFloat)(double distance);
};

int firstSolidBox(const HeightMap& map, int i, int j, int slices) {
    return std::max(0, static_cast<int>(std::ceil(minDepthAround(map, i, j) * slices)) - 1);
}

int firstSolidCenter(const HeightMap& map, int i, int j, int slices) {
    return static_cast<int>(std::ceil(std::max(0.0, static_cast<double>(map.texel(i, j)) * slices - 0.5)));
}

/// Rounds down to float, so that a lower bound stays one.
float roundedDown(double distance) {
    const auto nearest = static_cast<float>(distance);
    return nearest > distance ? std::nextafter(nearest, 0.0f) : nearest;
}

constexpr std::array<Measure, kChannels> kMeasures{
    {{0, 1, firstSolidBox, roundedDown},
     {1, 0, firstSolidCenter, [](double distance) { return static_cast<float>(distance); }}}};

/// One axis of the grid.
struct Axis {
    int size;
    Wrap wrap;
    /// How far a search can go before it wraps around or reaches the last voxel.
    int reach() const { return wrap == Wrap::Repeat ? size / 2 : size - 1; }
    /// Beyond a clamped border, the border's voxel is used again; it is farther away than the voxel itself,
    /// so it has no effect.
    int index(int i) const { return wrap == Wrap::Repeat ? (i + size) % size : std::clamp(i, 0, size - 1); }
};

/// best[x] = min(best[x], the values at `steps` on both sides + gap), while a gap can still improve the
/// largest of them. `at(steps)`: the first of `lanes` values there. `least`: a lower bound of all values.
template <class At>
void searchOutward(double* best, int lanes, int reach, const std::vector<double>& gaps, double least,
                   const At& at) {
    for (int steps = 1; steps <= reach; ++steps) {
        const double gap = gaps[static_cast<size_t>(steps)];
        if (least + gap >= *std::max_element(best, best + lanes)) return;
        const double *before = at(-steps), *after = at(steps);
        for (int x = 0; x < lanes; ++x) {
            const double nearer = before[x] < after[x] ? before[x] : after[x];
            const double candidate = nearer + gap;
            best[x] = candidate < best[x] ? candidate : best[x];
        }
    }
}

class DistanceField {
  public:
    DistanceField(const HeightMap& map, const ScaleRatios& ratios, int slices, const Measure& measure)
        : s_{map.width(), map.wrapS()}, t_{map.height(), map.wrapT()}, measure_(measure),
          gapsS_(squaredGaps(s_.size, 1 / (s_.size * ratios.perWidth), measure.touching)),
          gapsT_(squaredGaps(t_.size, 1 / (t_.size * ratios.perHeight), measure.touching)),
          gapsDepth_(squaredGaps(slices + 1, 1.0 / slices, measure.touching)), firstSolid_(area()),
          rows_(area()) {
        tbb::parallel_for(tbb::blocked_range<int>(0, t_.size), [&](const auto& rows) {
            for (int j = rows.begin(); j < rows.end(); ++j)
                for (int i = 0; i < s_.size; ++i)
                    firstSolid_[at(i, j)] = measure.firstSolid(map, i, j, slices);
        });
    }

    /// Writes one channel of slice k.
    void writeSlice(int k, float* values) {
        tbb::parallel_for(tbb::blocked_range<int>(0, t_.size), [&](const auto& rows) {
            for (int j = rows.begin(); j < rows.end(); ++j)
                minimizeRow(j, k);
        });
        const int blocks = (s_.size + kLanes - 1) / kLanes;
        tbb::parallel_for(tbb::blocked_range<int>(0, blocks), [&](const auto& range) {
            for (int block = range.begin(); block < range.end(); ++block)
                minimizeColumns(block * kLanes, values);
        });
    }

  private:
    size_t area() const { return static_cast<size_t>(s_.size) * static_cast<size_t>(t_.size); }
    size_t at(int i, int j) const {
        return static_cast<size_t>(j) * static_cast<size_t>(s_.size) + static_cast<size_t>(i);
    }

    /// Fills a row of rows_: squared distances along depth and s.
    void minimizeRow(int j, int k) {
        const int reach = s_.reach();
        std::vector<double> column(static_cast<size_t>(s_.size + 2 * reach)); // extended beyond both ends
        double* const inside = column.data() + reach;
        for (int i = -reach; i < s_.size + reach; ++i)
            inside[i] = gapsDepth_[static_cast<size_t>(std::max(0, firstSolid_[at(s_.index(i), j)] - k))];
        const double least = *std::min_element(inside, inside + s_.size);
        double* const best = &rows_[at(0, j)];
        std::copy(inside, inside + s_.size, best);
        for (int i = 0; i < s_.size; i += kLanes)
            searchOutward(best + i, std::min(kLanes, s_.size - i), reach, gapsS_, least,
                          [&](int steps) { return inside + i + steps; });
    }

    /// Columns i to i + kLanes: minimizes along t and writes the square roots.
    void minimizeColumns(int i, float* values) const {
        const int lanes = std::min(kLanes, s_.size - i);
        double least = rows_[at(i, 0)];
        for (int j = 0; j < t_.size; ++j)
            least = std::min(least, *std::min_element(&rows_[at(i, j)], &rows_[at(i, j)] + lanes));
        std::array<double, kLanes> best{};
        for (int j = 0; j < t_.size; ++j) {
            std::copy_n(&rows_[at(i, j)], lanes, best.data());
            searchOutward(best.data(), lanes, t_.reach(), gapsT_, least,
                          [&](int steps) { return &rows_[at(i, t_.index(j + steps))]; });
            for (int x = 0; x < lanes; ++x)
                values[at(i + x, j) * kChannels + measure_.channel] =
                    measure_.toFloat(std::sqrt(best[static_cast<size_t>(x)]));
        }
    }

    Axis s_, t_;
    Measure measure_;
    std::vector<double> gapsS_, gapsT_, gapsDepth_; // squared, indexed by the distance in voxels
    std::vector<int> firstSolid_;                   // width x height
    std::vector<double> rows_;                      // width x height, of the current slice
};

} // namespace

BakedMap bakeDistanceField(const HeightMap& map, const BakeRequest& request) {
    const ScaleRatios ratios = scaleRatios(request.scale);
    const double texels = static_cast<double>(map.width()) * map.height();
    requireMemory(fmt::format("a distance field of {}, {} slices", map.name(), request.slices),
                  texels *
                      (double(kChannels * sizeof(float)) * request.slices + sizeof(double) + sizeof(int)));
    BakedMap baked;
    baked.slices = request.slices;
    baked.channels = kChannels;
    const size_t sliceValues = static_cast<size_t>(texels) * kChannels;
    baked.levels.push_back(
        {map.width(), map.height(), std::vector<float>(sliceValues * static_cast<size_t>(request.slices))});
    for (const Measure& measure : kMeasures) {
        DistanceField field(map, ratios, request.slices, measure);
        for (int k = 0; k < request.slices; ++k)
            field.writeSlice(k, &baked.levels[0].values[sliceValues * static_cast<size_t>(k)]);
    }
    return baked;
}

} // namespace plumbline
