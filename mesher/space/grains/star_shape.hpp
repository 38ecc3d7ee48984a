#pragma once

#include <span>
#include <vector>

#include "mesher/space/grains/cell_tetrahedra.hpp"

namespace pcvt::space {

/// The shapes of the tetrahedra at one vertex while it moves, or at all images of one node: eight
/// at a time, with all that does not move computed once.
///
/// Example usage:
///     StarShape shape;
///     for (const int t : star) shape.add(cell, t, v);
///     if (shape.least_quality(way, best) > best) cell.set_point(v, cell.point(v) + way);
///
/// Laws, tested by number:
///   (1) least_quality() is the least quality of the tetrahedra with the vertex moved, up to
///       rounding.
///   (2) measure() gives the least quality and the sum of volume_length_ratio().
class StarShape {
   public:
    void clear();
    /// Adds a tetrahedron with a corner v. The worst ones should come first.
    void add(const CellTetrahedra& cell, int t, int v);

    /// The least quality with the vertex moved, or one that is at most `stop` if there is any.
    double least_quality(const Vec3& way, double stop) const;
    struct Measure {
        double least_quality;
        /// Not complete if the least quality is below the bound.
        double sum_of_ratios;
    };
    Measure measure(const Vec3& way, double bound) const;
    struct Centres {
        /// The ways to the mean of circumcentres and to that of barycentres, weighted by volume.
        Vec3 of_spheres;
        Vec3 of_corners;
    };
    Centres centres() const;

   private:
    static constexpr int kLanes = 8;
    /// Of eight tetrahedra: their other corners (a, b, c) relative to the vertex, which sees them
    /// clockwise; the normal of that triangle, its square, and the squared edges bc, ca and ab.
    struct Block {
        double a[3][kLanes];
        double b[3][kLanes];
        double c[3][kLanes];
        double normal[3][kLanes];
        double square[kLanes];
        double edge[3][kLanes];
        /// 1 beside a sharp feature, or 0.
        double at_feature[kLanes];
    };
    struct LaneShape;
    static LaneShape shape_in(const Block& block, int lane, const double* way);
    static void qualities_of(const Block& block, const double* way, double* __restrict qualities);
    static void qualities_and_ratios_of(const Block& block, const double* way,
                                        double* __restrict qualities, double* __restrict ratios);

    std::vector<Block> blocks_;
    int n_ = 0;
};

}  // namespace pcvt::space
