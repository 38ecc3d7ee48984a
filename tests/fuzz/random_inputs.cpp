#include "tests/fuzz/random_inputs.hpp"

#include <cmath>
#include <utility>

#include "mesher/base/error.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::testing {
namespace {

constexpr double kShareOfFew = 0.6;
constexpr int kFewSites = 12;
constexpr int kMostSitesOfAJob = 2000;
constexpr double kUlp = 0x1p-51;

double uniform(std::mt19937_64& random) { return std::uniform_real_distribution<double>()(random); }

double power_of_ten(std::mt19937_64& random, double from, double to) {
    return std::pow(10, from + (to - from) * uniform(random));
}

plane::Vec2 turned(const plane::Vec2& p, double angle) {
    return {std::cos(angle) * p.x() - std::sin(angle) * p.y(),
            std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

NamedLattice any_lattice(std::mt19937_64& random) {
    const double x = uniform(random);
    const double y = uniform(random);
    const double thin = power_of_ten(random, 0, 3);
    const double angle = 7 * uniform(random);
    switch (random() % 9) {
        case 0:
            return {"unit", plane::Lattice::rectangle(1, 1)};
        case 1:
            return {"thin", x < 0.5 ? plane::Lattice::rectangle(1, thin)
                                    : plane::Lattice::rectangle(thin, 1)};
        case 2:
            return {"thin turned", {turned({1, 0}, angle), turned({x, thin}, angle)}};
        case 3:
            return {"oblique", {{1, 0}, {x, 0.3 + y}}};
        case 4:
            return {"skewed", {{1, 0}, {std::round(20 * x - 10) + y * y, 1}}};
        case 5:
            return {"hexagonal", {{1, 0}, {0.5, std::sqrt(0.75)}}};
        case 6:
            return {"scaled", {thin * plane::Vec2(1e-9, 0), thin * plane::Vec2(x * 1e-9, 1e-9)}};
        case 7:
            return {"scaled", {thin * plane::Vec2(1e7, 0), thin * plane::Vec2(0, (1 + x) * 1e7)}};
        default:
            return {"random", random_lattice(random)};
    }
}

int any_number(std::mt19937_64& random) {
    if (uniform(random) < kShareOfFew) return 1 + static_cast<int>(random() % kFewSites);
    return static_cast<int>(
        power_of_ten(random, std::log10(kFewSites + 1), std::log10(kMostSitesOfAJob)));
}

/// Lattice coordinates on a grid with a random number of columns; the last row may be incomplete.
plane::Points grid(std::mt19937_64& random, int n) {
    const int columns = 1 + static_cast<int>(random() % static_cast<unsigned>(n));
    const int rows = (n + columns - 1) / columns;
    plane::Points u(2, n);
    for (int s = 0; s < n; ++s) {
        u.col(s) << double(s % columns) / columns, double(s / columns) / rows;
    }
    return u;
}

plane::Points near_cocircular(std::mt19937_64& random, int n) {
    plane::Points u = grid(random, n);
    for (double& x : u.reshaped()) x += (double(random() % 3) - 1) * kUlp;
    return u;
}

plane::Points uniform_sites(std::mt19937_64& random, int n) {
    plane::Points u(2, n);
    for (double& x : u.reshaped()) x = uniform(random);
    return u;
}

plane::Points sites_on_the_seam(std::mt19937_64& random, int n) {
    plane::Points u = uniform_sites(random, n);
    for (int s = 0; s < n; ++s) {
        if (random() % 2 == 0) u(random() % 2, s) = random() % 2 == 0 ? 0 : 1 - kUlp;
    }
    return u;
}

plane::Points sites_on_a_line(std::mt19937_64& random, int n) {
    const plane::Points start = uniform_sites(random, 1);
    const auto i = static_cast<double>(random() % 3);
    const auto j = static_cast<double>(random() % 3);
    plane::Points u(2, n);
    for (int s = 0; s < n; ++s) u.col(s) = start + (s + 0.5) / n * plane::Vec2(i, j);
    return u;
}

plane::Points clusters(std::mt19937_64& random, int n) {
    const plane::Points centres = uniform_sites(random, 1 + static_cast<int>(random() % 4));
    std::normal_distribution<double> normal(0, power_of_ten(random, -7, -1));
    plane::Points u(2, n);
    for (double& x : u.reshaped()) x = normal(random);
    for (int s = 0; s < n; ++s) u.col(s) += centres.col(s % centres.cols());
    return u;
}

std::pair<std::string, plane::Points> any_sites(std::mt19937_64& random, int n) {
    switch (random() % 7) {
        case 0:
            return {"grid", grid(random, n)};
        case 1:
            return {"near-cocircular", near_cocircular(random, n)};
        case 2:
            return {"on the seam", sites_on_the_seam(random, n)};
        case 3:
            return {"on a line", sites_on_a_line(random, n)};
        case 4:
            return {"clustered", clusters(random, n)};
        default:
            return {"random", uniform_sites(random, n)};
    }
}

}  // namespace

Beginning any_beginning(std::mt19937_64& random) {
    for (;;) {
        const auto [lattice_kind, lattice] = any_lattice(random);
        auto [sites_kind, u] = any_sites(random, any_number(random));
        const plane::Reduction reduction = reduce(lattice);
        for (double& x : u.reshaped()) x = plane::wrap(x).fraction;
        plane::Sites sites(lattice, reduction, std::move(u));
        if (sites.duplicates().first < 0) return {lattice_kind, sites_kind, std::move(sites)};
    }
}

}  // namespace pcvt::testing
