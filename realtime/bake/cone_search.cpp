#include "realtime/bake/cone_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline {
namespace {

// Relative tolerance for the rounding of products in comparisons.
constexpr double kSlack = 1e-12;

} // namespace

float keptSlopeSquared(double slopeSquared) {
    if (!(slopeSquared > 1)) return 1;
    return std::nextafter(static_cast<float>(slopeSquared), kInfinityF);
}

float coneRatio(float keptSlopeSquared) {
    if (!(keptSlopeSquared > 1)) return 1;
    const double ratio = 1 / std::sqrt(static_cast<double>(keptSlopeSquared)) * (1 - 1e-15);
    const auto rounded = static_cast<float>(ratio);
    return rounded > ratio ? std::nextafter(rounded, 0.0f) : rounded;
}

/// A block that may contain a steeper pair. Slopes are squared.
struct ConeSearch::Block {
    int level;
    Vec2i at, shift; // shift: offset of its repeated image, texels
    double bound;
};

struct ConeSearch::Query {
    Vec2i texel;
    int sector;
    double depth;
    double steepest = 1;         // squared
    double skipped = 1 - kSlack; // pairs up to this squared slope round to `steepest` or are below the cap
    Winner winner{};

    void take(double slopeSquared, const Vec2i& at) {
        steepest = slopeSquared;
        winner = at;
        const auto rounded = static_cast<float>(slopeSquared);
        // All values up to halfway to the next float round to this one.
        skipped = 0.5 * (double(rounded) + double(std::nextafter(rounded, kInfinityF))) * (1 - kSlack);
    }
};

ConeSearch::ConeSearch(const ConePairs& pairs, const DepthPyramid& pyramid)
    : pairs_(pairs), pyramid_(pyramid), size_(pairs.map().width(), pairs.map().height()) {
    const auto tiles = [](Wrap wrap) { return wrap == Wrap::Repeat ? ConePairs::kReachTiles : 0; };
    tiles_ = {tiles(pairs.map().wrapS()), tiles(pairs.map().wrapT())};
}

/// Upper bound of the slopes to a block: the smaller one of the bounds from its highest point at its minimum
/// distance, and from its plane.
ConeSearch::Block ConeSearch::boundOf(const Query& query, int level, const Vec2i& at,
                                      const Vec2i& shift) const {
    Block block{level, at, shift, 0};
    Vec2i low, high;
    pyramid_.block(level, at, low, high);
    low += shift - query.texel;
    high += shift - query.texel;
    const Vec2i nearest = glm::max(glm::max(low, -high), Vec2i(0)), farthest = glm::max(-low, high);
    const double offsetSquared = pairs_.offsetSquared(nearest.x, nearest.y);
    const double distanceSquared = pairs_.minDistanceSquared(offsetSquared);
    const auto tooLow = [&](double drop) {
        return !(drop > 0) || drop * drop <= query.skipped * distanceSquared;
    };
    const DepthPyramid::Bound* bounds = pyramid_.bounds(level, at);
    if (tooLow(query.depth - bounds->minDepth)) return block;
    if (!pairs_.meetsSector(low, high, query.sector)) return block;
    DepthPyramid::Bound bound = *bounds;
    if (const unsigned octants = pyramid_.octantsMet(low, high)) {
        bound = DepthPyramid::boundOfOctants(bounds, octants);
        if (tooLow(query.depth - bound.minDepth) || std::max(farthest.x, farthest.y) < bound.minReach)
            return block;
    }
    if (pairs_.rule().relaxed && !pyramid_.exitPossible(level, at, low, high)) return block;
    if (distanceSquared == 0) {
        block.bound = kInfinity;
        return block;
    }
    const double drop = query.depth - bound.minDepth;
    block.bound = drop * drop / distanceSquared;
    // D_p - D_q <= above - slope . k, so the pair's slope is at most above / distance + |slope| |k| /
    // distance.
    const DepthPyramid::Plane& plane = pyramid_.plane(level, at);
    const double above =
        query.depth - bound.residual - glm::dot(plane.slope, Vec2(query.texel - shift) - plane.center);
    const double distance =
        above > 0 ? std::sqrt(distanceSquared) : std::sqrt(pairs_.offsetSquared(farthest.x, farthest.y));
    const double byPlane = above / distance + plane.steepness * std::sqrt(offsetSquared / distanceSquared);
    block.bound = byPlane > 0 ? std::min(block.bound, byPlane * byPlane) : 0;
    return block;
}

void ConeSearch::visitPair(Query& query, const Vec2i& at) const {
    const Vec2i offset = at - query.texel;
    const double drop = query.depth - pairs_.map().texel(at.x, at.y);
    if (!(drop > 0)) return;
    const double slopeSquared = drop * drop / pairs_.distanceSquared(offset.x, offset.y);
    if (slopeSquared > query.steepest &&
        pairs_.counts(query.texel.x, query.texel.y, offset.x, offset.y, query.sector))
        query.take(slopeSquared, at);
}

void ConeSearch::visitLeaf(Query& query, const Block& block) const {
    Vec2i low, high;
    pyramid_.block(block.level, block.at, low, high);
    const float* depths = pairs_.map().depths().data();
    for (int j = low.y; j <= high.y; ++j) {
        const float* row = depths + static_cast<size_t>(j) * static_cast<size_t>(size_.x);
        for (int i = low.x; i <= high.x; ++i) {
            const double drop = query.depth - row[i];
            if (!(drop > 0)) continue;
            const Vec2i offset = Vec2i(i, j) + block.shift - query.texel;
            const double least = pairs_.minDistanceSquared(pairs_.offsetSquared(offset.x, offset.y));
            if (drop * drop <= query.skipped * least) continue;
            if (pairs_.rule().relaxed) {
                const unsigned octants = pyramid_.octantsMet(offset, offset);
                if (octants != 0 && (octants & pyramid_.octantsOf(i, j)) == 0) continue;
            }
            visitPair(query, Vec2i(i, j) + block.shift);
        }
    }
}

/// Beyond the border of a clamped map, its border texels are repeated. A quadrant may contain the repetition
/// of a texel that is in another quadrant in the map. The nearest repetition, at the quadrant's edge, is the
/// one that counts; columns are visited outwards.
void ConeSearch::visitBeyondBorder(Query& query) const {
    if (query.sector == kAllDirections) return;
    const int along = query.sector / 2, across = 1 - along, sign = query.sector % 2 == 0 ? 1 : -1;
    if (tiles_[along] > 0) return;
    Vec2i first(0); // offset of the nearest texel at or beyond the border
    first[along] = sign > 0 ? size_[along] - 1 - query.texel[along] : -query.texel[along];
    for (int n = 0; n <= ConePairs::kReachTiles * size_[across]; ++n) {
        first[across] = n;
        while (!pairs_.meetsSector(first, first, query.sector))
            first[along] += sign;
        const double least = pairs_.minDistanceSquared(pairs_.offsetSquared(first.x, first.y));
        if (query.depth * query.depth <= query.skipped * least) return;
        for (const int side : {-n, n}) {
            const int at = query.texel[across] + side;
            if (tiles_[across] == 0 && (at < 0 || at >= size_[across])) continue;
            Vec2i offset = first;
            offset[across] = side;
            for (;; offset[along] += sign) {
                if (offset != Vec2i(0)) visitPair(query, query.texel + offset);
                if (pairs_.insideSector(offset, query.sector)) break;
            }
        }
    }
}

/// Stack of blocks to be visited, with the most promising one of the last group on top.
struct ConeSearch::Agenda {
    // At most 25 images, and three more per level.
    std::array<Block, 128> blocks;
    size_t count = 0, groupBegin = 0;

    void beginGroup() { groupBegin = count; }
    void add(const Query& query, const Block& block) {
        if (block.bound <= query.skipped) return;
        size_t place = count++;
        for (; place > groupBegin && blocks[place - 1].bound > block.bound; --place)
            blocks[place] = blocks[place - 1];
        blocks[place] = block;
    }
};

void ConeSearch::addImages(const Query& query, Agenda& agenda) const {
    const int top = pyramid_.levelCount() - 1;
    agenda.beginGroup();
    for (int tileT = -tiles_.y; tileT <= tiles_.y; ++tileT)
        for (int tileS = -tiles_.x; tileS <= tiles_.x; ++tileS)
            agenda.add(query, boundOf(query, top, {0, 0}, Vec2i(tileS, tileT) * size_));
}

void ConeSearch::addChildren(const Query& query, const Block& block, Agenda& agenda) const {
    const Vec2i end = glm::min(2 * block.at + 2, pyramid_.blockCount(block.level - 1));
    agenda.beginGroup();
    for (int y = 2 * block.at.y; y < end.y; ++y)
        for (int x = 2 * block.at.x; x < end.x; ++x)
            agenda.add(query, boundOf(query, block.level - 1, {x, y}, block.shift));
}

/// Visits the neighboring texel's winner, and the same offset from this texel, as initial bounds.
void ConeSearch::visitGuesses(Query& query, const Vec2i& neighborsWinner) const {
    for (const int step : {0, 1}) {
        const Vec2i guess = neighborsWinner + Vec2i(step, 0);
        const bool inMap = guess.x < size_.x || tiles_.x > 0;
        if (inMap && guess != query.texel) visitPair(query, guess);
    }
}

float ConeSearch::steepestSquared(int column, int row, int sector, Winner& winner) const {
    Query query{.texel = {column, row}, .sector = sector, .depth = pairs_.map().texel(column, row)};
    if (winner) visitGuesses(query, *winner);
    Agenda agenda;
    addImages(query, agenda);
    while (agenda.count > 0) {
        const Block block = agenda.blocks[--agenda.count];
        if (block.bound <= query.skipped) continue;
        if (block.level == 0)
            visitLeaf(query, block);
        else
            addChildren(query, block, agenda);
    }
    visitBeyondBorder(query);
    winner = query.winner;
    return keptSlopeSquared(query.steepest);
}

} // namespace plumbline
