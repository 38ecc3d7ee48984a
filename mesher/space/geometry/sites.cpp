#include "mesher/space/geometry/sites.hpp"

#include "mesher/torus/sites_definitions.hpp"

namespace pcvt::space {

Points wrapped_positions(const Sites& sites, const Vec3& origin) {
    Points positions = sites.positions();
    if (origin == Vec3::Zero()) return positions;
    const Lattice& reduced = sites.reduction().reduced;
    for (auto p : positions.colwise()) {
        const Vec3 whole = reduced.to_lattice(p - origin).array().floor();
        p -= reduced.to_position(whole);
    }
    return positions;
}

Sites some_of(const Sites& sites, std::span<const SiteId> chosen) {
    Points coordinates(3, static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        coordinates.col(Eigen::Index(k)) = sites.coordinates().col(chosen[k]);
    }
    return {sites.lattice(), sites.reduction(), std::move(coordinates)};
}

}  // namespace pcvt::space

namespace pcvt {

template struct Reduction<space::Lattice>;
template class Sites<space::Lattice>;
template space::Points uniform_points(const space::Lattice& lattice, int n, std::uint64_t seed);

}  // namespace pcvt
