#pragma once

#include <string>
#include <vector>

#include "mesher/space/delaunay/periodic_delaunay.hpp"
#include "mesher/space/mesh/polyhedral_mesh.hpp"
#include "mesher/space/search/lattice_pattern.hpp"

namespace pcvt::testing {

/// Sites for tests of polyhedra, with a name for messages.
struct SpaceCase {
    std::string name;
    space::Lattice lattice;
    space::Points points;
};

inline space::Points lattice_points(int n) {
    return pattern_points(space::best_lattice(Eigen::Matrix3d::Identity(), n));
}

inline space::Points grid_points(int k) {
    return pattern_points(
        space::lattice_pattern(Eigen::Matrix3d::Identity(), {.a = k, .d = k, .f = k}));
}

/// Random sites on cubes, oblique and thin lattices, and sites of exact lattices.
inline std::vector<SpaceCase> space_cases() {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const space::Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {2.4, 0.3, 1.2});
    const space::Lattice left_handed({1, 0, 0}, {0, 0, 1.1}, {0.3, 0.8, 0});
    const space::Lattice thin = space::Lattice::box(1, 0.01, 0.3);
    std::vector<SpaceCase> cases;
    std::uint64_t seed = 0;
    for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 30, 200}) {
        const std::string size = " " + std::to_string(n);
        cases.push_back({"cube" + size, cube, uniform_points(cube, n, ++seed)});
        cases.push_back({"oblique" + size, oblique, uniform_points(oblique, n, ++seed)});
        cases.push_back({"left" + size, left_handed, uniform_points(left_handed, n, ++seed)});
        cases.push_back({"thin" + size, thin, uniform_points(thin, n, ++seed)});
    }
    for (const int n : {1, 2, 3, 4, 8, 9, 16, 27, 32, 54}) {
        cases.push_back({"lattice " + std::to_string(n), cube, lattice_points(n)});
    }
    for (const int k : {2, 3, 4}) {
        cases.push_back({"grid " + std::to_string(k), cube, grid_points(k)});
    }
    return cases;
}

inline space::CellComplex complex_of(const SpaceCase& c) {
    const space::PeriodicDelaunay delaunay =
        space::periodic_delaunay(space::Sites(c.lattice, c.points));
    return cell_complex(delaunay.sites, delaunay.tetrahedra);
}

inline space::PolyhedralMesh mesh_of(const SpaceCase& c) {
    return polyhedral_mesh(space::Sites(c.lattice, c.points), complex_of(c));
}

}  // namespace pcvt::testing
