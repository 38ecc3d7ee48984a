#pragma once

#include <Eigen/Core>
#include <array>
#include <compare>

#include "mesher/torus/sites.hpp"

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
    constexpr std::array<int, 3> components() const { return {i, j, k}; }
    static constexpr Offset of(const std::array<int, 3>& c) { return {c[0], c[1], c[2]}; }
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
///   (1) to_lattice(to_position(u)) = u up to rounding.
///   (2) translation(o) is i a + j b + k c, rounded about once, however large i, j and k.
class Lattice {
   public:
    static constexpr int kDimension = 3;
    /// A tetrahedron's number times 4 must remain an int.
    static constexpr int kMostSites = 1 << 26;
    /// Coordinates of sites are multiples of this.
    static constexpr double kGrain = 0x1p-50;
    using Point = Vec3;
    using Points = space::Points;
    using Offset = space::Offset;

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
    /// h, the cube root of volume / n, the length scale of n sites.
    double spacing(int n) const;
    /// The distances between neighbouring lattice planes along which one lattice coordinate is
    /// constant: domain k lies between two planes this far from each other.
    Vec3 heights() const;

    /// The translation i a + j b + k c, length units.
    Vec3 translation(space::Offset offset) const { return to_position(offset.vector()); }
    /// Lattice coordinates u with p = u_0 a + u_1 b + u_2 c.
    Vec3 to_lattice(const Vec3& p) const { return inverse_ * p; }
    /// The point u_0 a + u_1 b + u_2 c.
    Vec3 to_position(const Vec3& u) const;
    /// Lattice coordinates in [0, 1)^3 of the same orbit, rounded to multiples of kGrain.
    /// @pre |u| < 2^30 in each coordinate.
    static Vec3 wrapped(const Vec3& u);

   private:
    std::array<Vec3, 3> periods_;
    double volume_;
    bool right_handed_;
    Eigen::Matrix3d inverse_;
};

using Reduction = pcvt::Reduction<Lattice>;

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
