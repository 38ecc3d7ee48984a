#pragma once

#include "mesher/sites.hpp"

namespace pcvt {

/// An image of a site: coordinates in [0, 1)^2 of the reduced basis plus an offset in that basis.
struct Image {
    double u;
    double v;
    SiteId site;
    Offset offset;
};

Image image(const Sites& sites, SiteId site, Offset offset);

/// q - p in coordinates of the reduced basis; exact while both components are below 4.
inline Vec2 difference(const Image& p, const Image& q) {
    return {(q.u - p.u) + (q.offset.i - p.offset.i), (q.v - p.v) + (q.offset.j - p.offset.j)};
}

/// The Gram matrix of the reduced basis, scaled by a power of two. Rounded once: for every
/// predicate it *is* the lattice, so that all images of a site answer alike.
struct Gram {
    double aa;
    double ab;
    double bb;
};

Gram gram_of(const Lattice& reduced);

/// The predicates are exact: a double filter decides almost always, multiprecision the rest. They
/// depend on differences of images only, so a common translation never changes an answer.

/// +1 if p, q, r turn counter-clockwise, -1 if clockwise, 0 if they are collinear.
int orientation(const Image& p, const Image& q, const Image& r);

/// +1 if s lies inside the circle through the counter-clockwise triangle p, q, r, -1 outside, 0 on
/// it.
int in_circle(const Gram& gram, const Image& p, const Image& q, const Image& r, const Image& s);

/// Whether the circumcentre of the counter-clockwise triangle p, q, r lies in the half-open domain
/// [0, 1)^2: of all images of a triangle exactly one does.
bool circumcentre_in_domain(const Gram& gram, const Image& p, const Image& q, const Image& r);

/// The circumcentre of the counter-clockwise triangle p, q, r minus p, in coordinates of the
/// reduced basis. Relative error below 1e-12, however thin the triangle is.
Vec2 circumcentre(const Gram& gram, const Image& p, const Image& q, const Image& r);

/// The order by (u + i, v + j): -1, 0 or +1.
int compare_u(const Image& p, const Image& q);
int compare_v(const Image& p, const Image& q);

/// How often the predicates of this thread were asked, and how often the filter could not decide.
struct PredicateCounts {
    std::int64_t asked = 0;
    std::int64_t exact = 0;
};
PredicateCounts predicate_counts();

}  // namespace pcvt
