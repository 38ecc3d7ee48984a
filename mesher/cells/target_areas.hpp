#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>

namespace pcvt {

/// The distribution of the equivalent diameters of cells, 2 sqrt(area / pi) or (6 volume /
/// pi)^(1/3).
struct AreaLaw {
    enum class Kind { kEqual, kLognormal, kGamma };
    Kind kind = Kind::kEqual;
    /// Standard deviation over mean of the equivalent diameter; not used for kEqual.
    double spread = 0;

    friend bool operator==(const AreaLaw&, const AreaLaw&) = default;
};

/// An area below this share of the mean is refused: rounding would exceed the tolerance of its
/// error.
inline constexpr double kLeastArea = 1e-6;
/// The largest spread of a law.
inline constexpr double kMostSpread = 2;

/// Whether the text names a law, that is begins with the word of one, rather than a file.
bool names_area_law(const std::string& text);

/// Reads `equal`, `lognormal:S` or `gamma:S`.
///
/// Example usage:
///
///     const AreaLaw law = parse_area_law("lognormal:0.42");
///     const Eigen::VectorXd areas = scaled_areas(draw_areas(law, n, seed), n, lattice.area());
///
/// @throws InvalidInput for another text, or unless 0 < S <= kMostSpread.
AreaLaw parse_area_law(const std::string& text);

/// Draws n areas, in any unit. The same seed gives the same bits on every machine, independent of
/// the points that uniform_points draws from the same seed.
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
