#pragma once

#include <string>

#include "mesher/plane/energy/energy.hpp"

namespace pcvt::testing {

/// Reference implementations for a MovingDelaunay and its energy, and comparisons with them. Each
/// comparison returns a description of the first difference, or an empty string. `sites` are the
/// constructor's sites at the engine's current positions: see sites_of.

/// The sites of the engine in the caller's order, wrapped; `original` provides lattice and
/// reduction.
plane::Sites sites_of(const plane::MovingDelaunay& delaunay, const plane::Sites& original);

/// Checks the laws of TorusTriangulation, that every triangle is counter-clockwise and every edge
/// locally Delaunay (exactly), and that coordinates are multiples of 2^-51 within their range.
std::string broken_law(const plane::MovingDelaunay& delaunay, const plane::Sites& sites);

/// Compares with the mirror diagram: the edges must be equal, except for edges whose four sites are
/// exactly cocircular.
std::string difference_from_mirrors(const plane::MovingDelaunay& delaunay,
                                    const plane::Sites& sites);

/// Compares with a new build: F to 1e-12 of F, gradient and masses to 1e-12 of their maxima. Where
/// the gradient is small everywhere, the tolerance refers to its size if sites were as far from
/// their centroids as the points of the domain are from their sites.
std::string difference_from_new_build(const plane::MovingDelaunay& delaunay, const Energy& energy,
                                      const plane::Sites& sites);

/// Compares with integrals over the polygons of the mirror diagram's pieces; for few sites.
std::string difference_from_pieces(const plane::MovingDelaunay& delaunay, const Energy& energy,
                                   const plane::Sites& sites);

}  // namespace pcvt::testing
