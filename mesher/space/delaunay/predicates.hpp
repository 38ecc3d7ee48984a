#pragma once

#include <array>

#include "mesher/space/geometry/sites.hpp"

namespace pcvt::space {

/// A corner of a tetrahedron: the image of a site, offset in the reduced basis.
struct Corner {
    SiteId site;
    Offset offset;

    friend constexpr auto operator<=>(const Corner&, const Corner&) = default;
};

/// An image of a site: its coordinates in the reduced basis, multiples of 2^-50 in (-4, 4)^3, which
/// include the offset.
///
/// Example usage (whether site 4 translated by b lies inside of the sphere through four sites):
///
///     const Gram gram = gram_of(sites.reduction().reduced);
///     const auto at = [&](SiteId s) { return image(sites.coordinates(), {s, {}}); };
///     if (orientation(at(0), at(1), at(2), at(3)) > 0)
///         inside = in_sphere(gram, at(0), at(1), at(2), at(3),
///                            image(sites.coordinates(), {4, {0, 1, 0}})) > 0;
struct Image {
    Vec3 at;
    Corner name;
};

/// @param coordinates  3 x n, reduced basis.
inline Image image(const Points& coordinates, const Corner& corner) {
    return {coordinates.col(corner.site) + corner.offset.vector(), corner};
}

/// The Gram matrix of the reduced basis, scaled by a power of four and rounded to multiples of
/// 2^-60, where the shortest period has a length in [0.5, 1). For every predicate this rounded
/// matrix *is* the lattice, so that all images of a tetrahedron give the same answer.
struct Gram {
    double aa;
    double ab;
    double ac;
    double bb;
    double bc;
    double cc;

    /// The squared length of a displacement in coordinates of the reduced basis.
    template <class Number>
    Number squared_length(const Number& u, const Number& v, const Number& w) const {
        return u * (aa * u + 2 * (ab * v + ac * w)) + v * (bb * v + 2 * bc * w) + cc * w * w;
    }
};

Gram gram_of(const Lattice& reduced);
/// The unit of length of gram_of(), a power of two.
double gram_unit(const Lattice& reduced);

/// The coordinates of a displacement in the reduced basis.
template <class Number>
struct Components {
    Number x;
    Number y;
    Number z;
};
using Displacement = Components<double>;

/// The determinant whose sign in_sphere() returns, rounded.
/// @param d       the displacements of p, q, r and s from t.
/// @param height  their squared lengths.
inline double in_sphere_determinant(const std::array<Displacement, 4>& d,
                                    const std::array<double, 4>& height) {
    // Share the minors of x and y between the four determinants.
    const auto minor = [&](int k, int l) { return d[k].x * d[l].y - d[l].x * d[k].y; };
    const double pq = minor(0, 1);
    const double pr = minor(0, 2);
    const double ps = minor(0, 3);
    const double qr = minor(1, 2);
    const double qs = minor(1, 3);
    const double rs = minor(2, 3);
    return height[0] * (d[1].z * rs - d[2].z * qs + d[3].z * qr) -
           height[1] * (d[0].z * rs - d[2].z * ps + d[3].z * pr) +
           height[2] * (d[0].z * qs - d[1].z * ps + d[3].z * pq) -
           height[3] * (d[0].z * qr - d[1].z * pr + d[2].z * pq);
}

/// Bounds of the rounding of in_sphere_determinant(), and of the determinant of three
/// displacements, whose components are at most those of `most`.
double in_sphere_rounding(const Gram& gram, const Displacement& most);
double determinant_rounding(const Displacement& most);

/// The predicates are exact: a filter in doubles decides nearly all cases, integers the others.
/// They depend only on differences of images, so a common translation never changes an answer.

/// Returns +1 if s lies on the side of the triangle p, q, r from which it turns counter-clockwise
/// (in a right-handed basis), -1 if on the other side, 0 if the four are coplanar.
int orientation(const Image& p, const Image& q, const Image& r, const Image& s);

/// Returns +1 if t lies inside of the sphere through the positively oriented p, q, r, s, -1 if
/// outside, 0 if on it.
int in_sphere(const Gram& gram, const Image& p, const Image& q, const Image& r, const Image& s,
              const Image& t);

/// The same with ties broken by one rule for all images: a sphere is thought to lie a little off
/// its points, the more the greater a point is in the lexicographic order of coordinates (O.
/// Devillers and M. Teillaud 2011). For any number of cospherical images exactly one triangulation
/// by tetrahedra of positive volume satisfies the rule, and translations of it by the lattice do
/// too.
bool violates_delaunay(const Gram& gram, const Image& p, const Image& q, const Image& r,
                       const Image& s, const Image& t);

/// For coplanar images with p, q and r not collinear, returns +1 if t lies inside of the circle
/// through the others, -1 if outside, 0 if on it. Always exact arithmetic.
int in_coplanar_circle(const Gram& gram, const Image& p, const Image& q, const Image& r,
                       const Image& t);

/// The orientation of three points projected along the coordinate axis `axis`: +1, 0, -1.
int projected_orientation(int axis, const Image& p, const Image& q, const Image& r);

/// The lexicographic order of coordinates.
inline bool is_lexicographically_less(const Image& p, const Image& q) {
    if (p.at.x() != q.at.x()) return p.at.x() < q.at.x();
    if (p.at.y() != q.at.y()) return p.at.y() < q.at.y();
    return p.at.z() < q.at.z();
}

/// The circumcentre minus p, coordinates of the reduced basis, in doubles.
Vec3 circumcentre(const Gram& gram, const Image& p, const Image& q, const Image& r, const Image& s);

/// The circumcentre of the corners 0, d[0], d[1] and d[2] from exact determinants, so that it is as
/// accurate for a flat tetrahedron as for any other.
/// @param d  multiples of 2^-50 in (-8, 8)^3, linearly independent.
Vec3 exact_circumcentre(const Gram& gram, const std::array<Vec3, 3>& d);

}  // namespace pcvt::space
