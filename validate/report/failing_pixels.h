// The number of techniques that fail at each pixel. If all fail, the cause is the scene or the base; if one
// fails, it is the technique.
#pragma once

#include "validate/compare/compare.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::report {

class FailingPixels {
  public:
    /// `comparison` must be of this pair; all pairs must have the same size.
    void add(const FramePair& pair, const Comparison& comparison);

    /// Number of techniques added.
    int techniques() const { return techniques_; }
    /// Per pixel, row 0 = top: the number of techniques that fail there.
    const std::vector<uint16_t>& counts() const { return counts_; }
    /// The definition of failing, as a sentence.
    static std::string meaning();

  private:
    int techniques_ = 0;
    std::vector<uint16_t> counts_;
};

} // namespace plumbline::report
