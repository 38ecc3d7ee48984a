#pragma once

#include "io/formats/space_file_proof.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "tests/support/polyhedra.hpp"

namespace pcvt::testing {

/// The tile of sites without edges shorter than `shortest` h, with the sites in their cells.
inline SpaceTile tile_of(const SpaceCase& c, double shortest = 0) {
    const space::Sites sites(c.lattice, c.points);
    SpaceTile tile{.mesh = polyhedral_mesh(sites, without_short_edges(complex_of(c), shortest))};
    tile.sites = sites_in_cells(sites, tile.mesh);
    return tile;
}

inline SpaceTile random_space_tile(int n, double shortest = 0) {
    const space::Lattice oblique({1, 0.2, 0.1}, {-0.3, 0.9, 0.2}, {0.4, 0.3, 1.2});
    return tile_of({"random", oblique, uniform_points(oblique, n, 3)}, shortest);
}

}  // namespace pcvt::testing
