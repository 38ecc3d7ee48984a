#include "mesher/sites.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "mesher/error.hpp"

namespace pcvt {
Sites::Sites(const Lattice& lattice, const Points& points)
    : lattice_(lattice), reduction_(reduce(lattice)) {
    if (points.cols() == 0) throw InvalidInput("there is no site; give at least one");
    if (points.cols() > kMostSites) throw InvalidInput("there are more than 2^28 sites");
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        if (!points.col(s).allFinite()) {
            throw InvalidInput("site " + std::to_string(s) +
                               " is not finite; give finite coordinates");
        }
    }
    if (!move_to(points)) {
        throw InvalidInput("a site lies more than 2^30 periods away; wrap it into the domain");
    }
    const auto [first, second] = duplicates();
    if (first >= 0) throw DuplicateSites(first, second);
}

Vec2 Sites::position(SiteId site) const {
    return reduction_.reduced.to_plane(coordinates_.col(site));
}

double Sites::spacing() const { return std::sqrt(lattice_.area() / n_sites()); }

bool Sites::move_to(const Points& points) {
    Points coordinates(2, points.cols());
    std::vector<Offset> wraps(static_cast<std::size_t>(points.cols()));
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        const Vec2 u = reduction_.reduced.to_lattice(points.col(s));
        if (!(u.cwiseAbs().maxCoeff() < kFarthestPeriod)) return false;
        const Wrapped u0 = wrap(u.x());
        const Wrapped u1 = wrap(u.y());
        coordinates.col(s) << u0.fraction, u1.fraction;
        wraps[static_cast<std::size_t>(s)] = {u0.whole, u1.whole};
    }
    coordinates_ = std::move(coordinates);
    wraps_ = std::move(wraps);
    return true;
}

std::pair<SiteId, SiteId> Sites::duplicates() const {
    std::vector<SiteId> order(static_cast<std::size_t>(n_sites()));
    std::iota(order.begin(), order.end(), 0);
    const auto key = [this](SiteId s) {
        return std::tuple(coordinates_(0, s), coordinates_(1, s), s);
    };
    std::sort(order.begin(), order.end(), [&](SiteId s, SiteId t) { return key(s) < key(t); });
    std::pair<SiteId, SiteId> found{-1, -1};
    for (std::size_t k = 1; k < order.size(); ++k) {
        const std::pair<SiteId, SiteId> pair{order[k - 1], order[k]};
        const bool same = coordinates_.col(pair.first) == coordinates_.col(pair.second);
        if (same && (found.first < 0 || pair < found)) found = pair;
    }
    return found;
}

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

}  // namespace pcvt
