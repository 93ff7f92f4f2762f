// Disjoint sets (union-find) over the integers 0 … count - 1.
#pragma once

#include "scenes/core/index.h"

#include <numeric>
#include <vector>

namespace plumbline {

class DisjointSets {
  public:
    explicit DisjointSets(size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }
    int rootOf(int i) {
        while (parent(i) != i)
            i = parent(i) = parent(parent(i));
        return i;
    }
    void join(int a, int b) { parent(rootOf(a)) = rootOf(b); }

  private:
    int& parent(int i) { return item(parents_, i); }
    std::vector<int> parents_;
};

} // namespace plumbline
