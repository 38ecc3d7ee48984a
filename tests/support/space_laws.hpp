#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "mesher/space/delaunay/periodic_delaunay.hpp"

namespace pcvt::testing {

/// A tetrahedron as all its translates have it: sorted, relative to its first corner.
inline space::Tetrahedron canonical(space::Tetrahedron t) {
    std::sort(t.begin(), t.end());
    const space::Offset first = t[0].offset;
    for (space::Corner& corner : t) corner.offset = corner.offset - first;
    return t;
}

inline std::vector<space::Tetrahedron> canonical_tetrahedra(const space::TorusTetrahedra& torus) {
    std::vector<space::Tetrahedron> all;
    for (int t = 0; t < torus.n_tetrahedra(); ++t) all.push_back(canonical(torus.tetrahedron(t)));
    std::sort(all.begin(), all.end());
    return all;
}

/// Expects laws (1) to (3) of TorusTetrahedra.
inline void expect_torus(const space::TorusTetrahedra& torus, const space::Points& coordinates) {
    // Laws 1 and 2
    for (int f = 0; f < torus.n_facets(); ++f) {
        const int o = torus.opposite(f);
        ASSERT_NE(o, f);
        ASSERT_EQ(torus.opposite(o), f);
        auto here = torus.facet(f);
        auto there = torus.facet(o);
        for (space::Corner& corner : there) corner.offset = corner.offset + torus.frame_across(f);
        std::sort(here.begin(), here.end());
        std::sort(there.begin(), there.end());
        ASSERT_EQ(here, there);
        ASSERT_EQ(torus.frame_across(o), -torus.frame_across(f));
    }
    // Law 3
    std::set<std::array<space::Corner, 2>> edges;
    double volume = 0;
    for (int t = 0; t < torus.n_tetrahedra(); ++t) {
        ASSERT_TRUE(is_positive(torus, coordinates, t));
        const space::Tetrahedron corners = torus.tetrahedron(t);
        for (int k = 0; k < 4; ++k) {
            for (int m = k + 1; m < 4; ++m) {
                std::array<space::Corner, 2> edge{corners[k], corners[m]};
                std::array<space::Corner, 2> reverse{edge[1], edge[0]};
                for (auto* e : {&edge, &reverse}) {
                    const space::Offset first = (*e)[0].offset;
                    for (space::Corner& corner : *e) corner.offset = corner.offset - first;
                }
                edges.insert(std::min(edge, reverse));
            }
        }
        const auto at = [&](int k) { return image(coordinates, corners[k]).at; };
        volume += (at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0))) / 6;
    }
    EXPECT_EQ(torus.n_sites() - int(edges.size()) + torus.n_facets() / 2 - torus.n_tetrahedra(), 0);
    EXPECT_NEAR(volume, 1, 1e-12);
}

/// Expects that every facet is locally Delaunay: with expect_torus() a proof of the global
/// property.
inline void expect_delaunay(const space::TorusTetrahedra& torus, const space::Points& coordinates,
                            const space::Gram& gram) {
    for (int f = 0; f < torus.n_facets(); ++f) {
        ASSERT_TRUE(is_locally_delaunay(torus, coordinates, gram, f)) << "facet " << f;
    }
}

}  // namespace pcvt::testing
