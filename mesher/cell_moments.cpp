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

/// The triangle between `apex` and the two corners. `period` is what brings lattice coordinates of
/// the piece into [0, 1].
Moments triangle_moments(const CellCorner& apex, const CellCorner& from, const CellCorner& to,
                         const Vec2& period, const TriangleRule& rule, DensityProbe& probe) {
    const Vec2 p = from.plane - apex.plane;
    const Vec2 r = to.plane - apex.plane;
    const Vec2 along_p = from.lattice - apex.lattice;
    const Vec2 along_r = to.lattice - apex.lattice;
    const Vec2 origin = apex.lattice - period;
    const double twice_area = cross(p, r);
    if (!(twice_area > 0)) return {};
    Moments sum;
    for (int k = 0; k < rule.n_points(); ++k) {
        const double a = rule.along_p[k];
        const double b = rule.along_r[k];
        const double u = origin.x() + (a * along_p.x() + b * along_r.x());
        const double v = origin.y() + (a * along_p.y() + b * along_r.y());
        const double dx = apex.plane.x() + (a * p.x() + b * r.x());
        const double dy = apex.plane.y() + (a * p.y() + b * r.y());
        const double mass = rule.weight[k] * probe(u, v);
        sum.mass += mass;
        sum.first.x() += mass * dx;
        sum.first.y() += mass * dy;
        sum.second += mass * (dx * dx + dy * dy);
    }
    return {twice_area * sum.mass, twice_area * sum.first, twice_area * sum.second};
}

/// A parallelogram along the lattice directions, by its corner and the two beside it.
Moments whole_moments(const CellCorner& corner, const CellCorner& along, const CellCorner& up,
                      const Vec2& period, const GaussRule& rule, DensityProbe& probe) {
    const Vec2 p = along.plane - corner.plane;
    const Vec2 r = up.plane - corner.plane;
    const Vec2 along_p = along.lattice - corner.lattice;
    const Vec2 along_r = up.lattice - corner.lattice;
    Moments sum;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
            const Vec2 w =
                corner.lattice - period + rule.nodes[i] * along_p + rule.nodes[j] * along_r;
            const Vec2 d = corner.plane + rule.nodes[i] * p + rule.nodes[j] * r;
            const double mass = rule.weights[i] * rule.weights[j] * probe(w.x(), w.y());
            sum += {mass, mass * d, mass * d.squaredNorm()};
        }
    }
    const double area = std::abs(cross(p, r));
    return {area * sum.mass, area * sum.first, area * sum.second};
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
        const CellCorner& to = polygon[(k + 1) % polygon.size()];
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

Moments piece_moments(const CellPolygon& piece, int q, const GaussRule& gauss,
                      DensityProbe& probe) {
    const Box box = lattice_box(piece);
    const Vec2 size = box.high - box.low;
    const Vec2 period = ((box.low + box.high) / 2).array().floor();
    const bool whole =
        piece.size() == 4 && std::abs(lattice_area(piece) - size.prod()) <= kWhole * size.prod();
    if (whole) return whole_moments(piece[0], piece[1], piece[3], period, gauss, probe);
    Moments sum;
    for (std::size_t k = 1; k + 1 < piece.size(); ++k) {
        sum += triangle_moments(piece[0], piece[k], piece[k + 1], period, triangle_rule(q), probe);
    }
    return sum;
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
    for (Breaks& breaks : breaks_) {
        breaks.push_back(0);
        std::sort(breaks.begin(), breaks.end());
        breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
        if (!(breaks.front() >= 0 && breaks.back() < 1)) {
            throw InvalidInput("a break line of the density is not in [0, 1); wrap it");
        }
    }
}

std::vector<double> CellQuadrature::between(const Breaks& breaks, double low, double high) {
    std::vector<double> found;
    const auto period = static_cast<int>(std::floor(low));
    auto next = std::upper_bound(breaks.begin(), breaks.end(), low - period);
    for (int whole = period;; ++whole, next = breaks.begin()) {
        for (; next != breaks.end(); ++next) {
            if (whole + *next >= high) return found;
            found.push_back(whole + *next);
        }
    }
}

bool CellQuadrature::is_crossed(const CellPolygon& cell) const {
    const Box box = lattice_box(cell);
    for (const int axis : {0, 1}) {
        const Breaks& breaks = breaks_[axis];
        const double whole = std::floor(box.low[axis]);
        if (box.high[axis] > whole + 1) return true;
        if (breaks.size() == 1) continue;
        const auto next = std::upper_bound(breaks.begin(), breaks.end(), box.low[axis] - whole);
        if (next != breaks.end() && whole + *next < box.high[axis]) return true;
    }
    return false;
}

Moments CellQuadrature::operator()(const CellPolygon& cell, const Vec2& site, int q,
                                   DensityProbe& probe) const {
    Moments sum;
    if (!is_crossed(cell)) {
        const CellCorner apex{Vec2::Zero(), site};
        const Vec2 period = site.array().floor();
        const TriangleRule& rule = triangle_rule(q);
        for (std::size_t k = 0; k < cell.size(); ++k) {
            sum +=
                triangle_moments(apex, cell[k], cell[(k + 1) % cell.size()], period, rule, probe);
        }
        return sum;
    }
    const GaussRule gauss = gauss_rule(q, 0);
    const Box box = lattice_box(cell);
    CellPolygon rest = cell;
    CellPolygon strip;
    CellPolygon piece;
    CellPolygon swap;
    std::vector<double> us = between(breaks_[0], box.low.x(), box.high.x());
    us.push_back(box.high.x());
    for (const double u : us) {
        cut(rest, 0, u, strip, swap);
        rest.swap(swap);
        if (strip.size() < 3) continue;
        const Box span = lattice_box(strip);
        std::vector<double> vs = between(breaks_[1], span.low.y(), span.high.y());
        vs.push_back(span.high.y());
        for (const double v : vs) {
            cut(strip, 1, v, piece, swap);
            strip.swap(swap);
            if (piece.size() >= 3) sum += piece_moments(piece, q, gauss, probe);
        }
    }
    return sum;
}

}  // namespace pcvt
