// How many techniques fail at each pixel. Where all do, the cause is the scene or the base; where one does,
// it is the technique.
#pragma once

#include "validate/compare/compare.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::report {

class FailingPixels {
  public:
    /// `comparison` must be of this pair; every pair of one size.
    void add(const FramePair& pair, const Comparison& comparison);

    /// Techniques added.
    int techniques() const { return techniques_; }
    /// Per pixel, row 0 = top: those that fail there.
    const std::vector<uint16_t>& counts() const { return counts_; }
    /// What counts as failing, a sentence.
    static std::string meaning();

  private:
    int techniques_ = 0;
    std::vector<uint16_t> counts_;
};

} // namespace plumbline::report
