#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>
#include <cstdint>

#include "mesher/space/search/obtuse_superbase.hpp"

namespace pcvt::space {

/// Identifies one lattice of space among all that contain the period lattice with index n = a d f,
/// where 0 <= b < d and 0 <= c, e < f. In coordinates of the reduced period vectors (d f, 0, 0) /
/// n,
/// (-b f, a f, 0) / n and (b e - c d, -a e, a d) / n span it.
struct HermiteForm {
    int a = 1;
    int d = 1;
    int f = 1;
    int b = 0;
    int c = 0;
    int e = 0;

    int index() const { return a * d * f; }
    friend constexpr auto operator<=>(const HermiteForm&, const HermiteForm&) = default;
};

/// The second moment of the cell of the body-centred cubic lattice, per dimension, for the volume
/// 1: 19 / (192 2^(1/3)), the least of all lattices (Barnes and Sloane, 1983).
inline constexpr double kBodyCentredMoment = 0.078543281217176533;

/// A periodic CVT of space whose n sites form a lattice, so that its n cells are congruent.
///
/// Example usage:
///   const LatticePattern pattern = best_lattice(Eigen::Matrix3d::Identity(), 54);
///   const double excess = pattern.moment / kBodyCentredMoment - 1;
///   const Eigen::Matrix3Xd sites = pattern_points(pattern);
///
/// Laws, tested by number:
///   (1) The basis and minus its sum are an obtuse superbase, and the period vectors are integer
///       combinations of the basis.
///   (2) The moment is that of the Voronoi cell of a site.
struct LatticePattern {
    /// The period vectors as given by the caller, one a column.
    Eigen::Matrix3d period;
    /// The reduced period vectors, to which the form refers.
    Eigen::Matrix3d reduced;
    HermiteForm form;
    /// Three vectors of an obtuse superbase, one a column, right-handed, length units.
    Eigen::Matrix3d basis;
    /// The same in n-ths of the reduced period vectors.
    std::array<LatticeVector, 3> steps;
    /// The dimensionless second moment per dimension, G = F n^(2/3) / (3 V^(5/3)).
    double moment;
    /// F, length^5.
    double energy;

    int n_sites() const { return form.index(); }
};

/// Returns the lattice with the given form.
/// @param period  independent period vectors of either orientation, one a column.
/// @throws InvalidInput unless a, d, f >= 1, 0 <= b < d and 0 <= c, e < f, or if the period vectors
///         are dependent.
LatticePattern lattice_pattern(const Eigen::Matrix3d& period, const HermiteForm& form);

/// Returns the lattice of index n that has the lowest energy. If energies agree to a relative
/// 1e-12, it returns the lattice with the smallest form. Cost: one evaluation for each of the sum
/// of d f^2 lattices, about n^2.
/// @throws InvalidInput if n < 1 or the period vectors are dependent.
/// @throws LimitExceeded if there are more than 10^9 lattices.
LatticePattern best_lattice(const Eigen::Matrix3d& period, int n);

/// Returns the sites: 3 x n, length units, the first one at the origin.
Eigen::Matrix3Xd pattern_points(const LatticePattern& pattern);

/// Returns F of n cells with the dimensionless second moment `moment` in the volume `volume`.
double energy_of_moment(double moment, double volume, int n);

}  // namespace pcvt::space
