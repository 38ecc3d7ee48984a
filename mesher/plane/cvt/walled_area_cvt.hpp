#pragma once

#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/cvt/wall_rounds.hpp"

namespace pcvt::plane {

/// Cells of prescribed areas between walls, and the torus of which they are a part.
struct WalledAreaCvt {
    /// The cells of the domain and its mirror images, with equal weights. The energy is that of the
    /// domain, in which the cell of a site on a wall counts as a half, in a corner as a quarter.
    AreaCvtResult torus;
    /// Which sites of the torus belong to the domain.
    WalledDomain domain;
};

/// Finds the power diagram of a rectangle with walls whose cells have prescribed areas, as
/// compute_area_cvt() does on a torus: as the part between the walls of a power diagram with mirror
/// symmetry. A site and its image have the same weight, so that the wall between them is an edge of
/// their cells.
///
/// Example usage:
///   const Lattice box = Lattice::rectangle(2, 1);
///   const Eigen::VectorXd areas = scaled_areas(draw_areas(law, n, seed), n, box.area());
///   const WalledAreaCvt grains = compute_walled_area_cvt(
///       box, Walls::kXY, WallCells::kWhole, points, {.areas = areas, .run = {.max_iterations =
///       5}});
///
/// Half cells come about in several runs (run_wall_rounds()), each with the centroidal steps of the
/// options. Laws, tested by number:
///   (1) The cells are those that the walls clip from the power diagram of the sites between them.
///   (2) The part of each cell between the walls has its area, to the tolerance of the torus.
///   (3) Every bit is the same for any number of threads.
///
/// @param domain   upright.
/// @param points   2 x n, length units, between the walls.
/// @param options  areas of the parts between the walls. numbering and progress mean sites and
///                 energies of the domain.
/// @throws InvalidInput  a point lies beyond a wall; half cells do not come about.
/// @throws as compute_area_cvt does.
WalledAreaCvt compute_walled_area_cvt(const Lattice& domain, Walls walls, WallCells cells,
                                      Points points, const AreaCvtOptions& options);

}  // namespace pcvt::plane
