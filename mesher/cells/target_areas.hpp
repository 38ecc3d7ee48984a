#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

#include "mesher/cells/area_law.hpp"

namespace pcvt {

/// An area below this share of the mean is refused: rounding would exceed the tolerance of its
/// error.
inline constexpr double kLeastArea = 1e-6;

/// Draws n areas, in any unit. The same seed gives the same bits on every machine, independent of
/// the points that uniform_points draws from the same seed.
///
/// Of a mixture, the numbers of cells with each law are the shares of n, rounded so that they sum
/// to n; the seed decides which cells have which law.
Eigen::VectorXd draw_areas(const AreaLaw& law, int n, std::uint64_t seed);

/// The same for volumes: the equivalent diameters have the law.
Eigen::VectorXd draw_volumes(const AreaLaw& law, int n, std::uint64_t seed);

/// The areas of cells with these equivalent diameters, and their volumes.
Eigen::VectorXd areas_of_diameters(const Eigen::VectorXd& diameters);
Eigen::VectorXd volumes_of_diameters(const Eigen::VectorXd& diameters);

/// Scales areas to the sum `total`.
/// @throws InvalidInput naming the first area that is not a positive finite number or is below
///         kLeastArea times the mean, or if there are not n_sites areas.
Eigen::VectorXd scaled_areas(const Eigen::VectorXd& areas, int n_sites, double total);
/// The same for volumes.
Eigen::VectorXd scaled_volumes(const Eigen::VectorXd& volumes, int n_sites, double total);

/// The factor by which scaled_areas() multiplies areas; `nullopt` where it is not a positive finite
/// number.
std::optional<double> area_scale(const Eigen::VectorXd& areas, double total);

/// Standard deviation (of a population) over mean of the equivalent diameters of cells.
/// @param dimension  2: the sizes are areas; 3: volumes.
double diameter_spread(const Eigen::VectorXd& sizes, int dimension = 2);

}  // namespace pcvt
