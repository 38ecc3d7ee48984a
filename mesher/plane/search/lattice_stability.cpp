#include "mesher/plane/search/lattice_stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {
namespace {

/// A symmetric 2 x 2 matrix.
struct Symmetric {
    double xx = 0;
    double xy = 0;
    double yy = 0;

    void add(double factor, const Symmetric& other) {
        xx += factor * other.xx;
        xy += factor * other.xy;
        yy += factor * other.yy;
    }
    /// Returns the smaller and the larger eigenvalue.
    std::pair<double, double> eigenvalues() const {
        const double middle = (xx + yy) / 2;
        const double radius = Vec2((xx - yy) / 2, xy).norm();
        return {middle - radius, middle + radius};
    }
};

/// One vector of the superbase in n-ths of the reduced period vectors, and its matrix c (v v^T -
/// c^2 / 3  w w^T), with lengths in units of h.
struct Bond {
    std::int64_t i;
    std::int64_t j;
    Symmetric stiffness;
};

Symmetric stiffness(const Vec2& v, double c) {
    const double side = c * c * c / 3;
    return {c * v.x() * v.x() - side * v.y() * v.y(), (c + side) * v.x() * v.y(),
            c * v.y() * v.y() - side * v.x() * v.x()};
}

std::array<Bond, 3> bonds(const LatticePattern& pattern) {
    const double h = std::sqrt(pattern.basis.area());
    const Offset s = pattern.steps[0];
    const Vec2 p = pattern.basis.a() / h;
    // The basis is reduced, so this sign of its second vector makes the superbase obtuse.
    const double sign = p.dot(pattern.basis.b()) > 0 ? -1 : 1;
    const Offset t = sign > 0 ? pattern.steps[1] : -pattern.steps[1];
    const Vec2 q = sign * pattern.basis.b() / h;
    const Vec2 r = -p - q;
    // The cell has area 1, so c is minus the scalar product of the other two vectors.
    return {Bond{s.i, s.j, stiffness(p, -q.dot(r))}, Bond{t.i, t.j, stiffness(q, -r.dot(p))},
            Bond{-(s + t).i, -(s + t).j, stiffness(r, -p.dot(q))}};
}

}  // namespace

LatticeStability lattice_stability(const LatticePattern& pattern) {
    const int n = pattern.n_sites();
    if (n == 1) return {Minimum::kYes, std::nullopt};
    const std::array<Bond, 3> around = bonds(pattern);
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0;
    // Compute the extreme eigenvalues over all wave vectors but zero.
    for (int k = 0; k < pattern.form.a; ++k) {
        for (int m = k == 0 ? 1 : 0; m < pattern.form.d; ++m) {
            checkpoint_each(m);
            Symmetric hessian;
            for (const Bond& bond : around) {
                hessian.add(one_minus_cosine(k * bond.i + m * bond.j, n), bond.stiffness);
            }
            const auto [low, high] = hessian.eigenvalues();
            smallest = std::min(smallest, low);
            largest = std::max(largest, high);
        }
    }
    return decided_stability(smallest, largest);
}

}  // namespace pcvt::plane
