#pragma once

#include <string>

#include "mesher/energy/energy.hpp"

namespace pcvt::testing {

/// Twins of a MovingDelaunay and of its energy, and what tells them apart. Each function returns
/// the first difference in words, or nothing. `sites` are those of the constructor's call, moved to
/// where the engine says they are: see sites_of.

/// The sites of the engine in the caller's order, wrapped; `original` lends lattice and reduction.
Sites sites_of(const MovingDelaunay& delaunay, const Sites& original);

/// The torus triangulation's laws, every triangle counter-clockwise and every edge locally Delaunay
/// (exact), and coordinates on the grid of 2^-51 inside of their range.
std::string broken_law(const MovingDelaunay& delaunay, const Sites& sites);

/// Against the mirror diagram: the same edges, but for those whose four sites are exactly
/// cocircular.
std::string difference_from_mirrors(const MovingDelaunay& delaunay, const Sites& sites);

/// Against a fresh build: F to 1e-12 of F, gradient and masses to 1e-12 of their largest ones;
/// where the gradient is small everywhere, of what it would be were sites as far from their
/// centroids as the points of the domain from their sites.
std::string difference_from_fresh_build(const MovingDelaunay& delaunay, const Energy& energy,
                                        const Sites& sites);

/// Against integrals over the polygons of the mirror diagram's pieces: for few sites.
std::string difference_from_pieces(const MovingDelaunay& delaunay, const Energy& energy,
                                   const Sites& sites);

}  // namespace pcvt::testing
