#include "tests/support/random_space_sites.hpp"

#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "tests/support/random_numbers.hpp"
#include "tests/support/space_lattices.hpp"

namespace pcvt::testing {
namespace {

using Random = std::mt19937_64;

/// The integers from 1 to 300, each as likely as its share of the logarithm.
int number_of_sites(Random& random) {
    return int(std::floor(std::pow(301, random_number(random))));
}

struct NamedLattice {
    std::string name;
    space::Lattice lattice;
};

NamedLattice random_lattice(Random& random) {
    const int kind = random_integer(random, 0, 7);
    const space::Lattice oblique = random_space_lattice(random);
    const auto& [a, b, c] = oblique.periods();
    const auto side = [&] { return std::exp(2 * random_number(random) - 1); };
    switch (kind) {
        case 0:
            return {"cube", space::Lattice::box(1, 1, 1)};
        case 1: {
            const double x = side();
            const double y = side();
            return {"box", space::Lattice::box(x, y, side())};
        }
        case 2:
            return {"oblique lattice", oblique};
        case 3: {
            const int m = random_integer(random, -9, 9);
            return {"unreduced lattice", {a, b + m * a, c + (m + 3) * a - m * b}};
        }
        case 4:
            return {"left-handed lattice", {b, a, oblique.right_handed() ? c : space::Vec3(-c)}};
        case 5:
            return {"rod", space::Lattice::box(1, 1, 100)};
        case 6:
            return {"plate", space::Lattice::box(100, 1, 100)};
        default: {
            const auto all = space_lattices();
            const auto& close = all[all.size() - 1 - std::size_t(random_integer(random, 0, 2))];
            return {close.name + " lattice", close.lattice};
        }
    }
}

space::Points sites_in_cube(int n, Random& random) {
    return uniform_points(space::Lattice::box(1, 1, 1), n, random());
}

/// The points of a grid with random numbers of rows, in an order of their own.
space::Points grid(Random& random) {
    const int columns = random_integer(random, 1, 8);
    const int rows = random_integer(random, 1, 6);
    const int layers = random_integer(random, 1, 5);
    space::Points points(3, columns * rows * layers);
    for (Eigen::Index k = 0; k < points.cols(); ++k) {
        points.col(k) << double(k % columns) / columns, double(k / columns % rows) / rows,
            double(k / columns / rows) / layers;
    }
    return points;
}

/// Random points of which each coordinate lies on the seam with the probability 1/3.
space::Points on_the_seam(int n, Random& random) {
    space::Points points = sites_in_cube(n, random);
    for (double& x : points.reshaped()) {
        if (random_integer(random, 0, 2) == 0) x = 0;
    }
    return points;
}

/// Integer points of one sphere, all or some of them.
space::Points on_a_sphere(Random& random) {
    const int square = std::vector{1, 2, 3, 5, 6, 9, 14}[std::size_t(random_integer(random, 0, 6))];
    std::vector<space::Vec3> points;
    for (int o = 0; o < 729; ++o) {
        const space::Vec3 p(o / 81 - 4, o / 9 % 9 - 4, o % 9 - 4);
        if (p.squaredNorm() == square && random_integer(random, 0, 3) > 0) points.push_back(p / 16);
    }
    points.emplace_back(0.5, 0.5, 0.5);
    return Eigen::Map<const space::Points>(points.front().data(), 3, Eigen::Index(points.size()));
}

space::Points cubic(Random& random) {
    const auto kind = Cubic(random_integer(random, 0, 2));
    const int most = kind == Cubic::kSimple ? 6 : kind == Cubic::kBodyCentred ? 5 : 4;
    return cubic_points(kind, random_integer(random, 1, most));
}

struct NamedPoints {
    std::string name;
    space::Points coordinates;
};

/// Coordinates in the reduced basis, perhaps not distinct.
NamedPoints random_points(Random& random) {
    const int n = number_of_sites(random);
    space::Points points = sites_in_cube(n, random);
    // A build with a long row of sites is slow.
    const int few = std::min(n, 40);
    switch (random_integer(random, 0, 10)) {
        case 0:
            points.topRows(2).setConstant(0.25);
            return {"row", points.leftCols(few)};
        case 1:
            points.bottomRows(2) = points.row(0).replicate(2, 1);
            return {"diagonal", points.leftCols(few)};
        case 2:
            points.row(1).setConstant(0.125);
            return {"plane", points};
        case 3:
            points.row(2) = (points.row(2) * 4).array().floor() / 4;
            return {"planes", points};
        case 4:
            return {"grid", grid(random)};
        case 5:
            return {"points of a grid", (points * 8).array().floor() / 8};
        case 6:
            return {"cubic lattice", cubic(random)};
        case 7:
            return {"sphere", on_a_sphere(random)};
        case 8:
            return {"sites on the seam", on_the_seam(n, random)};
        case 9:
            points.leftCols((n + 1) / 2) /= 64;
            return {"cluster", points};
        default:
            return {"random sites", points};
    }
}

/// Rounds to multiples of 2^-50 in [0, 1) and leaves out points that coincide with earlier ones.
space::Points distinct(const space::Points& coordinates) {
    std::set<std::tuple<double, double, double>> known;
    space::Points kept(3, coordinates.cols());
    Eigen::Index n = 0;
    for (const auto& u : coordinates.colwise()) {
        const space::Vec3 at = space::wrap(u).fraction;
        if (known.emplace(at.x(), at.y(), at.z()).second) kept.col(n++) = at;
    }
    return kept.leftCols(n);
}

}  // namespace

RandomSpaceSites random_space_sites(Random& random) {
    const auto [lattice_name, lattice] = random_lattice(random);
    auto [name, coordinates] = random_points(random);
    if (random_integer(random, 0, 2) == 0) {
        name += " off by 2^-50";
        for (double& x : coordinates.reshaped()) x += random_integer(random, -1, 1) / space::kGrid;
    }
    if (random_integer(random, 0, 1) == 0) {
        name += ", moved";
        const space::Vec3 move(random_number(random), random_number(random), random_number(random));
        coordinates.colwise() += space::wrap(move).fraction;
    }
    const space::Sites sites(lattice, reduce(lattice), distinct(coordinates));
    return {std::to_string(sites.n_sites()) + " of " + name + " in a " + lattice_name, sites};
}

}  // namespace pcvt::testing
