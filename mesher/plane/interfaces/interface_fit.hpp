#pragma once

#include "mesher/plane/interfaces/interface_sites.hpp"

namespace pcvt::plane {

/// Seeds along all interfaces and the number of sites beside them.
struct InterfaceFit {
    InterfaceSites interfaces;
    int n_free;
    /// Chords, and the distances of free sites, are this times the spacing of n equal cells.
    double scale;
};

/// Divides n sites into seeds and free sites so that the cells of free sites are as large as those
/// of seeds, where gaps and bends do not need smaller ones.
///
/// @param spacing  h at a point for n sites without inclusions: the integral of 1 / h^2 is n.
/// @throws InvalidInput naming a number that suffices if n is too small: if the cells of free sites
///         would have more than nine times the mean area.
InterfaceFit fit_interface_sites(const InclusionSet& set, int n,
                                 const std::function<double(const Vec2&)>& spacing);

}  // namespace pcvt::plane
