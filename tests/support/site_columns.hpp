#pragma once

#include "mesher/delaunay/spatial_sort.hpp"
#include "mesher/lattice/sites.hpp"

namespace pcvt::testing {

/// The columns in which the strips of a triangulation begin.
inline SpatialSort columns_of(const Sites& sites) {
    return spatial_sort(sites.coordinates(), gram_of(sites.reduction().reduced));
}

}  // namespace pcvt::testing
