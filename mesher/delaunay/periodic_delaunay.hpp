#pragma once

#include "mesher/delaunay/predicates.hpp"
#include "mesher/delaunay/torus_triangulation.hpp"

namespace pcvt {

/// The periodic Delaunay triangulation of fixed sites.
///
/// Example usage:
///
///     const PeriodicDelaunay delaunay(sites);
///     const TorusTriangulation& t = delaunay.triangulation();
///     for (int h = 0; h < t.n_halfedges(); ++h) visit(t.corner(h), t.edge_offset(h));
///
/// Law, tested by number:
///   (1) Every triangle is counter-clockwise and every edge locally Delaunay, exactly. Together the
///       two prove the global periodic Delaunay property.
class PeriodicDelaunay {
   public:
    /// Builds the triangulation.
    explicit PeriodicDelaunay(const Sites& sites);
    /// Takes a triangulation of the sites, with offsets in the frame of their coordinates.
    /// @throws InternalError naming the triangle or edge that violates law (1).
    PeriodicDelaunay(Sites sites, TorusTriangulation triangulation);

    const Sites& sites() const { return sites_; }
    const TorusTriangulation& triangulation() const { return triangulation_; }
    const Gram& gram() const { return gram_; }

   private:
    void certify();

    Sites sites_;
    TorusTriangulation triangulation_;
    Gram gram_;
};

}  // namespace pcvt
