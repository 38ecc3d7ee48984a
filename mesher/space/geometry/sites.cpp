#include "mesher/space/geometry/sites.hpp"

#include <cmath>
#include <random>
#include <string>

#include "mesher/base/error.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt::space {

Sites::Sites(const Lattice& lattice, const Points& points)
    : lattice_(lattice), reduction_(reduce(lattice)), coordinates_(3, points.cols()) {
    if (points.cols() == 0) throw InvalidInput("there is no site; give at least one");
    if (points.cols() > kMostSites) throw InvalidInput("there are more than 2^26 sites");
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        if (!points.col(s).allFinite()) {
            throw InvalidInput("site " + std::to_string(s) +
                               " is not finite; give finite coordinates");
        }
        const Vec3 u = reduction_.reduced.to_lattice(points.col(s));
        if (!(u.cwiseAbs().maxCoeff() < kFarthestPeriod)) {
            throw InvalidInput("site " + std::to_string(s) +
                               " lies more than 2^30 periods away; wrap it into the domain");
        }
        coordinates_.col(s) = wrap(u).fraction;
    }
    const auto [first, second] = duplicates();
    if (first >= 0) throw DuplicateSites(first, second);
}

Sites::Sites(const Lattice& lattice, const Reduction& reduction, Points coordinates)
    : lattice_(lattice), reduction_(reduction), coordinates_(std::move(coordinates)) {
    for (Eigen::Index s = 0; s < coordinates_.cols(); ++s) {
        coordinates_.col(s) = wrap(coordinates_.col(s)).fraction;
    }
}

Vec3 Sites::position(SiteId site) const {
    return reduction_.reduced.to_space(coordinates_.col(site));
}

double Sites::spacing() const { return portable_cbrt(lattice_.volume() / n_sites()); }

std::pair<SiteId, SiteId> Sites::duplicates() const { return first_equal_sites(coordinates_); }

Sites some_of(const Sites& sites, std::span<const SiteId> chosen) {
    Points coordinates(3, static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        coordinates.col(Eigen::Index(k)) = sites.coordinates().col(chosen[k]);
    }
    return {sites.lattice(), sites.reduction(), std::move(coordinates)};
}

Points uniform_points(const Lattice& lattice, int n, std::uint64_t seed) {
    if (n < 1) throw InvalidInput("the number of sites must be at least 1");
    std::mt19937_64 generator(seed);
    const auto uniform = [&generator] { return std::ldexp(double(generator() >> 11), -53); };
    Points points(3, n);
    for (int s = 0; s < n; ++s) {
        const double u = uniform();
        const double v = uniform();
        const double w = uniform();
        points.col(s) = lattice.to_space({u, v, w});
    }
    return points;
}

}  // namespace pcvt::space
