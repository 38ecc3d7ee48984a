#include "mesher/space/delaunay/frame.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace pcvt::space {

Frame::Frame(const Lattice& reduced, double unit) {
    const Vec3 a = reduced.a() / unit;
    const Vec3 b = reduced.b() / unit;
    const Vec3 c = reduced.c() / unit;
    ax = a.norm();
    bx = a.dot(b) / ax;
    const Vec3 ab = a.cross(b);
    by = ab.norm() / ax;
    cx = a.dot(c) / ax;
    cy = ab.cross(a).dot(c) / (ab.norm() * ax);
    cz = ab.dot(c) / ab.norm();
    gram = gram_of(reduced);
    const double to_gram = unit / gram_unit(reduced);
    gram_per_square = to_gram * to_gram;
}

}  // namespace pcvt::space
