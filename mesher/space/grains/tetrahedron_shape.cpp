#include "mesher/space/grains/tetrahedron_shape.hpp"

#include <array>
#include <numbers>

#include "mesher/portable/portable_angles.hpp"

namespace pcvt::space {

double in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
    const Vec3 ea = a - e;
    const Vec3 eb = b - e;
    const Vec3 ec = c - e;
    const Vec3 ed = d - e;
    const Vec3 cd = cross_product(ec, ed);
    const Vec3 ab = cross_product(ea, eb);
    return squared_length(ea) * dot_product(eb, cd) - squared_length(eb) * dot_product(ea, cd) +
           squared_length(ec) * dot_product(ed, ab) - squared_length(ed) * dot_product(ec, ab);
}

Circumsphere circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ad = d - a;
    const Vec3 cd = cross_product(ac, ad);
    const Vec3 sum = squared_length(ab) * cd + squared_length(ac) * cross_product(ad, ab) +
                     squared_length(ad) * cross_product(ab, ac);
    const Vec3 arm = sum / (2 * dot_product(ab, cd));
    return {.centre = a + arm, .radius = length(arm)};
}

DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    // Outward normals of the faces opposite to a, b, c and d.
    const std::array<Vec3, 4> normals{cross_product(c - b, d - b), cross_product(d - a, c - a),
                                      cross_product(b - a, d - a), cross_product(c - a, b - a)};
    DihedralRange range;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            const double angle = 180 - degrees_between(normals[i], normals[j]);
            range.add({.smallest = angle, .largest = angle});
        }
    }
    return range;
}

double degrees_between(const Vec3& a, const Vec3& b) {
    return portable_atan2(length(cross_product(a, b)), dot_product(a, b)) * 180 / std::numbers::pi;
}

}  // namespace pcvt::space
