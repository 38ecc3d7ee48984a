#include "mesher/plane/geometry/sites.hpp"

#include <cmath>
#include <random>
#include <string>

#include "mesher/base/error.hpp"

namespace pcvt::plane {
Sites::Sites(const Lattice& lattice, const Points& points)
    : lattice_(lattice), reduction_(reduce(lattice)), coordinates_(2, points.cols()) {
    if (points.cols() == 0) throw InvalidInput("there is no site; give at least one");
    if (points.cols() > kMostSites) throw InvalidInput("there are more than 2^28 sites");
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        if (!points.col(s).allFinite()) {
            throw InvalidInput("site " + std::to_string(s) +
                               " is not finite; give finite coordinates");
        }
        const Vec2 u = reduction_.reduced.to_lattice(points.col(s));
        if (!(u.cwiseAbs().maxCoeff() < kFarthestPeriod)) {
            throw InvalidInput("site " + std::to_string(s) +
                               " lies more than 2^30 periods away; wrap it into the domain");
        }
        coordinates_.col(s) << wrap(u.x()).fraction, wrap(u.y()).fraction;
    }
    const auto [first, second] = duplicates();
    if (first >= 0) throw DuplicateSites(first, second);
}

Sites::Sites(const Lattice& lattice, const Reduction& reduction, Points coordinates)
    : lattice_(lattice), reduction_(reduction), coordinates_(std::move(coordinates)) {
    for (double& u : coordinates_.reshaped()) u = wrap(u).fraction;
}

Vec2 Sites::position(SiteId site) const {
    return reduction_.reduced.to_plane(coordinates_.col(site));
}

double Sites::spacing() const { return std::sqrt(lattice_.area() / n_sites()); }

std::pair<SiteId, SiteId> Sites::duplicates() const { return first_equal_sites(coordinates_); }

Points uniform_points(const Lattice& lattice, int n, std::uint64_t seed) {
    if (n < 1) throw InvalidInput("the number of sites must be at least 1");
    std::mt19937_64 generator(seed);
    const auto uniform = [&generator] { return std::ldexp(double(generator() >> 11), -53); };
    Points points(2, n);
    for (int s = 0; s < n; ++s) {
        const double u = uniform();
        const double v = uniform();
        points.col(s) = lattice.to_plane({u, v});
    }
    return points;
}

}  // namespace pcvt::plane
