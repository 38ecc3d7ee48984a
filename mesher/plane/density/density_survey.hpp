#pragma once

#include <cstdint>

#include "mesher/plane/density/density.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {

/// Points along each direction that suffice for a density's scale.
inline constexpr int kSurveyResolution = 256;

/// Samples of a density on a grid over the domain, and estimates from them that need no cells.
///
/// Example usage:
///
///     DensitySurvey survey(lattice, density, kSurveyResolution);
///     const Points points = survey.draw(1000, 1);
///     const double contrast = survey.range().greatest / survey.range().least;
class DensitySurvey {
   public:
    /// Evaluates the points (i, j) / resolution of the domain, including the seam.
    /// @throws BadDensity naming the point, or for the contrast.
    DensitySurvey(const Lattice& lattice, const Density& density, int resolution);

    const DensityRange& range() const { return range_; }
    /// A power of two near the mean of rho.
    double unit() const;
    /// The square of the mean of rho^(1/2): F of many optimal cells is F for rho = 1 times this
    /// factor.
    double mean_root_squared() const;

    /// The largest change of ln rho between neighbouring points of the grid over their distance,
    /// 1 / length.
    double steepest() const;

    /// Draws n sites from rho^(1/2), the site density that optimal cells tend to, by rejection
    /// under a majorant that is constant on each square of the grid. Where the grid misses a peak,
    /// fewer sites are drawn. The same seed gives the same sites on every machine.
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

/// Draws n sites from a survey with a resolution fit for n.
Points graded_points(const Lattice& lattice, const Density& density, int n, std::uint64_t seed);

/// The integral of rho over the domain, by product Gauss rules on a grid aligned with the break
/// lines; needs no cells.
double integral(const Lattice& lattice, const Density& density);

}  // namespace pcvt::plane
