#pragma once

#include <cstdint>
#include <optional>

namespace pcvt {

/// Whether a stationary point is a minimum, according to its Hessian. Apart from the translations,
/// all eigenvalues are above a millionth of the largest (`kYes`), some are below minus that
/// threshold (`kNo`), or neither holds (`kUnknown`).
enum class Minimum { kYes, kNo, kUnknown };

/// The eigenvalues that decide, relative to the largest.
inline constexpr double kCertainEigenvalue = 1e-6;

/// Returns "yes", "no" or "unknown".
const char* minimum_name(Minimum minimum);

/// The signs of the eigenvalues of the Hessian of F at a lattice, without the translations.
struct LatticeStability {
    Minimum minimum = Minimum::kUnknown;
    /// The smallest eigenvalue over the largest; `nullopt` for n = 1, where only the translations
    /// exist.
    std::optional<double> smallest = {};
};

/// Decides by the extreme eigenvalues.
///
/// Example usage:
///     const LatticeStability stability = decided_stability(-0.2, 3);
///     std::cout << "minimum: " << minimum_name(stability.minimum) << '\n';  // no
///
/// @pre largest > 0.
LatticeStability decided_stability(double smallest, double largest);

/// 1 - cos(2 pi k / n): the factor of a bond in the Hessian on a plane wave whose phase changes by
/// k n-ths of a turn along the bond.
double one_minus_cosine(std::int64_t k, int n);

}  // namespace pcvt
