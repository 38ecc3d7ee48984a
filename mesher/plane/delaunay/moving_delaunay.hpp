#pragma once

#include <memory>
#include <optional>
#include <span>

#include "mesher/base/workers.hpp"
#include "mesher/plane/delaunay/lawson_flips.hpp"
#include "mesher/plane/delaunay/site_moves.hpp"
#include "mesher/plane/delaunay/strip_triangulation.hpp"

namespace pcvt::plane {

/// The elements that a pass over all triangles could not certify.
struct Suspects {
    /// Triangles that are not certified to be counter-clockwise.
    std::vector<int> triangles;
    /// Halfedges opposite to an angle that is not certified to be acute. All other edges are
    /// locally Delaunay where the triangles are counter-clockwise.
    std::vector<int> halfedges;
};

/// The numbers of sites: in the order of the input, or column by column across the domain
/// (spatial_sort.hpp), so that neighbours have close numbers.
enum class Numbering { kAsGiven, kByColumns };

/// Statistics of a triangulation's builds and flips.
struct DelaunayCounts {
    /// Mirrors that the last build inserted; nullopt if strips sufficed.
    std::optional<int> n_mirrors;
    /// Flips after the first build.
    std::int64_t n_flips = 0;
    /// Builds after the first one.
    int n_rebuilds = 0;
};

/// The triangles changed by flips, for callers that cache data per triangle or site.
struct FlipLog {
    /// Identifies the log. A new log begins where more may have changed than a log records,
    /// including offsets, and where a log would become long.
    std::int64_t number = 0;
    /// Two triangles for each flip, in order.
    std::vector<int> triangles;
};

/// The periodic Delaunay triangulation of moving sites, maintained by flips.
///
/// The class renumbers the sites column by column, so that neighbours are close in memory.
/// Coordinates in the reduced basis are wrapped only when they leave [-1, 2), and remain multiples
/// of 2^-51: every difference that a predicate needs is exact. All lengths are in `unit()`, a power
/// of two near h, and in the *frame*: the plane rotated so that the reduced period vector a lies
/// along x.
///
/// `step()` moves the sites to a trial position, where the triangulation must be restored. Then
/// either `settle()` accepts the position, or `step_back()` returns to the old one, where the
/// triangulation must be restored as well before the next step.
///
/// Example usage (EnergyPass::evaluate restores the triangulation):
///
///     MovingDelaunay delaunay(sites);
///     EnergyPass pass(delaunay, workers);
///     pass.evaluate(energy);
///     const double before = energy.value;
///     if (delaunay.step(direction, t, workers)) {
///         const bool lower = pass.evaluate(energy) && energy.value < before;
///         lower ? delaunay.settle() : delaunay.step_back();  // evaluate after step_back
///     }
///
/// Laws, tested by number:
///   (1) Once restored, every triangle is counter-clockwise and every edge locally Delaunay. Exact;
///       together the two prove the global periodic Delaunay property.
///   (2) Once restored, the triangulation equals that of a new build, except for ties.
class MovingDelaunay {
   public:
    static constexpr int kDimension = 2;
    /// The numbers in a direction for each site: x, y.
    static constexpr int kNumbersPerSite = 2;
    /// Whether a step may begin where the triangulation is not restored.
    static constexpr bool kStepsUnrestored = false;

    /// Builds from strips, or where these fail from mirrors. Cost: about half of a plain Euclidean
    /// Delaunay triangulation of the sites.
    /// @param numbering  of original_id() and release(). All other functions number by columns.
    explicit MovingDelaunay(const Sites& sites, Numbering numbering = Numbering::kAsGiven);

    /// Ties the moves of sites to those of representatives in all later steps.
    /// @param ties  one for each site, numbered as in this object.
    void tie_moves(std::vector<MoveTie> ties);

    int n_sites() const { return static_cast<int>(order_.size()); }
    /// The id of the site in the constructor's argument; `site` itself for kByColumns.
    SiteId original_id(SiteId site) const { return order_[site]; }
    /// 2 x n, reduced basis, in [-1.5, 2.5).
    const Points& coordinates() const { return coordinates_; }
    const TorusTriangulation& triangulation() const { return triangulation_; }
    /// The Gram matrix of the predicates, and its unit of length, length units.
    const Gram& gram() const { return gram_; }
    double gram_unit() const { return pcvt::plane::gram_unit(reduction_.reduced); }
    const DelaunayCounts& counts() const { return counts_; }
    const FlipLog& flip_log() const { return flip_log_; }
    /// Length units.
    double unit() const { return unit_; }
    /// h in units.
    double spacing() const { return spacing_; }
    /// The frame, in units.
    const ReducedFrame& frame() const { return frame_; }

    /// Moves the sites by t times `direction` (x, y, x, y, ...; frame, units). Does not restore the
    /// triangulation.
    /// @pre the direction lives and stays unchanged until the sites are settled and the
    ///         triangulation is restored there.
    /// @returns false if a move is not finite; no site has moved then.
    bool step(const Eigen::VectorXf& direction, double t, Workers& workers);
    bool step(Eigen::VectorXf&& direction, double t, Workers& workers) = delete;
    /// Moves the sites back to their positions before the last step. Does not restore the
    /// triangulation.
    void step_back();
    /// Accepts the current positions.
    void settle() { settled_ = true; }
    bool settled() const { return settled_; }

    /// Takes over the positions of some sites, and the flips, of a part in which they moved
    /// (delaunay_patch.hpp). Flips outside of the part may remain to be done.
    /// @pre settled, and restored or changed only by other parts.
    /// @param coordinates  a column for each of `sites`, and perhaps more.
    /// @param flips        the halfedges that were flipped, in order.
    void adopt(std::span<const SiteId> sites, const Points& coordinates,
               std::span<const int> flips);

    /// See lawson_flips.hpp.
    bool is_certainly_delaunay(int h) const {
        return pcvt::plane::is_certainly_delaunay(triangulation_, coordinates_, gram_, h);
    }
    /// The triangles among `suspects.triangles` that are not counter-clockwise.
    std::vector<int> inverted(const Suspects& suspects) const;
    /// Restores law (1) by flips; no triangle may be inverted. Empties suspects.halfedges.
    /// @returns the number of flips.
    std::int64_t flip(Suspects& suspects, FlipObserver* observer);
    /// Restores law (1) where triangles are inverted: by a local repair, or by a new build if the
    /// repair concerns more than 2 in 100 sites or gets stuck.
    /// @returns false if two sites coincide: the only valid next call is then step_back.
    bool untangle(const std::vector<int>& inverted, Suspects& suspects);

    /// The current positions of the sites, in the constructor's `numbering`: those that release()
    /// gives. 2 x n, length units. Cost: of order n.
    Points positions() const;

    /// Returns the sites, in the constructor's `numbering`, and their triangulation. The object
    /// must not be used afterwards.
    std::pair<Sites, TorusTriangulation> release();

   private:
    void build(const SpatialSort& columns);
    void prefer_huge_pages();
    bool rebuild();
    void keep_in_range();
    /// The sites in the constructor's `numbering`.
    Sites released_sites() const;
    void begin_flip_log();
    Sites wrapped_sites() const { return {lattice_, reduction_, coordinates_}; }

    Lattice lattice_;
    Reduction reduction_;
    Gram gram_;
    double unit_;
    double spacing_;
    ReducedFrame frame_;
    /// order_[s] is the caller's id of site s.
    std::vector<SiteId> order_;
    Points coordinates_;
    /// The moves since the triangulation was last restored.
    std::optional<SiteMoves> moves_;
    /// Shared, because `moves_` refers to them. Null: no site is tied.
    std::shared_ptr<const std::vector<MoveTie>> ties_;
    TorusTriangulation triangulation_;
    bool prefers_huge_pages_ = false;
    bool settled_ = true;
    DelaunayCounts counts_;
    FlipLog flip_log_;
};

/// @pre the triangulation is restored.
/// @throws DuplicateSites naming two sites, by their original ids, that are nearer to each other
///         than kSameVertex h (sites.hpp).
void require_distinct(const MovingDelaunay& delaunay);

}  // namespace pcvt::plane
