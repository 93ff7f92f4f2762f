#include "scenes/surface/weld.h"

#include "scenes/core/disjoint_sets.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

namespace {

bool agree(const Displacement& a, const Displacement& b, double depth) {
    return std::abs(a.height - b.height) <= kTornFraction * depth &&
           glm::length(a.direction - b.direction) <= kTornFraction;
}

} // namespace

std::vector<Displacement> weldedSides(std::vector<Displacement> ofFaces, double depth) {
    const bool allAgree = std::all_of(ofFaces.begin(), ofFaces.end(), [&](const Displacement& side) {
        return agree(side, ofFaces.front(), depth);
    });
    if (allAgree) return ofFaces;
    // In the order of one coordinate, only those within the tolerance of it need to be compared.
    std::stable_sort(ofFaces.begin(), ofFaces.end(), [](const Displacement& a, const Displacement& b) {
        return a.direction.x < b.direction.x;
    });
    DisjointSets groups(ofFaces.size());
    for (int i = 0; i < countOf(ofFaces); ++i)
        for (int j = i + 1; j < countOf(ofFaces) &&
                            item(ofFaces, j).direction.x - item(ofFaces, i).direction.x <= kTornFraction;
             ++j)
            if (groups.rootOf(i) != groups.rootOf(j) && agree(item(ofFaces, i), item(ofFaces, j), depth))
                groups.join(i, j);
    struct Sum {
        Displacement total{Vec3(0), 0};
        int count = 0;
    };
    std::vector<Sum> sums(ofFaces.size()); // at the groups' roots
    for (int i = 0; i < countOf(ofFaces); ++i) {
        Sum& sum = item(sums, groups.rootOf(i));
        sum.total.direction += item(ofFaces, i).direction;
        sum.total.height += item(ofFaces, i).height;
        ++sum.count;
    }
    std::vector<Displacement> sides;
    for (const Sum& sum : sums)
        if (sum.count > 0)
            sides.push_back({sum.total.direction / double(sum.count), sum.total.height / sum.count});
    return sides;
}

} // namespace plumbline
