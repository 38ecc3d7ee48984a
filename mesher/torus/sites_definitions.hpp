#pragma once

// The definitions of sites.hpp, for the two files that instantiate them.

#include <bit>
#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "mesher/base/error.hpp"
#include "mesher/torus/sites.hpp"

namespace pcvt {

template <class Lattice>
typename Lattice::Offset Reduction<Lattice>::to_original(typename Lattice::Offset offset) const {
    constexpr int kDimension = Lattice::kDimension;
    std::array<int, kDimension> original{};
    const auto in_reduced = offset.components();
    for (int k = 0; k < kDimension; ++k) {
        for (int r = 0; r < kDimension; ++r) original[k] += in_reduced[r] * m[kDimension * r + k];
    }
    return Lattice::Offset::of(original);
}

template <class Lattice>
Sites<Lattice>::Sites(const Lattice& lattice, const Points& points)
    : lattice_(lattice),
      reduction_(reduce(lattice)),
      coordinates_(Lattice::kDimension, points.cols()) {
    if (points.cols() == 0) throw InvalidInput("no sites are given; give at least one");
    if (points.cols() > Lattice::kMostSites) {
        constexpr int kBits = std::bit_width(unsigned{Lattice::kMostSites}) - 1;
        throw InvalidInput("there are more than 2^" + std::to_string(kBits) + " sites");
    }
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        if (!points.col(s).allFinite()) {
            throw InvalidInput("site " + std::to_string(s) +
                               " is not finite; give finite coordinates");
        }
        const Point u = reduction_.reduced.to_lattice(points.col(s));
        if (!(u.cwiseAbs().maxCoeff() < kFarthestPeriod)) {
            throw InvalidInput("site " + std::to_string(s) +
                               " lies more than 2^30 periods away; wrap it into the domain");
        }
        coordinates_.col(s) = Lattice::wrapped(u);
    }
    const auto [first, second] = duplicates();
    if (first >= 0) throw DuplicateSites(first, second);
}

template <class Lattice>
Sites<Lattice>::Sites(const Lattice& lattice, const Reduction<Lattice>& reduction,
                      Points coordinates)
    : lattice_(lattice), reduction_(reduction), coordinates_(std::move(coordinates)) {
    for (Eigen::Index s = 0; s < coordinates_.cols(); ++s) {
        coordinates_.col(s) = Lattice::wrapped(coordinates_.col(s));
    }
}

template <class Lattice>
typename Sites<Lattice>::Point Sites<Lattice>::position(SiteId site) const {
    return reduction_.reduced.to_position(coordinates_.col(site));
}

template <class Lattice>
typename Sites<Lattice>::Points Sites<Lattice>::positions() const {
    Points positions(Lattice::kDimension, n_sites());
    for (SiteId s = 0; s < n_sites(); ++s) positions.col(s) = position(s);
    return positions;
}

template <class Lattice>
typename Lattice::Points uniform_points(const Lattice& lattice, int n, std::uint64_t seed) {
    if (n < 1) throw InvalidInput("the number of sites must be at least 1");
    std::mt19937_64 generator(seed);
    typename Lattice::Points points(Lattice::kDimension, n);
    for (int s = 0; s < n; ++s) {
        typename Lattice::Point u;
        for (double& part : u) part = std::ldexp(double(generator() >> 11), -53);
        points.col(s) = lattice.to_position(u);
    }
    return points;
}

}  // namespace pcvt
