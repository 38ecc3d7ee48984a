#pragma once

#include <Eigen/Core>

#include "mesher/plane/delaunay/power_predicates.hpp"
#include "mesher/plane/delaunay/torus_triangulation.hpp"

namespace pcvt::plane {

/// The periodic Delaunay triangulation of fixed sites, or, of sites with weights, their regular
/// triangulation, the dual of the power diagram in which cell i is where |p - x_i|^2 - w_i is
/// least.
///
/// Example usage:
///
///     const PeriodicDelaunay delaunay(sites);
///     const TorusTriangulation& t = delaunay.triangulation();
///     for (int h = 0; h < t.n_halfedges(); ++h) visit(t.corner(h), t.edge_offset(h));
///
/// Law, tested by number:
///   (1) Every triangle is counter-clockwise and every edge locally Delaunay (with weights: locally
///       regular), exactly. Together the two prove the global property.
class PeriodicDelaunay {
   public:
    /// Builds the triangulation.
    explicit PeriodicDelaunay(const Sites& sites);
    /// Takes a triangulation of the sites, with offsets in the frame of their coordinates.
    /// @throws InternalError naming the triangle or edge that violates law (1).
    PeriodicDelaunay(Sites sites, TorusTriangulation triangulation);
    /// Takes the regular triangulation of sites with weights, length^2.
    PeriodicDelaunay(Sites sites, TorusTriangulation triangulation, Eigen::VectorXd weights);

    const Sites& sites() const { return sites_; }
    const TorusTriangulation& triangulation() const { return triangulation_; }
    const Gram& gram() const { return gram_; }
    /// The weight of each site, length^2; empty without weights.
    const Eigen::VectorXd& weights() const { return weights_; }

    /// The centre of a triangle's power circle, which is a corner of three cells, in the triangle's
    /// frame: the circumcentre without weights. Length units.
    Vec2 dual_vertex(int triangle) const;

   private:
    WeightedImage weighted_image(const Corner& corner) const;
    bool is_locally_regular(int h) const;
    void certify();

    Sites sites_;
    TorusTriangulation triangulation_;
    Gram gram_;
    Eigen::VectorXd weights_;
    /// The factor from length^2 to units of the Gram matrix, a power of two.
    double gram_weight_ = 1;
};

}  // namespace pcvt::plane
