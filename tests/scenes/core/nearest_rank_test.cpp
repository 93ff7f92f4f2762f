#include "scenes/core/nearest_rank.h"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>
#include <vector>

namespace plumbline {
namespace {

TEST(NearestRank, Percentile_IsSmallestValueReached) {
    std::vector<double> values(100);
    std::iota(values.begin(), values.end(), 1.0); // 1 … 100: the p-th percentile is p
    for (const unsigned percent : {1u, 50u, 95u, 99u, 100u})
        EXPECT_EQ(nearestRank(values, percent), percent);
    EXPECT_EQ(nearestRank({7}, 1), 7);
    EXPECT_EQ(nearestRank({7}, 99), 7);
    EXPECT_EQ(nearestRank({1, 2, 3, 4}, 50), 2); // rank ceil(2) = 2
    EXPECT_EQ(nearestRank({1, 2, 3, 4}, 51), 3); // rank ceil(2.04) = 3
    EXPECT_EQ(nearestRank({1, 2, 3, 4, 5}, 50), 3);
    EXPECT_EQ(nearestRank({1, 2, 3, 4}, 99), 4);
}

TEST(NearestRank, Projection_GivesWholeElement) {
    std::vector<std::pair<char, float>> values{{'d', 4.0f}, {'a', 1.0f}, {'c', 3.0f}, {'b', 2.0f}};
    EXPECT_EQ(nearestRankInPlace(values, 51, &std::pair<char, float>::second).first, 'c');
    EXPECT_EQ(nearestRankInPlace(values, 100, &std::pair<char, float>::second).first, 'd');
}

} // namespace
} // namespace plumbline
