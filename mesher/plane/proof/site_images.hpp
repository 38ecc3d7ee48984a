#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// The images of the sites of a tile: site s lies at position(s) + every vector of the lattice of
/// its sites.
///
/// Example usage:
///   const SiteImages images(tile, site_positions(tile));
///   const Offset offset = images.nearest(site, middle);
///   const double distance = images.distance(middle, site, offset);
class SiteImages {
   public:
    /// @param positions  of the sites 0 ... n - 1.
    SiteImages(const Tile& tile, std::vector<Vec2> positions);

    int n_sites() const { return static_cast<int>(positions_.size()); }
    int copies() const { return columns_ * rows_; }
    /// The area of a cell, on average.
    double cell_area() const { return lattice_.area() / n_sites(); }
    Vec2 position(SiteId site, Offset offset) const {
        return positions_[site] + lattice_.translation(offset);
    }
    /// The distance of p from an image; with weights that in space, where the image lies above the
    /// plane by the root of the largest weight minus its own, so that points of equal power
    /// distance are equally far.
    double distance(const Vec2& p, SiteId site, Offset offset) const {
        const Vec2 way = p - position(site, offset);
        return lift_.empty() ? way.norm() : std::sqrt(way.squaredNorm() + lift_[site]);
    }
    /// The weight of a site, up to a constant that is the same for all of them, length^2.
    double weight(SiteId site) const { return lift_.empty() ? 0 : -lift_[site]; }
    /// An image, and how far a point lies on its side of the nearest bisector with another one.
    struct Side {
        Offset offset;
        double depth;
    };
    /// Returns the image on whose side p lies.
    /// @throws NotATile as nearest().
    Side side_of(SiteId site, const Vec2& p) const;
    /// Returns the offset of the image that is nearest to p.
    /// @throws NotATile if the site lies too many periods away.
    Offset nearest(SiteId site, const Vec2& p) const {
        if ((p - positions_[site]).squaredNorm() < near_) return {};
        return search(site, p);
    }
    /// An offset of the tile's lattice in that of the sites.
    Offset of_tile(Offset offset) const { return {offset.i * columns_, offset.j * rows_}; }
    /// The number of the class of an image modulo the tile's lattice, 0 ... copies() - 1.
    std::size_t copy_of(Offset offset) const {
        const auto modulo = [](int k, int n) { return (k % n + n) % n; };
        return std::size_t(modulo(offset.i, columns_)) * rows_ + modulo(offset.j, rows_);
    }

   private:
    Offset search(SiteId site, const Vec2& p) const;

    int columns_;
    int rows_;
    Lattice lattice_;
    Reduction reduction_;
    /// No other image is nearer to a point whose squared distance is below this.
    double near_;
    std::vector<Vec2> positions_;
    /// The squared height of each site; empty without weights.
    std::vector<double> lift_;
};

}  // namespace pcvt::plane
