#include "reference/tessellate/tessellate.h"

#include "reference/tessellate/shared_vertices.h"
#include "reference/tessellate/tile.h"
#include "scenes/surface/displaced_surface.h"
#include "scenes/surface/weld.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <memory>

namespace plumbline {

namespace {

/// Tolerance, in map widths and relative to st, within which the st of two faces count as equal.
constexpr double kSameSt = 1e-6;

class Tessellator {
  public:
    Tessellator(const BaseSurface& surface, const Relief* relief, const Rates& rates, bool attributes)
        : surface_(surface), relief_(relief), attributes_(attributes),
          shared_(surface, relief, rates, attributes) {
        mesh_.lattices = patchLattices(surface, rates);
    }

    MicroMesh build() {
        listTiles();
        allocate();
        tbb::parallel_for(size_t(0), places_.size(), [&](size_t i) { fill(places_[i]); });
        return std::move(mesh_);
    }

  private:
    struct TilePlace {
        int patch, blockColumn, blockRow, blocks; // adjacent grids
        size_t firstVertex, firstGrid;
    };

    void listTiles() {
        for (int patch = 0; patch < countOf(mesh_.lattices); ++patch) {
            const PatchLattice& lattice = item(mesh_.lattices, patch);
            for (int row = 0; row < blocksAlong(lattice.rows); ++row)
                for (int column = 0; column < blocksInRow(lattice, row); column += kTileGrids)
                    addTile(lattice, patch, column, row,
                            std::min(kTileGrids, blocksInRow(lattice, row) - column));
        }
    }

    void addTile(const PatchLattice& lattice, int patch, int blockColumn, int blockRow, int blocks) {
        places_.push_back({patch, blockColumn, blockRow, blocks, vertexCount_, gridCount_});
        for (int block = blockColumn; block < blockColumn + blocks; ++block)
            vertexCount_ +=
                areaOf(blockCells(lattice.columns, block) + 1, blockCells(lattice.rows, blockRow) + 1);
        gridCount_ += lengthOf(blocks);
    }

    void allocate() {
        // Embree reads 16 bytes at the last 12-byte vertex.
        mesh_.positionsWorld.reserve(vertexCount_ + 1);
        mesh_.positionsWorld.resize(vertexCount_);
        mesh_.grids.resize(gridCount_);
        if (!attributes_) return;
        mesh_.normalsWorld.resize(vertexCount_);
        mesh_.st.resize(vertexCount_);
    }

    struct Worker {
        std::unique_ptr<BaseSurface::Evaluator> evaluator;
        Tile tile{};
        std::vector<MicroVertex> vertices; // as tile.vertices
    };

    void fill(const TilePlace& place) {
        Worker& worker = workers_.local();
        if (!worker.evaluator) worker.evaluator = std::make_unique<BaseSurface::Evaluator>(surface_);
        const PatchLattice& lattice = item(mesh_.lattices, place.patch);
        Tile& tile = worker.tile;
        tile.patch = place.patch;
        tile.column0 = place.blockColumn * kGridCells;
        tile.row0 = place.blockRow * kGridCells;
        tile.columns = std::min(place.blocks * kGridCells, lattice.columns - tile.column0);
        tile.rows = blockCells(lattice.rows, place.blockRow);
        worker.evaluator->setPatch(place.patch);
        sampleTile(tile, lattice, relief_, *worker.evaluator);
        makeVertices(worker, lattice);
        emit(place, worker, lattice);
    }

    /// Creates the tile's vertices, using the shared ones on the patch's sides.
    void makeVertices(Worker& worker, const PatchLattice& lattice) {
        Tile& tile = worker.tile;
        worker.vertices.resize(tile.vertices.size());
        for (int row = 0; row <= tile.rows; ++row)
            for (int column = 0; column <= tile.columns; ++column) {
                const size_t index = tile.index(column, row);
                const Vec2i place = latticePlace(lattice, tile.column0 + column, tile.row0 + row);
                MicroVertex& vertex = worker.vertices[index];
                if (const MicroVertex* shared = sharedAt(tile.patch, lattice, place)) {
                    vertex = *shared;
                    if (attributes_) separateAttributes(vertex, *worker.evaluator, lattice, place);
                    tile.tears[index] = glm::length(Vec3(vertex.position) - tile.vertices[index].displaced());
                } else {
                    vertex.position = Vec3f(tile.vertices[index].displaced());
                    if (attributes_) addAttributes(vertex, *worker.evaluator, lattice, place);
                }
            }
    }

    /// A shared vertex has the first face's normal and st. At a texture seam, replaces them with this
    /// patch's; at a crease, the normal.
    void separateAttributes(MicroVertex& vertex, const BaseSurface::Evaluator& evaluator,
                            const PatchLattice& lattice, const Vec2i& place) const {
        const Vec2 uv = uvOf(lattice, place);
        const BasePoint base = evaluator.point(uv.x, uv.y);
        const Vec2 st = textureCoordinates(base, relief_), gap = glm::abs(st - Vec2(vertex.st));
        // Faces with equal uvs at an edge interpolate them to within rounding.
        const bool seam = std::max(gap.x, gap.y) > kSameSt * (1 + glm::length(st));
        if (seam || glm::length(base.normal - Vec3(vertex.baseNormal)) > kTornFraction)
            addAttributes(vertex, evaluator, lattice, place);
    }

    void addAttributes(MicroVertex& vertex, const BaseSurface::Evaluator& evaluator,
                       const PatchLattice& lattice, const Vec2i& place) const {
        const Vec2 uv = uvOf(lattice, place);
        const DisplacedSample sample = displace(evaluator.sample(uv.x, uv.y), relief_);
        vertex.normal = Vec3f(sample.normal);
        vertex.st = Vec2f(sample.st);
    }

    /// The shared vertex at a position in steps; null inside the patch.
    const MicroVertex* sharedAt(int patch, const PatchLattice& lattice, const Vec2i& place) const {
        const auto segment = [&](int side, int step, int cells) {
            return step / (cells / item(lattice.sides, side));
        };
        if (place.y == 0) return &shared_.at(patch, 0, segment(0, place.x, lattice.columns));
        if (place.x == 0) {
            const int side = lattice.triangular ? 2 : 3;
            return &shared_.at(patch, side, segment(side, place.y, lattice.rows));
        }
        if (lattice.triangular) {
            if (place.x + place.y < lattice.columns) return nullptr;
            return &shared_.at(patch, 1, segment(1, place.y, lattice.rows));
        }
        if (place.x == lattice.columns) return &shared_.at(patch, 1, segment(1, place.y, lattice.rows));
        if (place.y == lattice.rows) return &shared_.at(patch, 2, segment(2, place.x, lattice.columns));
        return nullptr;
    }

    /// Divides the tile into grids.
    void emit(const TilePlace& place, const Worker& worker, const PatchLattice& lattice) {
        const Tile& tile = worker.tile;
        size_t vertex = place.firstVertex;
        for (int block = 0; block < place.blocks; ++block) {
            const int column0 = block * kGridCells,
                      cells = blockCells(lattice.columns, place.blockColumn + block);
            MicroGrid& grid = mesh_.grids[place.firstGrid + lengthOf(block)];
            grid.firstVertex = static_cast<uint32_t>(vertex);
            grid.patch = static_cast<uint32_t>(place.patch);
            grid.columns = static_cast<uint16_t>(cells + 1);
            grid.rows = static_cast<uint16_t>(tile.rows + 1);
            grid.column0 = static_cast<uint16_t>(tile.column0 + column0);
            grid.row0 = static_cast<uint16_t>(tile.row0);
            const TileError error =
                tileError(tile, lattice, relief_, *worker.evaluator, column0, 0, cells, tile.rows, true);
            grid.errorWorld = static_cast<float>(error.world);
            grid.torn = error.torn;
            for (int row = 0; row <= tile.rows; ++row)
                for (int column = column0; column <= column0 + cells; ++column)
                    store(vertex++, worker.vertices[tile.index(column, row)]);
        }
    }

    void store(size_t index, const MicroVertex& vertex) {
        mesh_.positionsWorld[index] = vertex.position;
        if (!attributes_) return;
        mesh_.normalsWorld[index] = vertex.normal;
        mesh_.st[index] = vertex.st;
    }

    const BaseSurface& surface_;
    const Relief* relief_;
    bool attributes_;
    SharedVertices shared_;
    tbb::enumerable_thread_specific<Worker> workers_;
    std::vector<TilePlace> places_;
    size_t vertexCount_ = 0, gridCount_ = 0;
    MicroMesh mesh_;
};

} // namespace

MicroMesh tessellate(const BaseSurface& surface, const Relief* relief, const Rates& rates, bool attributes) {
    return Tessellator(surface, relief, rates, attributes).build();
}

} // namespace plumbline
