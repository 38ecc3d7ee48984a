#include "mesher/plane/power/power_cells.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/plane/delaunay/predicates.hpp"
#include "mesher/portable/wide_double.hpp"

namespace pcvt::plane {
namespace {

constexpr int kTrianglesPerTask = 1 << 14;
constexpr int kSitesPerTask = 1 << 13;
/// A triangle is thin if its cross product is below this fraction of its rounding scale.
constexpr double kThin = 0x1p-6;

/// Runs task(k) for k = 0 ... n - 1, `n_per_task` at a time.
template <class Task>
void for_each(int n, int n_per_task, Workers& workers, const Task& task) {
    workers.for_each((n + n_per_task - 1) / n_per_task, [&](int chunk) {
        const int end = std::min((chunk + 1) * n_per_task, n);
        for (int k = chunk * n_per_task; k < end; ++k) task(k);
    });
}

/// The sides of a triangle, coordinates of the reduced basis, exact.
std::array<Vec2, 3> sides(const WeightedTriangulation& regular, int triangle) {
    const SiteId* site = regular.triangulation.corner_sites().data() + 3 * std::size_t(triangle);
    const CornerOffsets& o = regular.triangulation.corner_offsets()[triangle];
    const Points& u = regular.coordinates;
    const Vec2 p = u.col(site[1]) - u.col(site[0]) + Vec2(o.i1, o.j1);
    const Vec2 q = u.col(site[2]) - u.col(site[0]) + Vec2(o.i2, o.j2);
    return {p, q - p, -q};
}

/// Computes, in `Number`, the heights of the three sides and the part of each corner's cell.
template <class Number>
void measure_triangle(const std::array<Vec2, 3>& side, const ReducedFrame& frame,
                      const std::array<double, 3>& weight, double* height, double* mass) {
    using Vector = Eigen::Matrix<Number, 2, 1>;
    std::array<Vector, 3> d;
    for (int k = 0; k < 3; ++k) {
        const Vector u = side[k].cast<Number>();
        d[k] = {frame.ax * u.x() + frame.bx * u.y(), frame.by * u.y()};
    }
    const Number per_area = 1 / (2 * (d[0].x() * d[1].y() - d[0].y() * d[1].x()));
    // The cosine at each corner, scaled by the lengths of its sides.
    const std::array<Number, 3> cosine{-d[2].dot(d[0]), -d[0].dot(d[1]), -d[1].dot(d[2])};
    std::array<Number, 3> at_begin;
    std::array<Number, 3> at_end;
    for (int k = 0; k < 3; ++k) {
        const int m = (k + 1) % 3;
        const int o = (k + 2) % 3;
        const Number squared = d[k].squaredNorm();
        const Number from_o = Number(weight[k]) - Number(weight[o]);
        const Number from_m = Number(weight[k]) - Number(weight[m]);
        const Number lift = cosine[m] * from_o + cosine[k] * (from_o - from_m);
        const Number e = (cosine[o] + lift / squared) * per_area;
        height[k] = static_cast<double>(e);
        at_begin[k] = e * (squared + from_m) / 4;
        at_end[k] = e * (squared - from_m) / 4;
    }
    for (int k = 0; k < 3; ++k) mass[k] = static_cast<double>(at_begin[k] + at_end[(k + 2) % 3]);
}

/// Measures a triangle, in wide numbers if it is thin: its heights are quotients of small
/// differences, because the terms of the weights nearly cancel and their rounding errors are
/// divided by the area.
void measure_triangle(const WeightedTriangulation& regular, int triangle, double* height,
                      double* mass) {
    const SiteId* site = regular.triangulation.corner_sites().data() + 3 * std::size_t(triangle);
    const std::array<Vec2, 3> side = sides(regular, triangle);
    const std::array<double, 3> weight{regular.weights[site[0]], regular.weights[site[1]],
                                       regular.weights[site[2]]};
    if (detail::cross(side[0], side[1]) > kThin * detail::cross_bound(side[0], side[1])) {
        measure_triangle<double>(side, regular.frame, weight, height, mass);
    } else {
        measure_triangle<WideDouble>(side, regular.frame, weight, height, mass);
    }
}

/// One halfedge that leaves each site.
std::vector<int> outgoing_halfedges(const TorusTriangulation& t) {
    std::vector<int> outgoing(static_cast<std::size_t>(t.n_sites()));
    const std::span<const SiteId> sites = t.corner_sites();
    for (int h = t.n_halfedges(); h-- > 0;) outgoing[sites[h]] = h;
    return outgoing;
}

/// The side between a cell and the cell of `neighbour`.
struct CellSide {
    SiteId neighbour;
    /// The vector from the site to the neighbour, and its squared length.
    Vec2 d;
    double squared;
    double foot;
    /// The heights of the orthocentres to the left and to the right of d, over |d|.
    double left;
    double right;
};

/// Calls visit(CellSide) for each side of the cell of the site that h leaves, counter-clockwise.
template <class Visit>
void for_each_side(const WeightedTriangulation& regular, const std::vector<double>& heights, int h,
                   const Visit& visit) {
    const TorusTriangulation& t = regular.triangulation;
    const SiteId site = t.corner_sites()[h];
    const int first = h;
    do {
        const SiteId neighbour = t.corner_sites()[TorusTriangulation::next(h)];
        const Offset offset = t.edge_offset(h);
        const Vec2 u = regular.coordinates.col(neighbour) - regular.coordinates.col(site) +
                       Vec2(offset.i, offset.j);
        CellSide side{.neighbour = neighbour,
                      .d = regular.frame.to_position(u),
                      .squared = 0,
                      .foot = 0,
                      .left = heights[h],
                      .right = heights[t.opposite(h)]};
        side.squared = side.d.squaredNorm();
        side.foot = 0.5 + (regular.weights[site] - regular.weights[neighbour]) / (2 * side.squared);
        visit(side);
        h = t.next_round_site(h);
    } while (h != first);
}

double mass_of(const CellSide& side) {
    return 0.5 * side.foot * (side.left + side.right) * side.squared;
}

}  // namespace

void measure_masses(const WeightedTriangulation& regular, Workers& workers,
                    std::vector<double>& heights, Eigen::VectorXd& mass) {
    // Measure the triangles in parallel, then add up in their order.
    const int n_triangles = regular.triangulation.n_triangles();
    heights.resize(3 * std::size_t(n_triangles));
    std::vector<double> parts(heights.size());
    for_each(n_triangles, kTrianglesPerTask, workers, [&](int triangle) {
        const std::size_t h = 3 * std::size_t(triangle);
        measure_triangle(regular, triangle, heights.data() + h, parts.data() + h);
    });
    mass.setZero(regular.triangulation.n_sites());
    const std::span<const SiteId> sites = regular.triangulation.corner_sites();
    for (std::size_t h = 0; h < parts.size(); ++h) mass[sites[h]] += parts[h];
}

void measure_cells(const WeightedTriangulation& regular, const std::vector<double>& heights,
                   Workers& workers, Energy& cells) {
    const std::vector<int> outgoing = outgoing_halfedges(regular.triangulation);
    const int n = regular.triangulation.n_sites();
    cells.mass.resize(n);
    cells.gradient.resize(2 * Eigen::Index{n});
    Eigen::VectorXd energy(n);
    for_each(n, kSitesPerTask, workers, [&](int s) {
        double mass = 0;
        double second = 0;
        Vec2 first = Vec2::Zero();
        for_each_side(regular, heights, outgoing[s], [&](const CellSide& side) {
            const auto& [neighbour, d, squared, f, left, right] = side;
            mass += mass_of(side);
            first += (f * f * (left + right) * squared / 3) * d +
                     (f * (left * left - right * right) * squared / 6) * Vec2(-d.y(), d.x());
            const double cubes = left * left * left + right * right * right;
            second += f * squared * squared * (3 * f * f * (left + right) + cubes) / 12;
        });
        cells.mass[s] = mass;
        cells.gradient.segment<2>(2 * Eigen::Index{s}) = -2 * first;
        energy[s] = second;
    });
    cells.value = 0;
    for (const double part : energy) cells.value += part;
}

void assemble_cell_graph(const WeightedTriangulation& regular, const std::vector<double>& heights,
                         Workers& workers, CellGraph& graph) {
    const TorusTriangulation& t = regular.triangulation;
    const std::span<const SiteId> sites = t.corner_sites();
    // Count the edges of each cell.
    graph.row_begin.assign(static_cast<std::size_t>(t.n_sites()) + 1, 0);
    for (int h = 0; h < t.n_halfedges(); ++h) {
        if (sites[h] != sites[TorusTriangulation::next(h)]) ++graph.row_begin[sites[h] + 1];
    }
    for (int s = 0; s < t.n_sites(); ++s) graph.row_begin[s + 1] += graph.row_begin[s];
    // Fill the rows. The sum of two heights has the same bits from both sides.
    graph.neighbour.resize(static_cast<std::size_t>(graph.row_begin.back()));
    graph.conductance.resize(graph.neighbour.size());
    const std::vector<int> outgoing = outgoing_halfedges(t);
    for_each(t.n_sites(), kSitesPerTask, workers, [&](int s) {
        int k = graph.row_begin[s];
        const int first = outgoing[s];
        int h = first;
        do {
            const SiteId neighbour = sites[TorusTriangulation::next(h)];
            if (neighbour != s) {
                graph.neighbour[k] = neighbour;
                graph.conductance[k++] = std::max(0.0, (heights[h] + heights[t.opposite(h)]) / 2);
            }
            h = t.next_round_site(h);
        } while (h != first);
    });
}

namespace {

/// The integrals over a side, over |d|, of r_i r_i^T, r_i r_j^T, r_i, r_j and 1.
struct SideMoments {
    Eigen::Matrix2d own;
    Eigen::Matrix2d mixed;
    Vec2 first;
    Vec2 first_of_neighbour;
    double length;
};

SideMoments moments_of(const CellSide& side) {
    const auto& [neighbour, d, squared, f, left, right] = side;
    // Points of the side are x_i + f d + t across, with t from -right to left.
    const Vec2 across(-d.y(), d.x());
    const double length = left + right;
    const double first = (left * left - right * right) / 2;
    const double second = (left * left * left + right * right * right) / 3;
    const Eigen::Matrix2d dd = d * d.transpose();
    const Eigen::Matrix2d da = d * across.transpose();
    const Eigen::Matrix2d aa = second * across * across.transpose();
    const double g = f - 1;
    return {.own = f * f * length * dd + f * first * (da + da.transpose()) + aa,
            .mixed = f * g * length * dd + first * (f * da + g * da.transpose()) + aa,
            .first = f * length * d + first * across,
            .first_of_neighbour = g * length * d + first * across,
            .length = length};
}

BlockMatrix::Block rounded_block(double xx, double yx, double xy, double yy) {
    return {static_cast<float>(xx), static_cast<float>(yx), static_cast<float>(xy),
            static_cast<float>(yy)};
}

}  // namespace

void assemble_moment_derivatives(const WeightedTriangulation& regular,
                                 const std::vector<double>& heights, double unit,
                                 BlockMatrix& matrix) {
    const int n = regular.triangulation.n_sites();
    const std::vector<int> outgoing = outgoing_halfedges(regular.triangulation);
    std::vector<int> n_entries(2 * static_cast<std::size_t>(n), 1);
    for (SiteId s = 0; s < n; ++s) {
        for_each_side(regular, heights, outgoing[s], [&](const CellSide& side) {
            if (side.neighbour == s) return;
            n_entries[2 * s] += 2;
            n_entries[2 * s + 1] += 2;
        });
    }
    matrix.resize(n_entries);
    for (SiteId s = 0; s < n; ++s) {
        Eigen::Matrix2d own = Eigen::Matrix2d::Zero();
        Vec2 first = Vec2::Zero();
        double length = 0;
        int of_site = matrix.row_begin[2 * s];
        int of_weight = matrix.row_begin[2 * s + 1];
        const auto add = [&](int& at, int column, const BlockMatrix::Block& block) {
            matrix.column[at] = column;
            matrix.block[at++] = block;
        };
        for_each_side(regular, heights, outgoing[s], [&](const CellSide& side) {
            const SideMoments m = moments_of(side);
            own += m.own;
            first += m.first;
            length += m.length;
            const int t = side.neighbour;
            if (t == s) {
                // An image of the site itself moves with it.
                own -= (m.mixed + m.mixed.transpose()) / 2;
                first -= (m.first + m.first_of_neighbour) / 2;
                length -= m.length;
                return;
            }
            const Eigen::Matrix2d& q = m.mixed;
            const Vec2 a = unit * m.first;
            const Vec2 b = unit * m.first_of_neighbour;
            add(of_site, 2 * t, rounded_block(-q(0, 0), -q(1, 0), -q(0, 1), -q(1, 1)));
            add(of_site, 2 * t + 1, rounded_block(-a.x(), -a.y(), 0, 0));
            add(of_weight, 2 * t, rounded_block(-b.x(), 0, -b.y(), 0));
            add(of_weight, 2 * t + 1, rounded_block(-unit * unit * m.length, 0, 0, 0));
        });
        first *= unit;
        length *= unit * unit;
        add(of_site, 2 * s + 1, rounded_block(first.x(), first.y(), 0, 0));
        add(of_weight, 2 * s, rounded_block(first.x(), 0, first.y(), 0));
        matrix.diagonal[2 * s] = {own(0, 0), own(1, 0), own(0, 1), own(1, 1)};
        matrix.diagonal[2 * s + 1] = {length, 0, 0, length > 0 ? length : 1};
    }
}

}  // namespace pcvt::plane
