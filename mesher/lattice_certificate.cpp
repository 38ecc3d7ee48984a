#include "mesher/lattice_certificate.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pcvt {
namespace {

/// A vector in n-ths of the reduced period vectors.
struct Step {
    std::int64_t i;
    std::int64_t j;
};

std::int64_t remainder_of(std::int64_t value, std::int64_t n) { return (value % n + n) % n; }

/// The lattice that two steps span, if its index is n.
std::optional<HermiteForm> hermite_form(Step p, Step q, int n) {
    if (p.i * q.j - p.j * q.i != n) return std::nullopt;
    // Euclid's algorithm on the first coordinates leads to (d, -b) and (0, a).
    while (q.i != 0) {
        const std::int64_t times = p.i / q.i;
        p = {p.i - times * q.i, p.j - times * q.j};
        std::swap(p, q);
    }
    const std::int64_t d = std::abs(p.i);
    const std::int64_t a = n / d;
    return HermiteForm{static_cast<int>(a), static_cast<int>(remainder_of(p.i < 0 ? p.j : -p.j, a)),
                       static_cast<int>(d)};
}

Step nearest_step(const Vec2& u, int n) {
    return {std::llround(n * u.x()), std::llround(n * u.y())};
}

/// The sites as numbered by pattern_points: each number must occur once.
class Places {
   public:
    explicit Places(const HermiteForm& form)
        : form_(form), taken_(static_cast<std::size_t>(form.index()), 0) {}

    /// The place (i (d, -b) + j (0, a)) / n nearest to u, by its coordinates; nothing if its orbit
    /// is taken already.
    std::optional<Vec2> take(const Vec2& u) {
        const double n = form_.index();
        const double i = std::round(u.x() * form_.a);
        const double j = std::round(u.y() * form_.d + i * form_.b / form_.a);
        const auto row = remainder_of(std::int64_t(i), form_.a);
        // (a, 0) turns of the first coordinate are whole periods, b steps of the second one each.
        const auto turns = (std::int64_t(i) - row) / form_.a;
        const auto column = remainder_of(std::int64_t(j) - turns * form_.b, form_.d);
        char& taken = taken_[static_cast<std::size_t>(row * form_.d + column)];
        if (taken != 0) return std::nullopt;
        taken = 1;
        return Vec2(i / form_.a, (j * form_.a - i * form_.b) / n);
    }

   private:
    HermiteForm form_;
    std::vector<char> taken_;
};

/// A basis from the three corners of a triangle.
std::optional<HermiteForm> form_of_triangle(const PeriodicDelaunay& delaunay) {
    const TorusTriangulation& t = delaunay.triangulation();
    const auto place = [&](int h) -> Vec2 {
        const Corner corner = t.corner(h);
        return delaunay.sites().coordinates().col(corner.site) +
               Vec2(corner.offset.i, corner.offset.j);
    };
    const int n = t.n_sites();
    return hermite_form(nearest_step(place(1) - place(0), n), nearest_step(place(2) - place(0), n),
                        n);
}

/// Whether the sites, moved by one translation, lie at the places of the lattice, one at each.
bool lies_on(const Sites& sites, const HermiteForm& form) {
    const int n = sites.n_sites();
    Places places(form);
    Points off(2, n);
    for (SiteId s = 0; s < n; ++s) {
        const Vec2 u = sites.coordinates().col(s) - sites.coordinates().col(0);
        const auto place = places.take(u);
        if (!place) return false;
        off.col(s) = sites.reduction().reduced.to_plane(u - *place);
    }
    const Vec2 common = off.rowwise().mean();
    return (off.colwise() - common).colwise().norm().maxCoeff() <= kOffLattice * sites.spacing();
}

}  // namespace

std::optional<LatticePattern> as_lattice(const CvtResult& result) {
    const Sites& sites = result.delaunay.sites();
    const auto form = form_of_triangle(result.delaunay);
    if (!form || !lies_on(sites, *form)) return std::nullopt;
    return lattice_pattern(sites.lattice(), *form);
}

}  // namespace pcvt
