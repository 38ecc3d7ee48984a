#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesher/plane/symmetry/plane_group.hpp"

namespace pcvt::plane {

/// Places in the reduced basis are multiples of a twelfth of a period here.
inline constexpr int kTwelfths = 12;

/// An orbit of centres of rotation.
struct RotationCentre {
    /// In twelfths of a period, 0 ... 11.
    std::array<int, 2> place;
    /// A turn by 1 / order of a full turn leaves the place fixed: 2, 3, 4 or 6.
    int order;
    /// Centres of the orbit in one period.
    int n_sites;
};

/// An orbit of mirror lines.
struct MirrorLine {
    /// A point on one line, in twelfths of a period, multiples of 3.
    std::array<int, 2> through;
    /// The shortest period along it, in the reduced basis.
    std::array<int, 2> along;
    /// Sites of the orbit of a point on it: half the order of the group.
    int n_sites;
};

/// The places of a group whose orbits are smaller than its order.
///
/// Example usage:
///
///     const SpecialPositions special = special_positions(group);
///     const OrbitPlan plan = distribute(group, special, 242);  // two sites on 4-fold centres
struct SpecialPositions {
    /// By descending order of rotation, then by ascending numbers of sites.
    std::vector<RotationCentre> centres;
    std::vector<MirrorLine> mirrors;
};

/// Derives the special positions from the operations.
SpecialPositions special_positions(const PlaneGroup& group);

/// How many orbits lie where.
struct OrbitPlan {
    int n_general = 0;
    /// For each of SpecialPositions::mirrors.
    std::vector<int> on_mirrors;
    /// Whether each of SpecialPositions::centres is occupied.
    std::vector<bool> at_centres;
};

/// The number of sites of a plan.
int n_sites(const PlaneGroup& group, const SpecialPositions& special, const OrbitPlan& plan);

/// Distributes the n sites of one period over orbits: general positions if n is a multiple of the
/// order of the group. Otherwise it occupies centres, those of the highest order first and as few
/// as possible, and if these do not suffice a mirror too.
/// @throws InvalidInput  naming the nearest numbers, if no sum of orbits is n.
OrbitPlan distribute(const PlaneGroup& group, const SpecialPositions& special, int n);

}  // namespace pcvt::plane
