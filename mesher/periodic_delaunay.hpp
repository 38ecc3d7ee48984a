#pragma once

#include "mesher/predicates.hpp"
#include "mesher/torus_triangulation.hpp"

namespace pcvt {

/// The periodic Delaunay triangulation of moving sites.
///
/// Laws, tested by number:
///   (1) Every triangle is counter-clockwise and every edge locally Delaunay, exactly. Together the
///       two prove the global periodic Delaunay property.
///   (2) After any move the triangulation is that of a fresh build, but for ties.
class PeriodicDelaunay {
   public:
    /// Builds the triangulation from the mirror diagram.
    /// @throws InternalError if law (1) fails.
    explicit PeriodicDelaunay(Sites sites);

    const Sites& sites() const { return sites_; }
    const TorusTriangulation& triangulation() const { return triangulation_; }
    const Gram& gram() const { return gram_; }

    /// Moves the sites (2 x n, length units, any distance) and restores law (1): by flips where no
    /// triangle turned over, else by a new build.
    /// @returns false where the points are not finite, too far away, or two of them coincide; the
    ///          object then only waits for the next move.
    bool move_to(const Points& points);

    /// @throws InternalError naming the triangle or edge that breaks law (1).
    void certify() const;

    /// Mirrors that the last build inserted.
    int n_mirrors() const { return n_mirrors_; }
    std::int64_t n_flips() const { return n_flips_; }
    /// Builds after the first one.
    int n_rebuilds() const { return n_rebuilds_; }

   private:
    void build();
    Image corner_image(int h) const;
    bool all_counter_clockwise() const;
    bool locally_delaunay(int h) const;
    void flip_until_delaunay();

    Sites sites_;
    Gram gram_;
    TorusTriangulation triangulation_;
    int n_mirrors_ = 0;
    int n_rebuilds_ = 0;
    std::int64_t n_flips_ = 0;
};

}  // namespace pcvt
