#include "scenes/mesh/shapes/teapot.h"

#include "scenes/mesh/shapes/limit_points.h"
#include "scenes/mesh/shapes/shape_parts.h"

#include <cmath>
#include <map>

namespace plumbline {

namespace {

/// A control point of a profile. The circle around the axis consists of four cubic arcs whose inner control
/// points are at distance `tangent` from their ends: 0.56 radius in the data (0.5523 would approximate a
/// circle best).
struct ProfilePoint {
    double radius, z;
    double tangent = 0.56 * radius;
};
/// From bottom to top, ending with the rim, which turns inwards and down.
constexpr ProfilePoint kBody[] = {{1.5, 0.15},       {1.5, 0.225},  {2, 0.45},  {2, 0.9},
                                  {2, 1.35},         {1.75, 1.875}, {1.5, 2.4}, {1.4375, 2.53125},
                                  {1.3375, 2.53125}, {1.4, 2.4}};
/// From its edge to the top of the knob, whose widest control ring is the only one with another tangent than
/// 0.56.
constexpr ProfilePoint kLid[] = {{1.3, 2.4}, {1.3, 2.55},       {0.4, 2.55}, {0.2, 2.7},
                                 {0, 2.85},  {0.8, 3.15, 0.45}, {0, 3.15}};
/// From the center outwards.
constexpr ProfilePoint kBottom[] = {{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}};

/// A control section of the handle or spout: x and z of its two points at y = 0, and its half width along y.
struct Section {
    double x0, z0, x1, z1, halfWidth;
};
/// From the upper end to the lower one; the point toward the body first.
constexpr Section kHandle[] = {{-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3},
                               {-2.7, 2.025, -3, 2.25, 0.3},   {-2.7, 1.8, -3, 1.8, 0.3},
                               {-2.7, 1.575, -3, 1.35, 0.3},   {-2.5, 1.125, -2.65, 0.9375, 0.3},
                               {-2, 0.9, -1.9, 0.6, 0.3}};
/// From the body to the mouth; the upper point first.
constexpr Section kSpout[] = {{1.7, 1.425, 1.7, 0.6, 0.66},       {2.6, 1.425, 3.1, 0.825, 0.66},
                              {2.3, 2.1, 2.4, 2.025, 0.25},       {2.7, 2.4, 3.3, 2.4, 0.25},
                              {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15},
                              {2.8, 2.4, 3.2, 2.4, 0.15}};

/// Control points of a closed cubic spline in Bezier form: every third one is on the curve.
using Ring = std::vector<Vec3>;
/// Rings along v; every third one is on the surface. Seen from outside, the direction of u is to the right of
/// v. uv runs from 0 to uvExtent, which is integer so that maps are continuous across seams. It is chosen so
/// that units of u and v have about the same length, which is also similar in all charts (1.6 to 3.1).
struct Chart {
    std::vector<Ring> rings;
    Vec2 uvExtent;
};

Ring turnedRing(const ProfilePoint& p) {
    Ring ring;
    Vec2 start(p.radius, 0), inner(p.radius, p.tangent), nextInner(p.tangent, p.radius);
    for (int quarter = 0; quarter < 4; ++quarter)
        for (Vec2* point : {&start, &inner, &nextInner}) {
            ring.push_back(Vec3(*point, p.z));
            *point = Vec2(-point->y, point->x);
        }
    return ring;
}

Ring mirroredRing(const Section& s) {
    const Vec3 side(0, s.halfWidth, 0), first(s.x0, 0, s.z0), second(s.x1, 0, s.z1);
    return {first, first - side, second - side, second, second + side, first + side};
}

template <size_t count, typename Row>
Chart makeChart(const Row (&rows)[count], Ring (*ringOf)(const Row&), const Vec2& uvExtent) {
    Chart chart{{}, uvExtent};
    for (const Row& row : rows)
        chart.rings.push_back(ringOf(row));
    return chart;
}

/// Groups of charts whose coincident vertices are merged.
std::vector<std::vector<Chart>> teapotParts() {
    return {{makeChart(kBody, turnedRing, {4, 1}), makeChart(kBottom, turnedRing, {4, 1})},
            {makeChart(kLid, turnedRing, {2, 1})},
            {makeChart(kHandle, mirroredRing, {1, 2})},
            {makeChart(kSpout, mirroredRing, {1, 1})}};
}

std::array<double, 4> bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// Lattice of `segments` quads a side of each patch, evaluated from a chart.
struct ChartLattice {
    int columns, rows;        // quads; closed along the columns
    std::vector<Vec3> points; // columns x (rows + 1)
    Vec2 uvExtent;
    std::vector<double> v; // of each row, by arc length, from 0 to uvExtent.y
    const Vec3& at(int i, int j) const { return points[indexIn(columns, i % columns, j)]; }
};

Vec3 evaluateChart(const Chart& chart, int segments, int i, int j) {
    const int lastPatch = countOf(chart.rings) / 3 - 1;
    const int patchV = std::min(j / segments, lastPatch), patchU = i / segments;
    const auto weightU = bernstein(double(i - patchU * segments) / segments);
    const auto weightV = bernstein(double(j - patchV * segments) / segments);
    Vec3 sum(0);
    for (int q = 0; q < 4; ++q) {
        const Ring& ring = item(chart.rings, 3 * patchV + q);
        for (int p = 0; p < 4; ++p)
            sum += item(weightV, q) * item(weightU, p) * item(ring, (3 * patchU + p) % countOf(ring));
    }
    return {sum.x, sum.z, -sum.y}; // z up to y up
}

ChartLattice makeChartLattice(const Chart& chart, int segments) {
    ChartLattice lattice;
    lattice.uvExtent = chart.uvExtent;
    lattice.columns = countOf(chart.rings[0]) / 3 * segments;
    lattice.rows = countOf(chart.rings) / 3 * segments;
    for (int j = 0; j <= lattice.rows; ++j)
        for (int i = 0; i < lattice.columns; ++i)
            lattice.points.push_back(evaluateChart(chart, segments, i, j));
    lattice.v = {0};
    for (int j = 0; j < lattice.rows; ++j) {
        double length = 0; // summed over the columns
        for (int i = 0; i < lattice.columns; ++i)
            length += glm::length(lattice.at(i, j + 1) - lattice.at(i, j));
        lattice.v.push_back(lattice.v.back() + length);
    }
    const double length = lattice.v.back();
    for (double& v : lattice.v)
        v *= lattice.uvExtent.y / length;
    lattice.v.back() = lattice.uvExtent.y;
    return lattice;
}

/// Merges coincident vertices, where body and bottom meet and where a ring degenerates to a pole. Each part
/// has its own joiner, because the handle's lower end touches the body in one control point, (-2, 0, 0.9),
/// and must not be merged with it.
class VertexJoiner {
  public:
    explicit VertexJoiner(ControlMesh& mesh) : mesh_(mesh) {}
    int vertexAt(const Vec3& point) {
        // Coincident vertices are computed from the same control points in different orders and agree to
        // about 1e-15. The grid is a million times finer than the finest lattice.
        constexpr double kCell = 1e-9;
        const auto cell = [](double x) { return std::llround(x / kCell); };
        const auto [entry, isNew] =
            vertexAt_.try_emplace({cell(point.x), cell(point.y), cell(point.z)}, countOf(mesh_.points));
        if (isNew) mesh_.points.push_back(point);
        return entry->second;
    }

  private:
    ControlMesh& mesh_;
    std::map<std::array<long long, 3>, int> vertexAt_;
};

void appendFace(ControlMesh& mesh, std::initializer_list<std::pair<int, Vec2>> corners) {
    mesh.faceSizes.push_back(countOf(corners));
    for (const auto& [vertex, uv] : corners) {
        mesh.faceVertices.push_back(vertex);
        mesh.faceUvs.push_back(countOf(mesh.uvs));
        mesh.uvs.push_back(uv);
    }
}

void appendChart(ControlMesh& mesh, VertexJoiner& joiner, const ChartLattice& lattice) {
    for (int j = 0; j < lattice.rows; ++j)
        for (int i = 0; i < lattice.columns; ++i) {
            const auto corner = [&](int di, int dj) {
                const double u = lattice.uvExtent.x * (i + di) / lattice.columns;
                return std::pair(joiner.vertexAt(lattice.at(i + di, j + dj)),
                                 Vec2(u, item(lattice.v, j + dj)));
            };
            auto a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
            const double middle =
                lattice.uvExtent.x * (i + 0.5) / lattice.columns; // u of a pole, where every u meets
            if (a.first == b.first) {
                a.second.x = middle;
                appendFace(mesh, {a, c, d});
            } else if (c.first == d.first) {
                c.second.x = middle;
                appendFace(mesh, {a, b, c});
            } else {
                appendFace(mesh, {a, b, c, d});
            }
        }
}

} // namespace

std::vector<std::array<Vec3, 16>> teapotPatches() {
    std::vector<std::array<Vec3, 16>> patches;
    for (const std::vector<Chart>& part : teapotParts())
        for (const Chart& chart : part)
            for (size_t v = 0; v + 3 < chart.rings.size(); v += 3)
                for (size_t u = 0; u < chart.rings[0].size(); u += 3) {
                    std::array<Vec3, 16>& patch = patches.emplace_back();
                    for (size_t k = 0; k < 16; ++k)
                        patch[k] = chart.rings[v + k / 4][(u + k % 4) % chart.rings[0].size()];
                }
    return patches;
}

ControlMesh makeTeapot(int segments) {
    requireSegments("teapot", "segments", segments, 2, kMaxTeapotSegments);
    ControlMesh mesh;
    mesh.name = "teapot";
    for (const std::vector<Chart>& part : teapotParts()) {
        VertexJoiner joiner(mesh);
        for (const Chart& chart : part)
            appendChart(mesh, joiner, makeChartLattice(chart, segments));
    }
    interpolateLimit(mesh);
    return mesh;
}

} // namespace plumbline
