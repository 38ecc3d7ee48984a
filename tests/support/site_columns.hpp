#pragma once

#include "mesher/plane/delaunay/spatial_sort.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::testing {

/// The columns in which the strips of a triangulation begin.
inline plane::SpatialSort columns_of(const plane::Sites& sites) {
    return spatial_sort(sites.coordinates(), gram_of(sites.reduction().reduced));
}

}  // namespace pcvt::testing
