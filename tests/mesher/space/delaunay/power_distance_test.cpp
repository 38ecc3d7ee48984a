#include "mesher/space/delaunay/power_distance.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "tests/support/space_lattices.hpp"

namespace pcvt::space {
namespace {

TEST(PowerDistanceInSpace, IsComparedAsByLongDoubles) {
    std::mt19937_64 random(2);
    const auto draw = [&] { return double(std::int64_t(random() >> 12)) * 0x1p-50 - 2; };
    for (const auto& [name, lattice] : testing::space_lattices()) {
        const Gram gram = gram_of(reduce(lattice).reduced);
        for (int k = 0; k < 1000; ++k) {
            SeenImage p{{draw(), draw(), draw()}, 0};
            SeenImage q{{draw(), draw(), draw()}, 0};
            const auto distance = [&](const SeenImage& image) {
                const auto& d = image.displacement;
                return gram.squared_length<long double>(d.x(), d.y(), d.z()) - image.weight;
            };
            // A weight next to that of a tie, and none.
            if (k % 2 == 0) {
                const auto tie = static_cast<double>(distance(p) - distance(q));
                const double off = (k % 4 == 0 ? 1e-13 : -1e-13) * static_cast<double>(distance(q));
                p.weight = std::nearbyint((tie + off) * 0x1p100) * 0x1p-100;
            }
            const long double difference = distance(p) - distance(q);
            const int wanted = difference < 0 ? -1 : 1;
            EXPECT_EQ(compare_power_distances(gram, p, q), wanted) << name;
            EXPECT_EQ(compare_power_distances(gram, q, p), -wanted) << name;
        }
    }
}

/// Dyadic numbers whose tie, and the smallest weight that breaks it, need 213 bits.
TEST(PowerDistanceInSpace, TiesAreExact) {
    const Gram gram{0x1p-1, 0, 0, 0x1p-1, 0, 0x1p40};
    const SeenImage p{{1 + 0x1p-50, 0, 3}, 0};
    const SeenImage q{{-1 - 0x1p-50, 0, -3}, 0};
    EXPECT_EQ(compare_power_distances(gram, p, q), 0);
    EXPECT_EQ(compare_power_distances(gram, {p.displacement, 0x1p-100}, q), -1);
    EXPECT_EQ(compare_power_distances(gram, p, {q.displacement, 0x1p-100}), 1);
    EXPECT_EQ(compare_power_distances(gram, {p.displacement, 0x1p42}, {q.displacement, 0x1p42}), 0);
    EXPECT_EQ(compare_power_distances(gram, {p.displacement, -0x1p42}, q), 1);
}

}  // namespace
}  // namespace pcvt::space
