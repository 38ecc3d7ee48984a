#include "mesher/space/mesh/shrinking_complex.hpp"

#include <gtest/gtest.h>

#include "tests/support/polyhedra.hpp"

namespace pcvt::space {
namespace {

using testing::complex_of;
using testing::space_cases;
using testing::SpaceCase;

constexpr double kShrinking = 0.1;

void expect_same(const CellComplex& found, const CellComplex& expected) {
    EXPECT_EQ(found.vertices, expected.vertices);
    EXPECT_EQ(found.corners, expected.corners);
    EXPECT_EQ(found.begin, expected.begin);
}

/// Removes all edges that may shrink to their middles.
void remove_all(ShrinkingComplex& complex) {
    for (const ShortEdge& edge : complex.edges_below(complex.shortest())) {
        if (!complex.is_short(edge)) continue;
        if (const auto middle = complex.middle_of(edge)) complex.remove(edge, *middle);
    }
}

/// After an edge is removed and its state restored, everything is as if it had never been removed.
TEST(ShrinkingComplex, RestoresAState) {
    int n_restored = 0;
    for (const SpaceCase& c : space_cases()) {
        if (c.points.cols() > 40) continue;
        SCOPED_TRACE(c.name);
        const CellComplex complex = complex_of(c);
        ShrinkingComplex expected(complex, kShrinking);
        remove_all(expected);
        ShrinkingComplex shrinking(complex, kShrinking);
        for (const ShortEdge& edge : shrinking.edges_below(shrinking.shortest())) {
            const auto middle = shrinking.middle_of(edge);
            if (!middle) continue;
            const std::vector<int> ends{edge.from, edge.to.vertex};
            const auto before = shrinking.state_of(ends, shrinking.faces_at(ends));
            shrinking.remove(edge, *middle);
            EXPECT_FALSE(shrinking.is_short(edge));
            shrinking.restore(before);
            EXPECT_TRUE(shrinking.is_short(edge));
            ++n_restored;
        }
        expect_same(shrinking.result(), complex);
        remove_all(shrinking);
        expect_same(shrinking.result(), expected.result());
    }
    EXPECT_GT(n_restored, 100);
}

}  // namespace
}  // namespace pcvt::space
