#pragma once

#include <gtest/gtest.h>

#include "mesher/plane/delaunay/torus_triangulation.hpp"

namespace pcvt::testing {

/// Expects laws 1 to 3 of TorusTriangulation.
inline void expect_laws(const plane::TorusTriangulation& t) {
    ASSERT_EQ(t.n_triangles(), 2 * t.n_sites());
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const int o = t.opposite(h);
        ASSERT_NE(o, h);
        ASSERT_EQ(t.opposite(o), h);
        ASSERT_EQ(t.edge_offset(o), -t.edge_offset(h));
        ASSERT_EQ(t.corner(o).site, t.corner(plane::TorusTriangulation::next(h)).site);
        ASSERT_EQ(t.frame_across(o), -t.frame_across(h));
    }
}

}  // namespace pcvt::testing
