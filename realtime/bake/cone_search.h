// The steepest rise from a texel: exactly the largest of all pairs (cone_pairs.h), found by branch and bound
// over a DepthPyramid.
#pragma once

#include "realtime/bake/cone_pairs.h"
#include "realtime/bake/depth_pyramid.h"

#include <optional>

namespace plumbline {

/// A squared slope as it is kept: 1 where no pair exceeds the cap, else the second float above, so that
/// slopes that differ by less than a float's last bit are one, which the search can stop at, and rounding
/// never makes a cone wider.
float keptSlopeSquared(double slopeSquared);
/// The cone ratio of a kept squared slope, rounded down; 1 at most.
float coneRatio(float keptSlopeSquared);

class ConeSearch {
  public:
    ConeSearch(const ConePairs& pairs, const DepthPyramid& pyramid);

    /// Place of a winner, in texels of the endless map: a good first guess for the next texel.
    using Winner = std::optional<Vec2i>;
    /// The largest squared slope from a texel over all pairs that count, kept; at least 1. Replaces `winner`.
    float steepestSquared(int column, int row, int sector, Winner& winner) const;

  private:
    struct Query;
    struct Block;
    struct Agenda;
    Block boundOf(const Query& query, int level, const Vec2i& at, const Vec2i& shift) const;
    void addImages(const Query& query, Agenda& agenda) const;
    void addChildren(const Query& query, const Block& block, Agenda& agenda) const;
    void visitGuesses(Query& query, const Vec2i& neighborsWinner) const;
    void visitLeaf(Query& query, const Block& block) const;
    void visitPair(Query& query, const Vec2i& at) const;
    void visitBeyondBorder(Query& query) const;

    const ConePairs& pairs_;
    const DepthPyramid& pyramid_;
    Vec2i size_;
    Vec2i tiles_; // images looked at to each side
};

} // namespace plumbline
