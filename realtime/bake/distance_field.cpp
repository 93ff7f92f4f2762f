// Distances to the relief on a grid of boxes, for sphere tracing.
//
// Voxel (i, j, k) is the box [i, i+1]/W x [j, j+1]/H of st around the center of texel (i, j), and [k,
// k+1]/slices of relief depth. It is solid if any point of it lies on or below the bilinear relief. Space:
// one map width is sx/sz long, one map height sy/sz, the relief depth 1; all distances are in this unit, the
// relief's depth.
//
// Channel 0, the least distance between any point of this voxel and any point of a solid one: with sides h
// and k voxels between two on each axis, sqrt(sum (h max(|k| - 1, 0))^2). Every point of the surface lies in
// a solid voxel, so no point of this voxel is nearer to the surface than that: a technique looks up the
// nearest voxel and subtracts nothing. Where a ray is outside the grid it takes the nearest voxel, and the
// distance still holds:
//   above the top (d < 0)      everything solid has d >= 0, so the point is no nearer to it than its place on
//   the top is beside a clamped border    the relief goes on as the border's texels, and the border's voxel
//   is solid wherever a voxel
//                              beyond it is (its footprint holds that profile), in reach of every voxel on
//                              the map
//   below the last slice       solid, as the last slice is: the distance is 0
//
// Channel 1, the field of the documents: from center to center, 0 in solid voxels, which here are those whose
// center is on or below the texel's depth. What is below the last slice counts as solid, so that a floor of
// depth 1 is a floor. It is no bound: the surface may be nearer by half a voxel's diagonal at either end, and
// anywhere between two texels.
//
// Both are exact, axis by axis (Felzenszwalb, Huttenlocher, Distance transforms of sampled functions, 2012):
// in a column the nearest solid voxel is known, then squares are minimized along s and along t. A sum is
// always (depth + s) + t; rounding is monotonic, so the minimum over s may be taken before t is added, and
// the result has the bits of the minimum over all solid voxels, however the work is cut.
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
constexpr int kLanes =
    32; // neighbors in a row that are worked on together; a vector register holds some of them

/// Squares of the distances between voxels 0, 1, 2 … apart on one axis.
std::vector<double> squaredGaps(int count, double side, int touching) {
    std::vector<double> squares(static_cast<size_t>(count));
    for (int steps = 0; steps < count; ++steps) {
        const double gap = side * std::max(steps - touching, 0);
        squares[static_cast<size_t>(steps)] = gap * gap;
    }
    return squares;
}

/// Least depth of the bilinear relief over the box around texel (i, j): at a corner of one of its four
/// pieces, each a quarter of a patch.
double leastDepthAround(const HeightMap& map, int i, int j) {
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

/// What tells the two channels apart.
struct Measure {
    size_t channel;
    int touching;                                                      // voxels that close are at distance 0
    int (*firstSolid)(const HeightMap& map, int i, int j, int slices); // slice; all below it are solid
    float (*toFloat)(double distance);
};

int firstSolidBox(const HeightMap& map, int i, int j, int slices) {
    return std::max(0, static_cast<int>(std::ceil(leastDepthAround(map, i, j) * slices)) - 1);
}

int firstSolidCenter(const HeightMap& map, int i, int j, int slices) {
    return static_cast<int>(std::ceil(std::max(0.0, static_cast<double>(map.texel(i, j)) * slices - 0.5)));
}

/// The bound stays one when it becomes a float.
float roundedDown(double distance) {
    const auto nearest = static_cast<float>(distance);
    return nearest > distance ? std::nextafter(nearest, 0.0f) : nearest;
}

constexpr std::array<Measure, kChannels> kMeasures{
    {{0, 1, firstSolidBox, roundedDown},
     {1, 0, firstSolidCenter, [](double distance) { return static_cast<float>(distance); }}}};

/// One axis of the grid: how far a search goes until it meets itself or the last voxel.
struct Axis {
    int size;
    Wrap wrap;
    int reach() const { return wrap == Wrap::Repeat ? size / 2 : size - 1; }
    /// Beyond a clamped border the border's voxel again: farther off than it is, so it changes nothing.
    int index(int i) const { return wrap == Wrap::Repeat ? (i + size) % size : std::clamp(i, 0, size - 1); }
};

/// best[x] = min(best[x], the values at `steps` on both sides + gap), while a gap can still win over the
/// worst of them. `at(steps)`: the first of `lanes` values there. `least`: no value is smaller.
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
        : s_{map.width(), map.wrapS()}, t_{map.height(), map.wrapT()}, slices_(slices), measure_(measure),
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

    /// rows_: squares along depth and s.
    void minimizeRow(int j, int k) {
        const int reach = s_.reach();
        std::vector<double> column(
            static_cast<size_t>(s_.size + 2 * reach)); // with what lies beyond the ends
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

    /// Columns i to i + kLanes: adds t and writes the roots.
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
    int slices_;
    Measure measure_;
    std::vector<double> gapsS_, gapsT_, gapsDepth_; // squares, by voxels apart
    std::vector<int> firstSolid_;                   // width x height
    std::vector<double> rows_;                      // width x height, of the slice in work
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
