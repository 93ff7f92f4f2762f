// Finds the steepest slope from a texel: the exact maximum over all pairs (cone_pairs.h), by branch and bound
// over a DepthPyramid.
#pragma once

#include "realtime/bake/cone_pairs.h"
#include "realtime/bake/depth_pyramid.h"

#include <optional>

namespace plumbline {

/// Rounds a squared slope: to 1 if no pair exceeds the cap, otherwise to the second float above. Slopes that
/// differ by less than a float's last bit become equal, which allows the search to stop early, and rounding
/// never makes a cone wider.
float keptSlopeSquared(double slopeSquared);
/// The cone ratio of a rounded squared slope, rounded down; at most 1.
float coneRatio(float keptSlopeSquared);

class ConeSearch {
  public:
    ConeSearch(const ConePairs& pairs, const DepthPyramid& pyramid);

    /// Position of the pair's second texel, unwrapped: a good initial guess for the next texel.
    using Winner = std::optional<Vec2i>;
    /// The maximum squared slope from a texel over all pairs that count, rounded by keptSlopeSquared; at
    /// least 1. Updates `winner`.
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
    Vec2i tiles_; // repeated images visited to each side
};

} // namespace plumbline
