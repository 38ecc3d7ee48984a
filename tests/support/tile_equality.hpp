#pragma once

#include <gtest/gtest.h>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::testing {

/// Expects that all numbers of the two tiles are equal, bit for bit except for the sign of zero.
inline void expect_same_tile(const plane::Tile& actual, const plane::Tile& expected) {
    EXPECT_EQ(actual.lattice.a(), expected.lattice.a());
    EXPECT_EQ(actual.lattice.b(), expected.lattice.b());
    EXPECT_EQ(actual.kind, expected.kind);
    EXPECT_EQ(actual.points, expected.points);
    EXPECT_EQ(actual.faces.begin, expected.faces.begin);
    EXPECT_EQ(actual.faces.corners, expected.faces.corners);
    EXPECT_EQ(actual.face_site, expected.face_site);
    EXPECT_EQ(actual.vertex_site, expected.vertex_site);
    EXPECT_TRUE(actual.vertex_pairs == expected.vertex_pairs);
    EXPECT_TRUE(actual.edge_pairs == expected.edge_pairs);
}

/// Lattices with awkward numbers: oblique, left-handed, tiny, huge.
inline std::vector<plane::Lattice> awkward_lattices() {
    return {plane::Lattice({1, 0}, {0, 1}), plane::Lattice({1, 0}, {0.37, 0.81}),
            plane::Lattice({0, 1}, {1, 0}), plane::Lattice({1e-3 / 3, 0}, {0, 2e-3 / 7}),
            plane::Lattice({1e6 / 3, 1e5 / 7}, {-1e5, 1e6 / 9})};
}

}  // namespace pcvt::testing
