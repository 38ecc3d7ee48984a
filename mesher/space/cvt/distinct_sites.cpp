#include "mesher/space/cvt/distinct_sites.hpp"

#include "mesher/torus/coincident_sites.hpp"

namespace pcvt::space {

Sites distinct_sites(const Lattice& lattice, const Points& points) {
    Sites sites(lattice, points);
    Eigen::Matrix3d periods;
    for (int k = 0; k < 3; ++k) periods.col(k) = sites.reduction().reduced.periods()[k];
    auto pairs = coincident_sites(sites.coordinates(), periods, kCoincident * sites.spacing());
    if (!pairs.empty()) throw DuplicateSites(std::move(pairs));
    return sites;
}

}  // namespace pcvt::space
