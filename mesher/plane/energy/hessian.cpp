#include "mesher/plane/energy/hessian.hpp"

#include <algorithm>

namespace pcvt::plane {
namespace {

constexpr int kTrianglesPerTask = 1 << 14;
constexpr int kHessianRowsPerTask = 1 << 13;

/// The vector from the origin of h to its target; coordinates of the reduced basis, exact.
Vec2 edge(const MovingDelaunay& delaunay, int h) {
    const TorusTriangulation& t = delaunay.triangulation();
    const Corner from = t.corner(h);
    const Corner to = t.corner(TorusTriangulation::next(h));
    return difference(image(delaunay.coordinates(), from.site, from.offset),
                      image(delaunay.coordinates(), to.site, to.offset));
}

/// Returns for each halfedge the cotangent of the opposite angle in its triangle.
std::vector<double> cotangents(const MovingDelaunay& delaunay, Workers& workers) {
    // Compute the three cotangents of each triangle in parallel.
    const int n_triangles = delaunay.triangulation().n_triangles();
    std::vector<double> cotangent(3 * std::size_t(n_triangles));
    const int n_tasks = (n_triangles + kTrianglesPerTask - 1) / kTrianglesPerTask;
    const double cell = delaunay.frame().ax * delaunay.frame().by;
    workers.for_each(n_tasks, [&](int task) {
        const int end = std::min((task + 1) * kTrianglesPerTask, n_triangles);
        for (int t = task * kTrianglesPerTask; t < end; ++t) {
            const Vec2 p = edge(delaunay, 3 * t);
            const Vec2 q = edge(delaunay, 3 * t + 1);
            const Vec2 r = edge(delaunay, 3 * t + 2);
            const Vec2 dp = delaunay.frame().to_position(p);
            const Vec2 dq = delaunay.frame().to_position(q);
            const Vec2 dr = delaunay.frame().to_position(r);
            const double area = detail::cross(p, q) * cell;
            cotangent[3 * std::size_t(t)] = -dq.dot(dr) / area;
            cotangent[3 * std::size_t(t) + 1] = -dr.dot(dp) / area;
            cotangent[3 * std::size_t(t) + 2] = -dp.dot(dq) / area;
        }
    });
    return cotangent;
}

/// Returns H_ij of the edge d from x_i to x_j, with the cotangents to its left and right.
/// Exchanging i and j transposes the block to the last bit.
BlockMatrix::Block edge_block(const Vec2& d, double left, double right) {
    const double sum = left + right;
    const double along = -0.25 * sum;
    const double across = sum * ((left * left + right * right) - left * right) / 12;
    const double twist = sum * (left - right) * d.squaredNorm() / 8;
    const double xx = d.x() * d.x();
    const double yy = d.y() * d.y();
    const double mixed = (along - across) * (d.x() * d.y());
    return {static_cast<float>(along * xx + across * yy), static_cast<float>(mixed - twist),
            static_cast<float>(mixed + twist), static_cast<float>(along * yy + across * xx)};
}

/// One halfedge that leaves each site, and the number of its halfedges to other sites.
struct Stars {
    explicit Stars(const TorusTriangulation& triangulation)
        : first(static_cast<std::size_t>(triangulation.n_sites())), n_neighbours(first.size()) {
        const std::span<const SiteId> sites = triangulation.corner_sites();
        for (int h = triangulation.n_halfedges() - 1; h >= 0; --h) {
            first[sites[h]] = h;
            n_neighbours[sites[h]] += sites[TorusTriangulation::next(h)] != sites[h];
        }
    }
    std::vector<int> first;
    std::vector<int> n_neighbours;
};

void fill_row(const MovingDelaunay& delaunay, const std::vector<double>& cotangent, SiteId site,
              int first, BlockMatrix& hessian) {
    const TorusTriangulation& t = delaunay.triangulation();
    BlockMatrix::DiagonalBlock& diagonal = hessian.diagonal[site];
    diagonal = {};
    int entry = hessian.row_begin[site];
    int h = first;
    do {
        const int opposite = t.opposite(h);
        const SiteId neighbour = t.corner_sites()[opposite];
        if (neighbour != site) {
            const Vec2 d = delaunay.frame().to_position(edge(delaunay, h));
            const BlockMatrix::Block b = edge_block(d, cotangent[h], cotangent[opposite]);
            hessian.column[entry] = neighbour;
            hessian.block[entry++] = b;
            for (std::size_t k = 0; k < b.size(); ++k) diagonal[k] -= b[k];
        }
        h = t.next_round_site(h);
    } while (h != first);
    // The sum is symmetric up to rounding, because the twists of a row sum to zero.
    diagonal[1] = diagonal[2] = 0.5 * (diagonal[1] + diagonal[2]);
}

}  // namespace

void assemble_hessian(const MovingDelaunay& delaunay, Workers& workers, BlockMatrix& hessian) {
    const std::vector<double> cotangent = cotangents(delaunay, workers);
    const Stars stars(delaunay.triangulation());
    hessian.resize(stars.n_neighbours);
    hessian.annihilates_translations = true;
    const int n = delaunay.n_sites();
    workers.for_each((n + kHessianRowsPerTask - 1) / kHessianRowsPerTask, [&](int task) {
        const int end = std::min((task + 1) * kHessianRowsPerTask, n);
        for (SiteId s = task * kHessianRowsPerTask; s < end; ++s) {
            fill_row(delaunay, cotangent, s, stars.first[s], hessian);
        }
    });
}

}  // namespace pcvt::plane
