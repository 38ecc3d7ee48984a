#pragma once

#include <cstdint>

#include "mesher/density/density.hpp"
#include "mesher/lattice/sites.hpp"

namespace pcvt {

/// Enough points along each direction to know a density's scale.
inline constexpr int kSurveyResolution = 256;

/// A density on a grid over the domain: what is known before there are cells.
class DensitySurvey {
   public:
    /// Looks at the points (i, j) / resolution of the domain, its seam among them.
    /// @throws BadDensity naming the place, or for the contrast.
    DensitySurvey(const Lattice& lattice, const Density& density, int resolution);

    const DensityRange& range() const { return range_; }
    /// A power of two near the mean.
    double unit() const;
    /// The square of the mean of rho^(1/2): F of many optimal cells is so many times that for
    /// rho = 1.
    double mean_root_squared() const;

    /// n sites drawn from rho^(1/2), the site density that optimal cells tend to: by rejection
    /// under a majorant that is constant on each square of the grid. Where the grid misses a peak,
    /// fewer sites lie on it. The same for the same seed on every machine.
    /// @returns 2 x n, length units.
    Points draw(int n, std::uint64_t seed);

   private:
    double majorant(int i, int j) const;

    Lattice lattice_;
    int resolution_;
    DensityProbe probe_;
    std::vector<double> rho_;
    DensityRange range_;
};

/// Sites drawn from a survey that is fine enough for n of them.
Points graded_points(const Lattice& lattice, const Density& density, int n, std::uint64_t seed);

/// The integral of rho over the domain, by product Gauss rules on a grid that keeps to the break
/// lines; without cells.
double integral(const Lattice& lattice, const Density& density);

}  // namespace pcvt
