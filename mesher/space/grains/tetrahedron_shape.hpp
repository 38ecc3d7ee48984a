#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/space/geometry/lattice.hpp"

namespace pcvt::space {

/// Above every length and every quality.
inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// Products of vectors and measures of tetrahedra. Sums are written out, because Eigen may add in
// another order on other platforms. A tetrahedron (a, b, c, d) is positively oriented if d lies on
// the side from which a, b and c turn counter-clockwise.

inline double dot_product(const Vec3& a, const Vec3& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// a - b; GCC calls a function for Eigen's.
[[gnu::always_inline]] inline Vec3 difference(const Vec3& a, const Vec3& b) {
    return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
}

[[gnu::always_inline]] inline Vec3 cross_product(const Vec3& a, const Vec3& b) {
    return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
            a.x() * b.y() - a.y() * b.x()};
}

inline double squared_length(const Vec3& a) { return dot_product(a, a); }
inline double length(const Vec3& a) { return std::sqrt(squared_length(a)); }
inline double squared_distance(const Vec3& a, const Vec3& b) {
    return squared_length(difference(a, b));
}
inline double distance(const Vec3& a, const Vec3& b) { return length(a - b); }
inline Vec3 unit_vector(const Vec3& a) { return a / length(a); }

/// Six times the volume; negative where the tetrahedron is turned over.
[[gnu::always_inline]] inline double volume6(const Vec3& a, const Vec3& b, const Vec3& c,
                                             const Vec3& d) {
    return dot_product(cross_product(difference(b, a), difference(c, a)), difference(d, a));
}

/// The smallest sine of the six dihedral angles; negative where the tetrahedron is turned over, and
/// where a face has no area. The sine at edge kl is 6 V |kl| / (4 A_i A_j), A_i and A_j the areas
/// of the faces that meet there; all six share the denominator A_0 A_1 A_2 A_3.
[[gnu::always_inline]] inline double smallest_sine(const Vec3& a, const Vec3& b, const Vec3& c,
                                                   const Vec3& d) {
    const Vec3 ab = difference(b, a);
    const Vec3 ac = difference(c, a);
    const Vec3 ad = difference(d, a);
    const Vec3 bc = difference(c, b);
    const Vec3 bd = difference(d, b);
    const Vec3 normal_d = cross_product(ab, ac);
    const double a_face = squared_length(cross_product(bc, bd));
    const double b_face = squared_length(cross_product(ac, ad));
    const double c_face = squared_length(cross_product(ab, ad));
    const double d_face = squared_length(normal_d);
    const double bases = a_face * b_face;
    const double sides = c_face * d_face;
    const double least =
        std::min({squared_distance(d, c) * sides, squared_length(ab) * bases,
                  squared_length(bd) * (b_face * d_face), squared_length(bc) * (b_face * c_face),
                  squared_length(ad) * (a_face * d_face), squared_length(ac) * (a_face * c_face)});
    const double product = bases * sides;
    return product > 0 ? dot_product(normal_d, ad) * std::sqrt(least / product) : -1;
}

/// The quality of a tetrahedron beside a sharp feature of the cells, where small angles are
/// unavoidable, for its smallest sine: that of wider angles, so that others below about 13 degrees
/// are raised first. Equal to the sine where that is negative, and from 19 degrees on.
[[gnu::always_inline]] inline double quality_at_feature(double sine) {
    // 1.5 degrees count as 11.
    constexpr double kFactor = 7;
    constexpr double kLifted = 0.19;
    constexpr double kEqual = 0.32;
    constexpr double kSlope = (kEqual - kLifted) / (kEqual - kLifted / kFactor);
    const double steep = kFactor * sine;
    const double gentle = kEqual + kSlope * (sine - kEqual);
    const double lifted = steep < gentle ? steep : gentle;
    return lifted < sine ? sine : lifted;
}

/// Six times the volume over (sum of the squared edges)^(3/2), which is largest where the
/// tetrahedron is regular.
inline double volume_length_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const double sum = squared_distance(a, b) + squared_distance(a, c) + squared_distance(a, d) +
                       squared_distance(b, c) + squared_distance(b, d) + squared_distance(c, d);
    return volume6(a, b, c, d) / (sum * std::sqrt(sum));
}

/// Positive where e lies inside of the sphere through a positively oriented tetrahedron, length^5.
double in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

struct Circumsphere {
    Vec3 centre;
    /// Not finite where the tetrahedron is flat.
    double radius;
};
Circumsphere circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The smallest and the largest dihedral angle, degrees.
struct DihedralRange {
    double smallest = 180;
    double largest = 0;

    void add(const DihedralRange& other) {
        smallest = std::min(smallest, other.smallest);
        largest = std::max(largest, other.largest);
    }
};

/// Example usage:
///     const double smallest = dihedral_range(a, b, c, d).smallest;  // 70.53 if it is regular
DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The angle between two vectors that are not zero, degrees, in [0, 180].
double degrees_between(const Vec3& a, const Vec3& b);

}  // namespace pcvt::space
