#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "mesher/cvt/run_options.hpp"
#include "mesher/optimize/level_share.hpp"

namespace pcvt {

/// The RMS residual at which a coarser problem is left for the next one.
inline constexpr double kCoarseTolerance = 1e-4;

/// The longest random move of a coordinate between two levels, in units of h of the finer one.
/// Without it, sites stay at their initial positions even where their neighbourhood is a poor one.
inline constexpr double kShake = 0.25;

/// The random numbers between -1 and 1 that shake the sites of a level.
class Shakes {
   public:
    explicit Shakes(std::uint64_t seed) : generator_(seed) {}
    double next() { return std::ldexp(double(generator_() >> 11), -52) - 1; }

   private:
    std::mt19937_64 generator_;
};

/// How the levels of a coarse start grow. The constants differ between the plane and space.
struct LevelGrowth {
    /// The energy of n sites is in proportion to n^(-2 / dimension): 2 or 3.
    int dimension;
    /// The factor by which the number of orbits grows from one level to the next.
    double factor;
    /// Levels with at most this number of orbits are not coarsened further.
    int coarsest;
    /// The finest level included.
    int most_levels = std::numeric_limits<int>::max();
};

/// The number of sites on each level of a coarse start.
struct LevelSizes {
    /// Orbits of the finest level whose number grows from one level to the next. Sites without
    /// symmetry are orbits of one site.
    int n_orbits = 0;
    int orbit_size = 1;
    /// Other sites, the same on all levels.
    int n_others = 0;

    double n_sites(int orbits) const { return double(orbits) * orbit_size + n_others; }
};

/// The levels of a coarse start but the finest, from coarse to fine.
///
/// Example usage:
///
///     CoarseLevels levels(growth, {.n_orbits = n}, seed, {.n_threads = 2});
///     Points points = uniform_points(lattice, levels.n_coarsest(), seed);
///     while (levels.next()) {
///         const CvtResult result = compute_cvt(lattice, points, {levels.run()});
///         if (levels.cancelled()) return {};
///         points = refined(result, levels.n_finer(), levels.seed());
///     }
class CoarseLevels {
   public:
    /// @param run  the threads, and the callback, which is called once per iteration of the coarser
    ///             problems, with energies scaled to n sites and the share of the work of all these
    ///             problems that is done; returning false cancels.
    CoarseLevels(const LevelGrowth& growth, const LevelSizes& sizes, std::uint64_t seed,
                 RunOptions run);
    CoarseLevels(const CoarseLevels&) = delete;
    CoarseLevels& operator=(const CoarseLevels&) = delete;

    /// The number of orbits on the coarsest level.
    int n_coarsest() const { return orbits_.front(); }

    /// Goes to the next level, at first to the coarsest one; false if that is the finest.
    bool next();

    /// The options of the run on this level, which ends at kCoarseTolerance; it reports to the
    /// callback, for which energies are scaled to the finest level. Valid until next().
    RunOptions run();
    /// Whether the callback cancelled the start.
    bool cancelled() const { return cancelled_; }

    /// The number of orbits on the next level, and the seed for refining the sites of this one.
    int n_finer() const { return orbits_[level_ + 1]; }
    std::uint64_t seed() const { return seed_ + static_cast<std::uint64_t>(n_finer()); }

   private:
    /// The factor that turns an energy of this level into one of the finest.
    double energy_scale() const;

    LevelGrowth growth_;
    LevelSizes sizes_;
    std::uint64_t seed_;
    RunOptions run_;
    /// The numbers of orbits of all levels, the coarsest first.
    std::vector<int> orbits_;
    LevelShare done_;
    int level_ = -1;
    bool cancelled_ = false;
};

}  // namespace pcvt
