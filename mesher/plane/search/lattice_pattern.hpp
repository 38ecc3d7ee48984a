#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/plane/geometry/metric.hpp"

namespace pcvt::plane {

/// Identifies one lattice among all that contain the period lattice with index n = a d, where 0 <=
/// b < a. In coordinates of the reduced period vectors (d, -b) / n and (0, a) / n span it.
struct HermiteForm {
    int a = 1;
    int b = 0;
    int d = 1;

    int index() const { return a * d; }
    friend constexpr auto operator<=>(const HermiteForm&, const HermiteForm&) = default;
};

/// A periodic CVT whose n sites form a lattice. Its n cells are congruent: each is a Voronoi cell
/// of that lattice.
///
/// Example usage:
///   const LatticePattern pattern = best_lattice(Lattice::rectangle(1, 1), 30);
///   const double excess = pattern.energy / pattern.energy_bound - 1;
///   const Points sites = pattern_points(pattern);
///
/// Laws, tested by number:
///   (1) The basis is Gauss-reduced, and the period vectors are integer combinations of it.
///   (2) compute_cvt finds the same energy at the sites and a residual of zero, up to rounding.
struct LatticePattern {
    /// The period vectors as given by the caller.
    Lattice period;
    HermiteForm form;
    /// Right-handed and Gauss-reduced, length units.
    Lattice basis;
    /// basis.a() and basis.b() in n-ths of the reduced period vectors.
    std::array<Offset, 2> steps;
    /// F, and 5 A^2 / (18 sqrt(3) n), the hexagonal lower bound; length^4.
    double energy;
    double energy_bound;

    int n_sites() const { return form.index(); }
};

/// Returns the lattice with the given form.
/// @throws InvalidInput unless a, d >= 1 and 0 <= b < a.
LatticePattern lattice_pattern(const Lattice& period, const HermiteForm& form);

/// Returns one lattice of index n for each of the `count` lowest energies, or for each energy if
/// fewer occur, sorted by energy. Energies that agree to a relative 1e-12 count as equal (mirror
/// images); of lattices with equal energies the one with the smallest a is returned, then with the
/// smallest b. Cost: one evaluation per lattice; their number is the sum of the divisors of n.
/// @throws InvalidInput if n < 1 or the period lattice cannot be reduced.
std::vector<LatticePattern> best_lattices(const Lattice& period, int n, int count);

/// Returns the first lattice of best_lattices.
LatticePattern best_lattice(const Lattice& period, int n);

/// Returns the sites: 2 x n, length units, the first one at the origin.
Points pattern_points(const LatticePattern& pattern);

/// Returns the column of pattern_points whose site has an image at (i, j), in n-ths of the reduced
/// period vectors.
/// @pre (i, j) is a vector of the lattice.
int pattern_site(const HermiteForm& form, std::int64_t i, std::int64_t j);

/// Maps the periods and the basis of a pattern in the round space of a metric back to the plane.
void map_back(const Metric& metric, LatticePattern& pattern);

}  // namespace pcvt::plane
