#pragma once

#include <optional>

#include "mesher/base/workers.hpp"
#include "mesher/delaunay/lawson_flips.hpp"
#include "mesher/delaunay/site_moves.hpp"
#include "mesher/delaunay/strip_triangulation.hpp"

namespace pcvt {

/// What a look at every triangle could not certify.
struct Suspects {
    /// Triangles that are not certainly counter-clockwise.
    std::vector<int> triangles;
    /// Halfedges opposite to an angle that is not certainly acute: all other edges are locally
    /// Delaunay where the triangles are counter-clockwise.
    std::vector<int> halfedges;
};

/// What the triangulation went through.
struct DelaunayCounts {
    /// Mirrors that the last build inserted; nothing if it did without.
    std::optional<int> n_mirrors;
    /// Flips after the first build.
    std::int64_t n_flips = 0;
    /// Builds after the first one.
    int n_rebuilds = 0;
};

/// The triangles that flips have made, for those who keep something of each triangle.
struct FlipLog {
    /// Differs between logs. One begins where more may have changed than what a log tells, offsets
    /// among it, and where one would grow long.
    std::int64_t number = 0;
    /// Two for each flip, in order.
    std::vector<int> triangles;
};

/// The periodic Delaunay triangulation of moving sites, kept alive by flips.
///
/// It numbers the sites anew, column by column, so that neighbours lie near to each other in
/// memory. Their coordinates in the reduced basis are not wrapped before they leave [-1, 2), and
/// stay multiples of 2^-51: every difference that a predicate needs is exact. All lengths are told
/// in a unit, a power of two near h, and in the *frame*: the plane turned so that the reduced
/// period vector a lies along x.
///
/// A step leads to a trial place, where the triangulation must be restored. Then either `settle`
/// keeps it there, or `step_back` leads back, where it must be restored as well before the next
/// step. Laws, tested by number:
///   (1) Once restored, every triangle is counter-clockwise and every edge locally Delaunay. Exact;
///       together the two prove the global periodic Delaunay property.
///   (2) Once restored, the triangulation is that of a fresh build, but for ties.
class MovingDelaunay {
   public:
    /// Builds from strips, or where those fail from the mirrors. Cost: about half of a plain
    /// Euclidean Delaunay triangulation of the sites.
    explicit MovingDelaunay(const Sites& sites);

    int n_sites() const { return static_cast<int>(order_.size()); }
    /// The number that the site had in the constructor's sites.
    SiteId original_id(SiteId site) const { return order_[site]; }
    /// 2 x n, reduced basis, in [-1.5, 2.5).
    const Points& coordinates() const { return coordinates_; }
    const TorusTriangulation& triangulation() const { return triangulation_; }
    const DelaunayCounts& counts() const { return counts_; }
    const FlipLog& flip_log() const { return flip_log_; }
    /// Length units.
    double unit() const { return unit_; }
    /// h in units.
    double spacing() const { return spacing_; }
    /// With the unit of length.
    const ReducedFrame& frame() const { return frame_; }

    /// Moves the sites by t times `direction` (x, y, x, y, ...; frame, units) from where they
    /// are. The triangulation is not restored yet.
    /// @pre the direction lives, and stays as it is, until the sites are settled and the
    ///      triangulation is restored there.
    /// @returns false where a move is not finite; nothing has moved then.
    bool step(const Eigen::VectorXf& direction, double t, Workers& workers);
    bool step(Eigen::VectorXf&& direction, double t, Workers& workers) = delete;
    /// Moves back to where the sites were before the last step; not restored yet.
    void step_back();
    /// The sites stay where they are.
    void settle() { settled_ = true; }
    bool settled() const { return settled_; }

    /// See lawson_flips.hpp.
    bool is_certainly_delaunay(int h) const {
        return pcvt::is_certainly_delaunay(triangulation_, coordinates_, gram_, h);
    }
    /// Those of `suspects.triangles` that are not counter-clockwise.
    std::vector<int> inverted(const Suspects& suspects) const;
    /// Restores law (1) where no triangle is inverted: by flips. Empties suspects.halfedges.
    /// @returns the number of flips.
    std::int64_t flip(Suspects& suspects, FlipObserver* observer);
    /// Restores law (1) where some are: locally, or, where more than 2 in 100 sites are concerned
    /// or the local repair gets stuck, by a new build.
    /// @returns false where two sites coincide: the object then only waits for step_back.
    bool untangle(const std::vector<int>& inverted, Suspects& suspects);

    /// The sites, in the order of the constructor's, and their triangulation. Ends this object.
    std::pair<Sites, TorusTriangulation> release();

   private:
    void build(const SpatialSort& columns);
    void prefer_huge_pages();
    bool rebuild();
    void keep_in_range();
    void begin_flip_log();
    Sites wrapped_sites() const { return {lattice_, reduction_, coordinates_}; }

    Lattice lattice_;
    Reduction reduction_;
    Gram gram_;
    double unit_;
    double spacing_;
    ReducedFrame frame_;
    /// order_[s] is the caller's number of site s.
    std::vector<SiteId> order_;
    Points coordinates_;
    /// What led here from where the triangulation was restored last.
    std::optional<SiteMoves> moves_;
    TorusTriangulation triangulation_;
    bool prefers_huge_pages_ = false;
    bool settled_ = true;
    DelaunayCounts counts_;
    FlipLog flip_log_;
};

}  // namespace pcvt
