#pragma once

#include "io/formats/space_file_proof.hpp"
#include "mesher/cells/orientations.hpp"
#include "mesher/space/cvt/weighted_cells.hpp"
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

/// Power cells of the sites of a case, with weights that rise from 0 to `largest`.
inline SpaceTile power_tile_of(const SpaceCase& c, double largest) {
    const Eigen::VectorXd weights = largest * Eigen::VectorXd::LinSpaced(c.points.cols(), 0, 1);
    const space::WeightedCells cells = space::weighted_cells(c.lattice, c.points, weights, {});
    const space::PeriodicDelaunay& delaunay = cells.delaunay;
    const space::CellComplex complex =
        cell_complex(delaunay.sites, delaunay.tetrahedra, delaunay.weights);
    std::vector<space::Offset> images;
    SpaceTile power{.mesh = polyhedral_mesh(delaunay.sites, complex, {0, 0, 0}, &images)};
    power.sites = sites_of_cells(complex, images);
    power.weights = delaunay.weights;
    return power;
}

/// Phases a and b in turn, and orientations without a texture.
inline CellMaterials some_materials(int n_cells) {
    CellMaterials materials{.phase_names = {"a", "b"},
                            .site_orientation = random_orientations(n_cells, 1)};
    for (int s = 0; s < n_cells; ++s) materials.site_phase.push_back(s % 3 == 0 ? 0 : 1);
    return materials;
}

}  // namespace pcvt::testing
