#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>
#include <string>

#include "mesher/torus/sites.hpp"

namespace pcvt::plane {

using Vec2 = Eigen::Vector2d;
/// 2 x n, one point a column.
using Points = Eigen::Matrix2Xd;

/// An element (i, j) of Z^2; with a lattice it means the translation i a + j b.
struct Offset {
    int i = 0;
    int j = 0;

    friend constexpr auto operator<=>(const Offset&, const Offset&) = default;
    friend constexpr Offset operator+(Offset s, Offset t) { return {s.i + t.i, s.j + t.j}; }
    friend constexpr Offset operator-(Offset s, Offset t) { return {s.i - t.i, s.j - t.j}; }
    friend constexpr Offset operator-(Offset s) { return {-s.i, -s.j}; }

    constexpr std::array<int, 2> components() const { return {i, j}; }
    static constexpr Offset of(const std::array<int, 2>& c) { return {c[0], c[1]}; }
};

/// Formats an offset for a message: "(2, -1)".
std::string offset_in_words(Offset offset);

/// The translation group of the flat torus, given by two period vectors.
///
/// Example usage:
///
///     const Lattice lattice({1, 0}, {0.5, 0.9});
///     const Vec2 u = lattice.to_lattice({0.75, 0.45});  // (0.5, 0.5)
///     const Vec2 image = Vec2(0.75, 0.45) + lattice.translation({1, -2});
///
/// Laws, tested by number:
///   (1) to_position(to_lattice(p)) = p up to rounding.
///   (2) translation(o) is within 1.5 ulp of i a + j b in each coordinate, however large i and j.
class Lattice {
   public:
    static constexpr int kDimension = 2;
    static constexpr int kMostSites = 1 << 28;
    /// Coordinates of sites are multiples of this.
    static constexpr double kGrain = 0x1p-51;
    using Point = Vec2;
    using Points = plane::Points;
    using Offset = plane::Offset;

    /// @param a, b  period vectors, length units; either orientation.
    /// @throws InvalidInput if a coordinate is not finite, a length lies outside of
    ///         [1e-60, 1e60], or the vectors are parallel.
    Lattice(const Vec2& a, const Vec2& b);

    /// The rectangle with sides `width` and `height` along x and y.
    static Lattice rectangle(double width, double height);

    const Vec2& a() const { return a_; }
    const Vec2& b() const { return b_; }
    std::array<Vec2, 2> periods() const { return {a_, b_}; }
    /// Area of the fundamental domain, |det(a, b)|.
    double area() const { return area_; }
    bool right_handed() const { return right_handed_; }
    /// h = sqrt(area / n), the length scale of n sites.
    double spacing(int n) const;

    /// The translation i a + j b, length units.
    Vec2 translation(plane::Offset offset) const;
    /// Lattice coordinates u with p = u_0 a + u_1 b.
    Vec2 to_lattice(const Vec2& p) const;
    /// The point u_0 a + u_1 b.
    Vec2 to_position(const Vec2& u) const;
    /// Lattice coordinates in [0, 1)^2 of the same orbit, rounded to multiples of kGrain.
    /// @pre |u| < 2^30 in each coordinate.
    static Vec2 wrapped(const Vec2& u);
    /// The sublattice with period vectors columns * a and rows * b.
    Lattice repeated(int columns, int rows) const;

   private:
    Vec2 a_;
    Vec2 b_;
    double area_;
    bool right_handed_;
};

using Reduction = pcvt::Reduction<Lattice>;

/// Computes a Gauss-reduced basis.
/// @throws InvalidInput if the vectors are so close to parallel that the reduction needs an integer
///         above 10^6 or meets a basis thinner than 1 : 10^6.
Reduction reduce(const Lattice& lattice);

/// A lattice coordinate split into a fraction in [0, 1), a multiple of 2^-51, and an integer.
struct Wrapped {
    double fraction;
    int whole;
};

/// Rounds u to the nearest multiple of 2^-51 and wraps it: whole + fraction is the rounded u.
/// @pre |u| < 2^30.
Wrapped wrap(double u);

/// Rounds to the nearest multiple of 2^-51. @pre |displacement| <= 1, componentwise.
inline double snapped_displacement(double displacement) {
    // Doubles in [2, 4] are multiples of 2^-51.
    constexpr double kShift = 3;
    return displacement + kShift - kShift;
}
inline Vec2 snapped_displacement(const Vec2& displacement) {
    return {snapped_displacement(displacement.x()), snapped_displacement(displacement.y())};
}

}  // namespace pcvt::plane
