#include "mesher/plane/search/lattice_certificate.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/search/lattice_steps.hpp"

namespace pcvt::plane {
namespace {

/// Returns the lattice that two steps span, if its index is n.
std::optional<HermiteForm> hermite_form(LatticeStep p, LatticeStep q, int n) {
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

LatticeStep nearest_step(const Vec2& u, int n) {
    return {std::llround(n * u.x()), std::llround(n * u.y())};
}

/// The points of a lattice; each is assigned to at most one site.
class Places {
   public:
    explicit Places(const LatticePattern& pattern)
        : pattern_(pattern), taken_(static_cast<std::size_t>(pattern.n_sites()), 0) {}

    /// Returns the lattice vector nearest to u, both in coordinates of the reduced period vectors;
    /// `nullopt` if that lattice point is taken already.
    std::optional<Vec2> take(const Vec2& u) {
        const double n = pattern_.n_sites();
        const auto [s, t] = pattern_.steps;
        // In n-ths of the period vectors the determinant of the steps is n.
        const std::int64_t k = std::llround(u.x() * t.j - u.y() * t.i);
        const std::int64_t m = std::llround(u.y() * s.i - u.x() * s.j);
        const std::int64_t i = k * s.i + m * t.i;
        const std::int64_t j = k * s.j + m * t.j;
        char& taken = taken_[static_cast<std::size_t>(pattern_site(pattern_.form, i, j))];
        if (taken != 0) return std::nullopt;
        taken = 1;
        return Vec2(static_cast<double>(i) / n, static_cast<double>(j) / n);
    }

   private:
    const LatticePattern& pattern_;
    std::vector<char> taken_;
};

/// Returns the lattice that the edges of the first Delaunay triangle span.
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

/// Whether the sites, moved by one common translation, lie on the lattice points, one on each.
bool lies_on(const Sites& sites, const LatticePattern& pattern) {
    const int n = sites.n_sites();
    Places places(pattern);
    Points off(2, n);
    for (SiteId s = 0; s < n; ++s) {
        checkpoint_each(s);
        const Vec2 u = sites.coordinates().col(s) - sites.coordinates().col(0);
        const auto place = places.take(u);
        if (!place) return false;
        off.col(s) = sites.reduction().reduced.to_position(u - *place);
    }
    const Vec2 common = off.rowwise().mean();
    return (off.colwise() - common).colwise().norm().maxCoeff() <= kOffLattice * sites.spacing();
}

}  // namespace

std::optional<LatticePattern> as_lattice(const CvtResult& result) {
    const Sites& sites = result.delaunay.sites();
    const auto form = form_of_triangle(result.delaunay);
    if (!form) return std::nullopt;
    LatticePattern pattern = lattice_pattern(sites.lattice(), *form);
    if (!lies_on(sites, pattern)) return std::nullopt;
    return pattern;
}

}  // namespace pcvt::plane
