#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// The rotation matrix of an orientation: it takes the components of a vector along the axes of the
/// sample to those along the axes of the crystal, so its rows are the axes of the crystal in those
/// of the sample (Bunge 1982). Laws, tested by number:
///   (1) The rows are orthonormal and right-handed, to 1e-15.
///   (2) It is the product of the three turns, about z, x and z.
///
/// Example usage:
///
///     const Eigen::Vector3d axis = bunge_matrix({45, 0, 0}).row(0);  // (1, 1, 0) / sqrt(2)
Eigen::Matrix3d bunge_matrix(const BungeAngles& angles);

/// Draws n orientations without a texture: phi1 and phi2 in [0, 360), Phi in (0, 180) with a
/// uniform cosine, degrees. The same seed gives the same bits on every machine.
std::vector<BungeAngles> random_orientations(int n, std::uint64_t seed);

/// Sums of weights up to this are numbers.
inline constexpr double kLargestEntryWeight = 1e150;

/// Draws the entries of a list of orientations for n cells, in random order: entry k is drawn
/// n w_k / (sum of w) times on average, and never a whole time more or less, w the weights. So a
/// list of equal weights that is longer than n gives different entries.
/// @param weights  one an entry, from 0 to kLargestEntryWeight, not all 0.
/// @returns        n indices from 0; the same seed gives the same ones on every machine.
std::vector<int> draw_entries(std::span<const double> weights, int n, std::uint64_t seed);

/// The least and the greatest of each angle.
struct AngleRange {
    BungeAngles least;
    BungeAngles greatest;
};
/// @pre there is an orientation.
AngleRange angle_range(std::span<const BungeAngles> orientations);

}  // namespace pcvt
