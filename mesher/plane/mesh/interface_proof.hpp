#pragma once

#include <optional>
#include <span>
#include <string>

#include "mesher/plane/interfaces/interface_sites.hpp"
#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// Returns the first fault in the interfaces of a cell mesh, naming the chord, edge or inclusion,
/// or nullopt if these laws, tested by number, hold:
///   (1) Each chord is an edge between the cells of its two seeds, and its ends are the nodes, to
///       kSameVertex h.
///   (2) All other edges have the same inclusion, or the matrix, on both sides.
///   (3) The cells of an inclusion have the area of its polygon of chords, less those of the
///       inclusions inside of it, to 1e-12 of the domain.
///
/// Example usage:
///
///     const PeriodicMesh cells = cell_mesh(result.cvt.delaunay);
///     if (const auto wrong = interface_violation(cells, result.interfaces, result.inclusion))
///         throw InternalError(*wrong);
///
/// @param cells      of cell_mesh(); its first sites are the seeds.
/// @param inclusion  of each site; -1 is the matrix. Between walls, of each site of the domain, and
///                   only these cells are proved: those behind walls count as matrix.
std::optional<std::string> interface_violation(const PeriodicMesh& cells,
                                               const InterfaceSites& interfaces,
                                               std::span<const int> inclusion);

/// Checks only law (1).
bool every_chord_is_an_edge(const PeriodicMesh& cells, const std::vector<Chord>& chords);

}  // namespace pcvt::plane
