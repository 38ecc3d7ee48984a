#pragma once

#include <array>
#include <functional>
#include <vector>

#include "mesher/space/space_predicates.hpp"

namespace pcvt {

/// All images of the sites of a torus, in boxes about h wide, for queries by distance.
///
/// Example usage:
///
///     const SiteGrid grid(sites);
///     const Corner3 nearest = grid.nearest(point, radius, [](const Corner3&) { return true; });
class SiteGrid {
   public:
    using Admits = std::function<bool(const Corner3&)>;

    /// The sites must outlive this object.
    explicit SiteGrid(const SpaceSites& sites);

    const Gram3& gram() const { return gram_; }
    /// By how much a ball of radius 1, in the unit of the Gram matrix, extends in each reduced
    /// coordinate.
    const Vec3& extent() const { return extent_; }
    /// The mean spacing h in the unit of the Gram matrix.
    double spacing() const { return spacing_; }

    /// The image nearest to a point among the admitted ones within `radius` of it (unit of the Gram
    /// matrix); of equally near ones always the same. Its site is -1 if there is none.
    /// @param point  coordinates of the reduced basis.
    Corner3 nearest(const Vec3& point, double radius, const Admits& admits) const;

   private:
    Corner3 nearest_in_boxes(const Vec3& point, double radius, const Admits& admits) const;

    const SpaceSites& sites_;
    Gram3 gram_;
    Vec3 extent_;
    double spacing_;
    std::array<int, 3> n_boxes_{};
    /// The members of box b are members_[begin_[b]] ... members_[begin_[b + 1] - 1].
    std::vector<int> begin_;
    std::vector<SiteId> members_;
};

}  // namespace pcvt
