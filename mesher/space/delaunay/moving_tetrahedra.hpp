#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/space/delaunay/frame.hpp"
#include "mesher/space/delaunay/periodic_delaunay.hpp"
#include "mesher/space/delaunay/tetrahedra_flips.hpp"

namespace pcvt::space {

/// The elements that a pass over all tetrahedra could not certify.
struct Suspects {
    /// Tetrahedra that are not certified to be positively oriented.
    std::vector<int> tetrahedra;
    /// Facets that are not certified to be locally Delaunay; at least one side of each.
    std::vector<int> facets;

    bool empty() const { return tetrahedra.empty() && facets.empty(); }
};

/// The periodic Delaunay triangulation of moving sites in space, maintained by flips.
///
/// The class renumbers the sites along a Hilbert curve, and sorts the tetrahedra by their sites
/// when flips have scattered them, so that neighbours are close in memory. Coordinates in the
/// reduced basis are wrapped only when they leave [-1, 2), and remain multiples of 2^-50. All
/// lengths are in `unit()`, a power of two near h, and in the Frame.
///
/// `step()` moves the sites to a trial position, where the triangulation must be restored. Then
/// either `settle()` accepts the position, or `step_back()` returns to the old one, where the
/// triangulation must be restored as well before it is used. EnergyPass::evaluate restores it: a
/// pass over all tetrahedra finds the suspects, restore() or rebuild() repairs them, and certify()
/// ends.
///
/// Example usage:
///
///     MovingTetrahedra moving(sites);
///     EnergyPass pass(moving, workers);
///     Energy energy;
///     pass.evaluate(energy);
///     const double before = energy.value;
///     if (moving.step(direction, t, workers)) {
///         const bool lower = pass.evaluate(energy) && energy.value < before;
///         lower ? moving.settle() : moving.step_back();
///     }
///
/// Laws, tested by number:
///   (1) Once certified, every tetrahedron is positive and every facet locally Delaunay. Exact;
///       together the two prove the global periodic Delaunay property.
///   (2) Once certified, the triangulation equals that of a new build, ties included.
class MovingTetrahedra {
   public:
    static constexpr int kDimension = 3;
    /// The numbers in a direction for each site: x, y, z, and one that is ignored and is zero in
    /// gradients, so that a site is two whole pairs of variables (objective.hpp).
    static constexpr int kNumbersPerSite = 4;
    /// Whether a step may begin where the triangulation is not restored.
    static constexpr bool kStepsUnrestored = true;

    explicit MovingTetrahedra(const Sites& sites);

    /// The id of the site in the constructor's argument.
    SiteId original_id(SiteId site) const { return order_[site]; }
    int n_sites() const { return static_cast<int>(coordinates_.cols()); }
    /// 3 x n, reduced basis, in [-1, 2).
    const Points& coordinates() const { return coordinates_; }
    const TorusTetrahedra& tetrahedra() const { return tetrahedra_; }
    /// Length units.
    double unit() const { return unit_; }
    /// h in units.
    double spacing() const { return spacing_; }
    /// The frame, in units.
    const Frame& frame() const { return frame_; }
    /// Builds after the first one, and flips.
    int n_rebuilds() const { return n_rebuilds_; }
    std::int64_t n_flips() const { return n_flips_; }

    /// Moves the sites by t times `direction`, kNumbersPerSite numbers a site (frame, units).
    /// @returns false if a move is not finite or longer than two periods; no site has moved then.
    bool step(const Eigen::VectorXf& direction, double t, Workers& workers);
    /// Moves the sites back to their positions before the last step.
    void step_back();
    /// Accepts the current positions.
    void settle() { settled_ = true; }
    bool settled() const { return settled_; }

    /// The suspects that break law (1): all inverted tetrahedra; without these, all facets that are
    /// not locally Delaunay, else all facets that may not be.
    Suspects violations(Suspects suspects) const;
    /// Restores law (1) by flips where a facet is no longer Delaunay; where a tetrahedron is
    /// inverted, it untangles the triangulation (tetrahedra_untangling.hpp). Flips test all facets
    /// of the tetrahedra that they add, untangling also tests the facets around the sites that it
    /// moves, and the pass has certified all others.
    /// @param wrong  the violations.
    /// @returns the tetrahedra that the repair exchanged, or nullopt if the triangulation must be
    ///          built from scratch: too many facets may not be Delaunay, flips get stuck, or too
    ///          many sites would have to move back.
    std::optional<ExchangedTetrahedra> restore(Suspects wrong);
    /// Builds the triangulation from scratch.
    /// @returns false if two sites coincide: the only valid next call is then step_back.
    bool rebuild();
    /// Notes that law (1) holds at the current positions. It may renumber the tetrahedra.
    void certify();

    /// Returns the sites and their triangulation in the numbering of the constructor's argument.
    /// The object must not be used afterwards.
    PeriodicDelaunay release();
    /// The same with other tetrahedra of the sites at their positions.
    PeriodicDelaunay release(TorusTetrahedra tetrahedra);

   private:
    std::optional<ExchangedTetrahedra> flip(const std::vector<int>& facets);
    std::optional<ExchangedTetrahedra> untangle(const std::vector<int>& inverted,
                                                std::vector<int> facets);
    void keep_sorted();
    void keep_in_range();
    Sites wrapped_sites() const { return {lattice_, reduction_, coordinates_}; }

    Lattice lattice_;
    Reduction reduction_;
    Gram gram_;
    double unit_;
    double spacing_;
    Frame frame_;
    std::vector<SiteId> order_;
    Points coordinates_;
    /// The coordinates before the last step, with offsets that fit the tetrahedra.
    Points before_;
    /// The coordinates where the tetrahedra were positive last, with offsets that fit them; no
    /// columns if unknown.
    Points valid_;
    TorusTetrahedra tetrahedra_;
    bool settled_ = true;
    int n_rebuilds_ = 0;
    std::int64_t n_flips_ = 0;
    /// n_flips_ when the tetrahedra were sorted last.
    std::int64_t n_flips_sorted_ = 0;
};

}  // namespace pcvt::space
