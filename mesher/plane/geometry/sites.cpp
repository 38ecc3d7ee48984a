#include "mesher/plane/geometry/sites.hpp"

#include "mesher/torus/sites_definitions.hpp"

namespace pcvt {

template struct Reduction<plane::Lattice>;
template class Sites<plane::Lattice>;
template plane::Points uniform_points(const plane::Lattice& lattice, int n, std::uint64_t seed);

}  // namespace pcvt
