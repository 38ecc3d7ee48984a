#pragma once

#include <Eigen/Core>
#include <optional>

#include "mesher/space/delaunay/power_predicates.hpp"
#include "mesher/space/delaunay/tetrahedra_flips.hpp"

namespace pcvt::space {

/// Turns a triangulation of the 3-torus into the regular triangulation of weighted sites, the dual
/// of their power diagram, by the flips of TetrahedraFlips, which keep all sites.
///
/// With the heights |x|^2 - w, a facet is locally regular if the surface over its two tetrahedra is
/// convex across it. Let a facet a b c with the opposite corners d and e not be locally regular,
/// and the line d e pass only one of its edges, a b, on the inner side. Then c lies inside of the
/// tetrahedron a b d e, or on its boundary, and above its hyperplane: c is *hidden*, it has no
/// cell.
///
/// A facet that is not locally regular may wait for flips of its neighbours. While every site has a
/// cell, flips can still get stuck in this way, which does not happen in the plane. They do not
/// where the weights change little: along a path of weights at which every site has a cell, only
/// the flips of this class occur (PowerDiagram::set_weights halves the way).
///
/// Example usage:
///
///     TorusTetrahedra regular = delaunay.tetrahedra;
///     PowerFlips flips(regular, delaunay.sites.coordinates(), gram, weights);
///     if (!flips.flip(flips.irregular_facets())) {
///         if (flips.hidden()) reject(*flips.hidden());
///     }
///
/// Laws, tested by number:
///   (1) Where flip() returns true, every tetrahedron is positive and every facet locally regular;
///       together the two prove the global property.
///   (2) A site that is named as hidden has no cell.
///   (3) With equal weights nothing of a Delaunay triangulation is flipped, ties included.
class PowerFlips final : public TetrahedraFlips {
   public:
    /// @param weights  of each site, units of `gram`, rounded (rounded_weight); must outlive this
    ///                 object.
    PowerFlips(TorusTetrahedra& tetrahedra, const Points& coordinates, const Gram& gram,
               const Eigen::VectorXd& weights)
        : TetrahedraFlips(tetrahedra, coordinates, gram), weights_(weights) {}

    /// Whether a facet is locally regular, with the one rule for ties; exact.
    bool is_locally_regular(int facet) const;
    /// The facets that are not, one side of each.
    std::vector<int> irregular_facets() const;
    /// A hidden site, at which the flips ended; the tetrahedra are positive, but not regular then.
    std::optional<SiteId> hidden() const { return hidden_; }

   private:
    bool stays(int facet) const override { return is_locally_regular(facet); }
    bool note_blocked(const std::array<Corner, 3>& triangle, int inner) override;
    WeightedImage weighted_image(const Corner& corner) const {
        return {image(coordinates(), corner), weights_[corner.site]};
    }

    const Eigen::VectorXd& weights_;
    std::optional<SiteId> hidden_;
};

}  // namespace pcvt::space
