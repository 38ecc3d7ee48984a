#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mesher/space/geometry/sites.hpp"

namespace pcvt::testing {

inline const space::Lattice kCube = space::Lattice::box(1, 1, 1);

struct NamedSpaceLattice {
    std::string name;
    space::Lattice lattice;
};

/// Cubic, thin, flat, tiny, huge, oblique, skewed, left-handed and close-packed lattices.
inline std::vector<NamedSpaceLattice> space_lattices() {
    return {{"cube", space::Lattice::box(1, 1, 1)},
            {"column", space::Lattice::box(1, 1, 20)},
            {"plate", space::Lattice::box(20, 1, 20)},
            {"needle", space::Lattice::box(1, 100, 1)},
            {"tiny", space::Lattice::box(0.001, 0.002, 0.001)},
            {"huge", space::Lattice::box(1e6, 1e6, 2e6)},
            {"oblique", space::Lattice({1, 0, 0}, {0.37, 0.81, 0}, {0.2, 0.4, 0.9})},
            {"skewed", space::Lattice({1, 0, 0}, {7, 1, 0}, {-3, 5, 1})},
            {"left-handed", space::Lattice({0.3, 1.1, 0}, {1, 0.2, 0}, {0.1, 0, 0.8})},
            {"body-centred", space::Lattice({-1, 1, 1}, {1, -1, 1}, {1, 1, -1})},
            {"face-centred", space::Lattice({0, 1, 1}, {1, 0, 1}, {1, 1, 0})},
            {"hexagonal", space::Lattice({1, 0, 0}, {0.5, std::sqrt(0.75), 0}, {0, 0, 1.6})}};
}

/// Three normally distributed vectors; the second and third are sometimes much longer or nearly
/// dependent on those before.
inline space::Lattice random_space_lattice(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const auto draw = [&] {
        const double x = normal(random);
        const double y = normal(random);
        return space::Vec3(x, y, normal(random));
    };
    const auto integer = [&] { return std::floor(2 * normal(random)); };
    for (;;) {
        const space::Vec3 a = draw();
        const space::Vec3 d = draw();
        const space::Vec3 e = draw();
        const double stretch = std::exp(normal(random));
        const double times = integer();
        const space::Vec3 b = stretch * d + times * a;
        const double first = integer();
        const double second = integer();
        const space::Vec3 c = std::exp(normal(random)) * e + first * a + second * b;
        if (std::abs(a.cross(d).dot(e)) > 0.01 * a.norm() * d.norm() * e.norm()) return {a, b, c};
    }
}

/// The points of cubic lattices with m cells along each side of the unit cube: the corners of the
/// cells, and of the body-centred lattice their middles, of the face-centred one the middles of
/// their facets.
enum class Cubic { kSimple, kBodyCentred, kFaceCentred };

inline space::Points cubic_points(Cubic kind, int m) {
    std::vector<space::Vec3> motif{{0, 0, 0}};
    if (kind == Cubic::kBodyCentred) motif.emplace_back(0.5, 0.5, 0.5);
    if (kind == Cubic::kFaceCentred) {
        motif.insert(motif.end(), {{0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}});
    }
    space::Points points(3, static_cast<Eigen::Index>(motif.size()) * m * m * m);
    Eigen::Index n = 0;
    for (int cell = 0; cell < m * m * m; ++cell) {
        for (const space::Vec3& at : motif) {
            points.col(n++) = (space::Vec3(cell / (m * m), cell / m % m, cell % m) + at) / m;
        }
    }
    return points;
}

}  // namespace pcvt::testing
