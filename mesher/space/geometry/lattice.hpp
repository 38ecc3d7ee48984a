#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>

namespace pcvt::space {

using Vec3 = Eigen::Vector3d;
/// 3 x n, one point a column.
using Points = Eigen::Matrix3Xd;

/// An element (i, j, k) of Z^3; with a lattice it means the translation i a + j b + k c.
struct Offset {
    int i = 0;
    int j = 0;
    int k = 0;

    friend constexpr auto operator<=>(const Offset&, const Offset&) = default;
    friend constexpr Offset operator+(Offset s, Offset t) {
        return {s.i + t.i, s.j + t.j, s.k + t.k};
    }
    friend constexpr Offset operator-(Offset s, Offset t) {
        return {s.i - t.i, s.j - t.j, s.k - t.k};
    }
    friend constexpr Offset operator-(Offset s) { return {-s.i, -s.j, -s.k}; }
    Vec3 vector() const { return {double(i), double(j), double(k)}; }
};

/// The translation group of the flat 3-torus, given by three period vectors.
///
/// Example usage:
///
///     const Lattice lattice({1, 0, 0}, {0.5, 0.9, 0}, {0.5, 0.3, 0.8});
///     const Vec3 u = lattice.to_lattice({0.75, 0.45, 0});  // (0.5, 0.5, 0)
///     const Vec3 image = Vec3(0.75, 0.45, 0) + lattice.translation({1, -2, 0});
///
/// Laws, tested by number:
///   (1) to_lattice(to_space(u)) = u up to rounding.
///   (2) translation(o) is i a + j b + k c, rounded about once, however large i, j and k.
class Lattice {
   public:
    /// @param a, b, c  period vectors, length units; either orientation.
    /// @throws InvalidInput if a coordinate is not finite, a length lies outside of
    ///         [1e-40, 1e40], or the vectors are linearly dependent.
    Lattice(const Vec3& a, const Vec3& b, const Vec3& c);

    /// The box with sides x, y and z along the axes.
    static Lattice box(double x, double y, double z);

    const Vec3& a() const { return periods_[0]; }
    const Vec3& b() const { return periods_[1]; }
    const Vec3& c() const { return periods_[2]; }
    const std::array<Vec3, 3>& periods() const { return periods_; }
    /// Volume of the fundamental domain, |det(a, b, c)|.
    double volume() const { return volume_; }
    bool right_handed() const { return right_handed_; }
    /// The distances between neighbouring lattice planes along which one lattice coordinate is
    /// constant: domain k lies between two planes this far from each other.
    Vec3 heights() const;

    /// The translation i a + j b + k c, length units.
    Vec3 translation(Offset offset) const { return to_space(offset.vector()); }
    /// Lattice coordinates u with p = u_0 a + u_1 b + u_2 c.
    Vec3 to_lattice(const Vec3& p) const { return inverse_ * p; }
    /// The point u_0 a + u_1 b + u_2 c.
    Vec3 to_space(const Vec3& u) const;

   private:
    std::array<Vec3, 3> periods_;
    double volume_;
    bool right_handed_;
    Eigen::Matrix3d inverse_;
};

/// A Minkowski-reduced basis of a lattice, and its coefficients in the original basis.
///
/// Laws, tested by number:
///   (1) Period r of `reduced` is m[3 r] a + m[3 r + 1] b + m[3 r + 2] c, and det m is +1 or -1.
///   (2) Each of the reduced periods is a shortest vector of the lattice that extends the periods
///       before it to a basis, up to rounding; they are right-handed.
///   (3) lattice.translation(to_original(o)) = reduced.translation(o) up to rounding.
struct Reduction {
    Lattice reduced;
    std::array<int, 9> m;

    /// Converts an offset in the reduced basis to the original basis.
    Offset to_original(Offset reduced_offset) const;
};

/// Computes a Minkowski-reduced basis.
/// @throws InvalidInput if the vectors are so close to dependent that the reduction needs an
///         integer above 10^6 or meets a basis thinner than 1 : 10^6.
Reduction reduce(const Lattice& lattice);

/// Coordinates are multiples of 1 / kGrid = 2^-50. Below 8 such numbers, and their differences,
/// are exact in a double.
inline constexpr double kGrid = 0x1p50;

/// A point in lattice coordinates, split into fractions in [0, 1), multiples of 2^-50, and
/// integers.
struct WrappedPoint {
    Vec3 fraction;
    Offset whole;
};

/// Rounds each coordinate to the nearest multiple of 2^-50 and wraps it: whole + fraction is the
/// rounded u.
/// @pre |u| < 2^30 in each coordinate.
WrappedPoint wrap(const Vec3& u);

/// Rounds to the nearest multiple of 2^-50. @pre |displacement| <= 2, componentwise.
inline Vec3 snapped_displacement(const Vec3& displacement) {
    // Doubles in [4, 8] are multiples of 2^-50.
    const Vec3 shift = Vec3::Constant(6);
    const Vec3 sum = displacement + shift;
    return sum - shift;
}

}  // namespace pcvt::space
