#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// Names one lattice among all that contain the period lattice with index n = a d, 0 <= b < a: in
/// coordinates of the reduced period vectors it is spanned by (d, -b) / n and (0, a) / n.
struct HermiteForm {
    int a = 1;
    int b = 0;
    int d = 1;

    int index() const { return a * d; }
    friend constexpr auto operator<=>(const HermiteForm&, const HermiteForm&) = default;
};

/// n sites that form a lattice themselves: a periodic CVT of n congruent cells, each of them the
/// Voronoi cell of that lattice.
///
/// Laws, tested by number:
///   (1) The basis is Gauss-reduced and spans, in integers, the period vectors.
///   (2) The energy is that of compute_cvt at the sites, whose residual is zero, up to rounding.
struct LatticePattern {
    /// As it was given.
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

/// The one that `form` names. @throws InvalidInput unless a, d >= 1 and 0 <= b < a.
LatticePattern lattice_pattern(const Lattice& period, const HermiteForm& form);

/// The `count` lowest energies that occur among the lattices of index n, or all if they are fewer,
/// from the lowest on, each with one lattice. Energies within 1e-12 of each other, relatively,
/// count as equal (mirror images); of equal ones the lattice with the smallest a is taken, then the
/// smallest b. Looks at all lattices, the sum of the divisors of n.
/// @throws InvalidInput if n < 1 or the period lattice cannot be reduced.
std::vector<LatticePattern> best_lattices(const Lattice& period, int n, int count);

/// The first of them.
LatticePattern best_lattice(const Lattice& period, int n);

/// The sites: 2 x n, length units, the first one at the origin.
Points pattern_points(const LatticePattern& pattern);

/// The column of pattern_points in which an image of the site stands that (i, j), in n-ths of the
/// reduced period vectors, leads to. @pre (i, j) is a vector of the lattice.
int pattern_site(const HermiteForm& form, std::int64_t i, std::int64_t j);

}  // namespace pcvt
