#pragma once

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// The metric |B p| of elongated cells, with det B = 1: `ratio` times as long along the direction
/// at `degrees` from x as across it.
///
/// A tessellation in this metric is an ordinary one of the lattice and the sites mapped by B,
/// mapped back. Areas are unchanged, and so are offsets, because B maps period vectors to period
/// vectors.
///
/// Example usage:
///
///     const Metric metric(3, 30);
///     const Lattice round = metric.to_round(lattice);
///     // ... compute cells of metric.to_round(points) on `round`, then
///     const Vec2 vertex = metric.from_round(cells.vertices[v]);
///
/// Laws, tested by number:
///   (1) from_round(to_round(p)) = p up to rounding, and det B = 1.
///   (2) A circle of the metric is an ellipse with the axes `ratio` : 1 along `degrees`.
///   (3) Ratio 1 changes no bit.
class Metric {
   public:
    Metric() = default;
    /// @throws InvalidInput unless 1 / kLargestRatio <= ratio <= kLargestRatio and the angle is
    ///         finite.
    Metric(double ratio, double degrees);

    static constexpr double kLargestRatio = 100;

    bool is_round() const { return is_round_; }
    /// The two numbers of the constructor, from which another metric of the same bits can be made;
    /// 1 and 0 of a round one.
    double ratio() const { return ratio_; }
    double degrees() const { return degrees_; }
    /// B p
    Vec2 to_round(const Vec2& p) const { return is_round_ ? p : Vec2(b_ * p); }
    /// B^-1 p
    Vec2 from_round(const Vec2& p) const { return is_round_ ? p : Vec2(inverse_ * p); }
    Points to_round(const Points& points) const;
    /// The lattice with the period vectors B a and B b.
    Lattice to_round(const Lattice& lattice) const;
    /// Requires that the lattice can be reduced in the round space.
    /// @throws InvalidInput as reduce() does.
    void require_reducible(const Lattice& lattice) const;
    /// The largest factor by which to_round() multiplies a length.
    double largest_stretch() const;

    friend bool operator==(const Metric& s, const Metric& t) {
        return s.ratio_ == t.ratio_ && s.degrees_ == t.degrees_;
    }

   private:
    bool is_round_ = true;
    double ratio_ = 1;
    double degrees_ = 0;
    Eigen::Matrix2d b_ = Eigen::Matrix2d::Identity();
    Eigen::Matrix2d inverse_ = Eigen::Matrix2d::Identity();
};

}  // namespace pcvt::plane
