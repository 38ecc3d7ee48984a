#include "mesher/plane/energy/density_hessian.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// Number of points per evaluation that makes the cost of the call negligible.
constexpr std::size_t kEnoughPoints = 1 << 16;

const CellCorner& before(CellView cell, std::size_t k) {
    return k == 0 ? cell.back() : cell[k - 1];
}

/// Places the points of a rule on a part of a side, wrapped.
void place_points(const Vec2& from, const Vec2& to, const GaussRule& rule, DensityProbe& probe) {
    DensityPoint* points = probe.reserve(rule.nodes.size());
    for (const double node : rule.nodes) {
        const Vec2 u = from + node * (to - from);
        *points++ = probe.point(u - Vec2(u.array().floor()));
    }
}

/// 2 / |d| times the integrals over an edge of rho p p^T and rho p (p - d)^T.
struct EdgeIntegrals {
    /// Adds the part of the edge between two points.
    void add(const Vec2& from, const Vec2& to, const Vec2& d, const GaussRule& rule,
             const double* rho) {
        const double length = 2 * std::sqrt((to - from).squaredNorm() / d.squaredNorm());
        for (std::size_t g = 0; g < rule.nodes.size(); ++g) {
            const Vec2 p = from + rule.nodes[g] * (to - from);
            const Vec2 weighted = length * rule.weights[g] * rho[g] * p;
            own += weighted * p.transpose();
            mixed += weighted * (p - d).transpose();
        }
    }
    Eigen::Matrix2d own = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d mixed = Eigen::Matrix2d::Zero();
};

}  // namespace

void DensityHessian::resize(BlockMatrix& hessian) const {
    const TorusTriangulation& t = delaunay_.triangulation();
    const std::span<const SiteId> sites = t.corner_sites();
    std::vector<int> n_neighbours(delaunay_.n_sites());
    for (int h = 0; h < t.n_halfedges(); ++h) {
        n_neighbours[sites[h]] += sites[TorusTriangulation::next(h)] != sites[h];
    }
    hessian.resize(n_neighbours);
    hessian.annihilates_translations = false;
}

const GaussRule& DensityHessian::side_rule(SiteId site, SiteId neighbour) const {
    return line_rule(std::max(order_[site], order_[neighbour]));
}

void DensityHessian::place_side(const GaussRule& rule, const CellCorner& from, const CellCorner& to,
                                Rows& rows, DensityProbe& probe) const {
    quadrature_.cut_way(from.lattice, to.lattice, rows.shares);
    rows.n_parts.push_back(static_cast<int>(rows.shares.size()) - 1);
    const Vec2 edge_vector = to.lattice - from.lattice;
    for (std::size_t k = 1; k < rows.shares.size(); ++k) {
        place_points(from.lattice + rows.shares[k - 1] * edge_vector,
                     from.lattice + rows.shares[k] * edge_vector, rule, probe);
        rows.part_end.push_back(rows.shares[k]);
    }
}

void DensityHessian::fill_row(SiteId site, std::size_t k, Rows& rows, BlockMatrix& hessian) const {
    // Begin with the term of the mass.
    const CellView cell = rows.cell(k);
    Eigen::Matrix2d diagonal = 2 * mass_[site] * Eigen::Matrix2d::Identity();
    int entry = hessian.row_begin[site];
    // Add the integrals over each edge of the cell.
    for (std::size_t c = 0; c < cell.size(); ++c) {
        const std::size_t side = rows.cells.begin[k] + c;
        const SiteId neighbour = rows.cells.neighbours[side];
        const GaussRule& rule = side_rule(site, neighbour);
        const Vec2 from = before(cell, c).plane;
        const Vec2 edge_vector = cell[c].plane - from;
        EdgeIntegrals edge;
        double share = 0;
        for (int part = 0; part < rows.n_parts[side]; ++part) {
            const double end = rows.part_end[rows.next_part++];
            edge.add(from + share * edge_vector, from + end * edge_vector,
                     cells_.to_neighbour(rows.cells, side), rule, rows.next_rho);
            rows.next_rho += rule.nodes.size();
            share = end;
        }
        diagonal -= edge.own;
        if (neighbour == site) {
            diagonal += edge.mixed;
            continue;
        }
        hessian.column[entry] = neighbour;
        const Eigen::Matrix2f block = edge.mixed.cast<float>();
        hessian.block[entry++] = {block(0, 0), block(1, 0), block(0, 1), block(1, 1)};
    }
    // Symmetrise the diagonal block.
    const double beside = (diagonal(1, 0) + diagonal(0, 1)) / 2;
    hessian.diagonal[site] = {diagonal(0, 0), beside, beside, diagonal(1, 1)};
}

void DensityHessian::fill_rows(SiteId first, SiteId end, double per_unit, DensityProbe& probe,
                               BlockMatrix& hessian) const {
    std::vector<SiteId> sites(end - first);
    std::iota(sites.begin(), sites.end(), first);
    Rows rows;
    cells_.unwrap(sites, rows.cells);
    CellPolygon polygon;
    std::vector<double> rho;
    std::size_t n_filled = 0;
    for (std::size_t k = 0; k < sites.size(); ++k) {
        checkpoint_each(k);
        // Place the points of one more cell.
        rows.cells.copy(k, cells_.site(sites[k]), polygon);
        rows.corners.insert(rows.corners.end(), polygon.begin(), polygon.end());
        const CellView cell = rows.cell(k);
        for (std::size_t c = 0; c < cell.size(); ++c) {
            const SiteId neighbour = rows.cells.neighbours[rows.cells.begin[k] + c];
            place_side(side_rule(sites[k], neighbour), before(cell, c), cell[c], rows, probe);
        }
        if (k + 1 < sites.size() && probe.n_reserved() < kEnoughPoints) continue;
        // Evaluate the density, and fill the rows of the cells that have their points.
        const std::span<const double> values = probe.evaluate_reserved();
        rho.assign(values.begin(), values.end());
        for (double& number : rho) number *= per_unit;
        rows.next_rho = rho.data();
        for (; n_filled <= k; ++n_filled) fill_row(sites[n_filled], n_filled, rows, hessian);
    }
}

}  // namespace pcvt::plane
