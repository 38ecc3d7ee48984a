#pragma once

#include "mesher/space/geometry/sites.hpp"

namespace pcvt::space {

/// The metric |B p| of elongated cells, with det B = 1: `ratio` times as long along `axis` as
/// across it.
///
///   B = R^(1/3) (I + (1/R - 1) a a^T), a the unit vector along the axis
///
/// A tessellation in this metric is an ordinary one of the lattice and the sites mapped by B,
/// mapped back. Volumes are unchanged, and so are offsets, because B maps period vectors to period
/// vectors.
///
/// Example usage:
///
///     const Metric metric(3, {1, 1, 0});
///     const Lattice round = metric.to_round(lattice);
///     // ... compute cells of metric.to_round(points) on `round`, then
///     const Vec3 vertex = metric.from_round(cells.vertices[v]);
///
/// Laws, tested by number:
///   (1) from_round(to_round(p)) = p up to rounding, and det B = 1.
///   (2) A ball of the metric is an ellipsoid with the axes `ratio` : 1 : 1, the first along
///       `axis`.
///   (3) Ratio 1 changes no bit.
class Metric {
   public:
    Metric() = default;
    /// @param axis  of any length that is not zero.
    /// @throws InvalidInput unless 1 / kLargestRatio <= ratio <= kLargestRatio and the axis has a
    ///         direction.
    Metric(double ratio, const Vec3& axis);

    static constexpr double kLargestRatio = 100;

    bool is_round() const { return is_round_; }
    /// The arguments of the constructor, from which another metric of the same bits can be made; 1
    /// and the x axis of a round one.
    double ratio() const { return ratio_; }
    const Vec3& axis() const { return axis_; }
    /// B p
    Vec3 to_round(const Vec3& p) const { return is_round_ ? p : product(b_, p); }
    /// B^-1 p
    Vec3 from_round(const Vec3& p) const { return is_round_ ? p : product(inverse_, p); }
    Points to_round(const Points& points) const;
    /// The lattice with the period vectors B a, B b and B c.
    Lattice to_round(const Lattice& lattice) const;
    /// Requires that the lattice can be reduced in the round space.
    /// @throws InvalidInput as reduce() does.
    void require_reducible(const Lattice& lattice) const;
    /// Half of the sides of a box along the axes that contains the image of a box.
    Vec3 box_to_round(const Vec3& half) const { return product(b_.cwiseAbs(), half); }
    /// The largest factors by which to_round() and from_round() multiply a length.
    double largest_stretch() const;
    double largest_stretch_back() const;

    /// The sites in the round space, of `round`, as sites of the lattice that the metric maps to
    /// theirs: the same coordinates, in the basis that is reduced in the round space.
    Sites from_round(const Sites& round, const Lattice& lattice) const;

    friend bool operator==(const Metric& s, const Metric& t) {
        return s.ratio_ == t.ratio_ && s.axis_ == t.axis_;
    }

   private:
    /// In one order on every platform.
    static Vec3 product(const Eigen::Matrix3d& m, const Vec3& p) {
        return m.col(0) * p.x() + m.col(1) * p.y() + m.col(2) * p.z();
    }

    bool is_round_ = true;
    double ratio_ = 1;
    Vec3 axis_ = Vec3::UnitX();
    Eigen::Matrix3d b_ = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d inverse_ = Eigen::Matrix3d::Identity();
};

}  // namespace pcvt::space
