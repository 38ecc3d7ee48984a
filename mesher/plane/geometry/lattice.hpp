#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>
#include <string>

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
///   (1) to_plane(to_lattice(p)) = p up to rounding.
///   (2) translation(o) is within 1.5 ulp of i a + j b in each coordinate, however large i and j.
class Lattice {
   public:
    /// @param a, b  period vectors, length units; either orientation.
    /// @throws InvalidInput if a coordinate is not finite, a length lies outside of
    ///         [1e-60, 1e60], or the vectors are parallel.
    Lattice(const Vec2& a, const Vec2& b);

    /// The rectangle with sides `width` and `height` along x and y.
    static Lattice rectangle(double width, double height);

    const Vec2& a() const { return a_; }
    const Vec2& b() const { return b_; }
    /// Area of the fundamental domain, |det(a, b)|.
    double area() const { return area_; }
    bool right_handed() const { return right_handed_; }

    /// The translation i a + j b, length units.
    Vec2 translation(Offset offset) const;
    /// Lattice coordinates u with p = u_0 a + u_1 b.
    Vec2 to_lattice(const Vec2& p) const;
    /// The point u_0 a + u_1 b.
    Vec2 to_plane(const Vec2& u) const;
    /// The sublattice with period vectors columns * a and rows * b.
    Lattice repeated(int columns, int rows) const;

   private:
    Vec2 a_;
    Vec2 b_;
    double area_;
    bool right_handed_;
};

/// A Gauss-reduced basis of a lattice, and its coefficients in the original basis.
///
/// Laws, tested by number:
///   (1) reduced.a() = m[0] a + m[1] b and reduced.b() = m[2] a + m[3] b, where
///       m[0] m[3] - m[1] m[2] is +1 or -1.
///   (2) |a'| <= |b'| and |a'.b'| <= |a'|^2 / 2, up to rounding; (a', b') is right-handed.
///   (3) lattice.translation(to_original(o)) = reduced.translation(o) up to rounding.
struct Reduction {
    Lattice reduced;
    std::array<int, 4> m;

    /// Converts an offset in the reduced basis to the original basis.
    Offset to_original(Offset reduced_offset) const;
};

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
