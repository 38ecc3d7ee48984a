#include "mesher/cell_moments.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/polygon.hpp"
#include "mesher/quadrature.hpp"

namespace pcvt {
namespace {

/// A piece whose area and that of its bounding parallelogram differ by less than this, relatively,
/// is that parallelogram.
constexpr double kWhole = 1e-12;

/// The places of a rule's points in the triangle between `apex` and two corners, lattice
/// coordinates in [0, 1].
void place_points(const Vec2& apex, const Vec2& from, const Vec2& to, const TriangleRule& rule,
                  const DensityProbe& probe, DensityPoint* points) {
    const Vec2 p = from - apex;
    const Vec2 r = to - apex;
    for (int k = 0; k < rule.n_points(); ++k) {
        const double a = rule.along_p[k];
        const double b = rule.along_r[k];
        points[k] =
            probe.point(apex.x() + (a * p.x() + b * r.x()), apex.y() + (a * p.y() + b * r.y()));
    }
}

/// Moments of the triangle (0, p, r) about its corner 0.
Moments triangle_moments(const Vec2& p, const Vec2& r, const TriangleRule& rule,
                         const double* rho) {
    const double twice_area = cross(p, r);
    if (!(twice_area > 0)) return {};
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (int k = 0; k < rule.n_points(); ++k) sum += rho[k] * rule.weights.col(k);
    sum *= twice_area;
    return {sum[0], sum[1] * p + sum[2] * r,
            sum[3] * p.squaredNorm() + 2 * sum[4] * p.dot(r) + sum[5] * r.squaredNorm()};
}

/// The fan of the triangles between `apex` and the sides of a polygon round it, about the apex.
/// `period` is what brings lattice coordinates of the polygon into [0, 1].
Moments fan_moments(const CellPolygon& polygon, const CellCorner& apex, const Vec2& period,
                    const TriangleRule& rule, DensityProbe& probe) {
    const auto n_points = static_cast<std::size_t>(rule.n_points());
    const std::span<DensityPoint> points = probe.room(n_points * polygon.size());
    const Vec2 origin = apex.lattice - period;
    Vec2 from = polygon.back().lattice - period;
    DensityPoint* place = points.data();
    for (const CellCorner& corner : polygon) {
        const Vec2 to = corner.lattice - period;
        place_points(origin, from, to, rule, probe, place);
        place += n_points;
        from = to;
    }
    const double* rho = probe.ask(points).data();
    Moments sum;
    Vec2 p = polygon.back().plane - apex.plane;
    for (const CellCorner& corner : polygon) {
        const Vec2 r = corner.plane - apex.plane;
        sum += triangle_moments(p, r, rule, rho);
        rho += n_points;
        p = r;
    }
    return sum;
}

/// A parallelogram along the lattice directions, by its corner and the two beside it; about its
/// corner.
Moments whole_moments(const CellCorner& corner, const CellCorner& along, const CellCorner& up,
                      const Vec2& period, const GaussRule& rule, DensityProbe& probe) {
    const std::size_t q = rule.nodes.size();
    const std::span<DensityPoint> points = probe.room(q * q);
    for (std::size_t k = 0; k < q * q; ++k) {
        const Vec2 place = corner.lattice - period +
                           rule.nodes[k / q] * (along.lattice - corner.lattice) +
                           rule.nodes[k % q] * (up.lattice - corner.lattice);
        points[k] = probe.point(place.x(), place.y());
    }
    const std::span<const double> rho = probe.ask(points);
    const Vec2 p = along.plane - corner.plane;
    const Vec2 r = up.plane - corner.plane;
    const double area = std::abs(cross(p, r));
    Moments sum;
    for (std::size_t k = 0; k < q * q; ++k) {
        const Vec2 d = rule.nodes[k / q] * p + rule.nodes[k % q] * r;
        const double mass = area * rule.weights[k / q] * rule.weights[k % q] * rho[k];
        sum += {mass, mass * d, mass * d.squaredNorm()};
    }
    return sum;
}

/// Moments about the site of what has these moments about a point at `place`.
Moments about_site(const Moments& m, const Vec2& place) {
    return {m.mass, m.first + m.mass * place,
            m.second + 2 * place.dot(m.first) + place.squaredNorm() * m.mass};
}

struct Box {
    Vec2 low;
    Vec2 high;
};

Box lattice_box(const CellPolygon& polygon) {
    Box box{polygon[0].lattice, polygon[0].lattice};
    for (const CellCorner& corner : polygon) {
        box.low = box.low.cwiseMin(corner.lattice);
        box.high = box.high.cwiseMax(corner.lattice);
    }
    return box;
}

double lattice_area(const CellPolygon& polygon) {
    double twice = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        twice += cross(polygon[k].lattice - polygon[0].lattice,
                       polygon[k + 1].lattice - polygon[0].lattice);
    }
    return std::abs(twice) / 2;
}

/// Cuts a convex polygon along one line: `below` gets the part with smaller coordinates.
void cut(const CellPolygon& polygon, int axis, double at, CellPolygon& below, CellPolygon& above) {
    below.clear();
    above.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const CellCorner& from = polygon[k];
        const CellCorner& to = polygon[k + 1 == polygon.size() ? 0 : k + 1];
        const double before = from.lattice[axis] - at;
        const double after = to.lattice[axis] - at;
        if (before <= 0) below.push_back(from);
        if (before >= 0) above.push_back(from);
        if (!((before < 0 && after > 0) || (before > 0 && after < 0))) continue;
        const double part = before / (before - after);
        CellCorner corner{from.plane + part * (to.plane - from.plane),
                          from.lattice + part * (to.lattice - from.lattice)};
        corner.lattice[axis] = at;
        below.push_back(corner);
        above.push_back(corner);
    }
}

/// The breaks, repeated in every period, between low and high.
std::vector<double> between(const std::vector<double>& breaks, double low, double high) {
    std::vector<double> found;
    double period = std::floor(low);
    auto next = std::upper_bound(breaks.begin(), breaks.end(), low - period);
    for (;; ++period, next = breaks.begin()) {
        for (; next != breaks.end(); ++next) {
            if (period + *next >= high) return found;
            found.push_back(period + *next);
        }
    }
}

Moments piece_moments(const CellPolygon& piece, int q, const GaussRule& gauss,
                      DensityProbe& probe) {
    const Box box = lattice_box(piece);
    const Vec2 size = box.high - box.low;
    const Vec2 period = ((box.low + box.high) / 2).array().floor();
    const bool whole =
        piece.size() == 4 && std::abs(lattice_area(piece) - size.prod()) <= kWhole * size.prod();
    const Moments moments = whole
                                ? whole_moments(piece[0], piece[1], piece[3], period, gauss, probe)
                                : fan_moments(piece, piece[0], period, triangle_rule(q), probe);
    return about_site(moments, piece[0].plane);
}

/// Calls take(part) for the parts of a convex polygon between the breaks along one axis.
template <class Take>
void cut_along(const CellPolygon& polygon, int axis, const std::vector<double>& breaks,
               const Take& take) {
    const Box box = lattice_box(polygon);
    CellPolygon rest = polygon;
    CellPolygon below;
    CellPolygon above;
    for (const double at : between(breaks, box.low[axis], box.high[axis])) {
        cut(rest, axis, at, below, above);
        if (below.size() >= 3) take(below);
        rest.swap(above);
    }
    if (rest.size() >= 3) take(rest);
}

}  // namespace

Moments& Moments::operator+=(const Moments& other) {
    mass += other.mass;
    first += other.first;
    second += other.second;
    return *this;
}

CellQuadrature::CellQuadrature(const Density& density)
    : breaks_{density.u_breaks, density.v_breaks} {
    for (std::vector<double>& breaks : breaks_) {
        breaks.push_back(0);
        std::sort(breaks.begin(), breaks.end());
        breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
        if (!(breaks.front() >= 0 && breaks.back() < 1)) {
            throw InvalidInput("a break line of the density is not in [0, 1); wrap it");
        }
    }
}

bool CellQuadrature::is_cut(const CellPolygon& cell, const Vec2& site) const {
    const Box box = lattice_box(cell);
    for (const int axis : {0, 1}) {
        const double period = std::floor(site[axis]);
        const double low = box.low[axis] - period;
        const double high = box.high[axis] - period;
        if (low < 0 || high > 1) return true;
        const std::vector<double>& breaks = breaks_[axis];
        if (breaks.size() == 1) continue;
        const auto next = std::upper_bound(breaks.begin(), breaks.end(), low);
        if (next != breaks.end() && *next < high) return true;
    }
    return false;
}

Moments CellQuadrature::operator()(const CellPolygon& cell, const Vec2& site, int q,
                                   DensityProbe& probe) const {
    if (!is_cut(cell, site)) {
        const Vec2 period(std::floor(site.x()), std::floor(site.y()));
        return fan_moments(cell, {Vec2::Zero(), site}, period, triangle_rule(q), probe);
    }
    const GaussRule gauss = gauss_rule(q, 0);
    Moments sum;
    cut_along(cell, 0, breaks_[0], [&](const CellPolygon& strip) {
        cut_along(strip, 1, breaks_[1],
                  [&](const CellPolygon& piece) { sum += piece_moments(piece, q, gauss, probe); });
    });
    return sum;
}

}  // namespace pcvt
