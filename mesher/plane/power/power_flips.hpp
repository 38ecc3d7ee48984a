#pragma once

#include <Eigen/Core>
#include <optional>

#include "mesher/plane/delaunay/power_predicates.hpp"
#include "mesher/plane/delaunay/torus_triangulation.hpp"

namespace pcvt::plane {

/// Turns a triangulation of the torus into the regular triangulation of weighted sites, the dual of
/// their power diagram, by flips of edges (H. Edelsbrunner, N. Shah 1996, restricted to flips that
/// keep all sites).
///
/// With the heights |x|^2 - w, an edge is locally regular if the surface over its two triangles is
/// convex along it. If an edge between a and b is not locally regular and its quadrilateral is not
/// strictly convex at a, then a lies above the triangle of b and the two opposite corners: a is
/// *hidden*, it has no cell. While every site has a cell, flips therefore reach the regular
/// triangulation from any triangulation, and an edge at which they must stop names a hidden site.
///
/// Example usage:
///
///     TorusTriangulation regular = delaunay.triangulation();
///     PowerFlips flips(regular, delaunay.coordinates(), gram, weights);
///     if (const auto hidden = flips.run()) reject(*hidden);
///
/// Laws, tested by number:
///   (1) Without a hidden site, every triangle is counter-clockwise and every edge locally regular;
///       together the two prove the global property.
///   (2) A site that is named as hidden has no cell.
///   (3) With equal weights the result is a Delaunay triangulation.
class PowerFlips {
   public:
    /// @param triangulation  counter-clockwise; it, coordinates and weights must outlive this
    ///                       object.
    /// @param coordinates    2 x n, reduced basis.
    /// @param weights        of each site, units of `gram`.
    PowerFlips(TorusTriangulation& triangulation, const Points& coordinates, const Gram& gram,
               const Eigen::VectorXd& weights)
        : triangulation_(triangulation),
          coordinates_(coordinates),
          gram_(gram),
          weights_(weights) {}

    /// Whether the edge of h is locally regular; exact, and true where four corners lie on one
    /// plane.
    bool is_locally_regular(int h) const;

    /// Flips edges that are not locally regular until there is none.
    /// @returns a hidden site, if there is one; the triangulation is counter-clockwise, but not
    ///          regular then.
    std::optional<SiteId> run();

    /// The number of flips of all runs.
    std::int64_t n_flips() const { return n_flips_; }

   private:
    WeightedImage weighted_image(const Corner& corner) const {
        return {image(coordinates_, corner.site, corner.offset), weights_[corner.site]};
    }
    std::optional<SiteId> hidden_end(int h) const;
    std::optional<SiteId> flip_from(int first, std::vector<int>& stack);

    TorusTriangulation& triangulation_;
    const Points& coordinates_;
    Gram gram_;
    const Eigen::VectorXd& weights_;
    std::int64_t n_flips_ = 0;
};

}  // namespace pcvt::plane
