#include "mesher/unwrapped_cells.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <span>

#include "mesher/polygon.hpp"
#include "mesher/predicates.hpp"

namespace pcvt {
namespace {

constexpr int kTrianglesPerTask = 1 << 13;
/// A triangle thinner than this has its circumcentre computed in more digits.
constexpr double kThin = 1e-4;

}  // namespace

UnwrappedCells::UnwrappedCells(const MovingDelaunay& delaunay, Workers& workers,
                               const Lattice& lattice)
    : delaunay_(delaunay),
      workers_(workers),
      leaving_(delaunay.n_sites()),
      centre_(6 * std::size_t(delaunay.n_sites())) {
    const Reduction reduction = reduce(lattice);
    from_reduced_ << reduction.m[0], reduction.m[2], reduction.m[1], reduction.m[3];
    const MovingDelaunay::Frame& frame = delaunay.frame();
    Eigen::Matrix2d to_frame;
    to_frame << frame.ax, frame.bx, 0, frame.by;
    from_frame_ = from_reduced_ * to_frame.inverse();
}

void UnwrappedCells::locate_centre(int triangle) {
    const TorusTriangulation& t = delaunay_.triangulation();
    std::array<Image, 3> at;
    for (int k = 0; k < 3; ++k) {
        const Corner c = t.corner(3 * triangle + k);
        at[k] = image(delaunay_.coordinates(), c.site, c.offset);
    }
    const Vec2 p = difference(at[0], at[1]);
    const Vec2 q = difference(at[0], at[2]);
    const MovingDelaunay::Frame& frame = delaunay_.frame();
    const Vec2 d = frame.to_plane(p);
    const Vec2 e = frame.to_plane(q);
    const auto set = [&](const Vec2& centre) {
        centre_[3 * triangle] = centre;
        centre_[3 * triangle + 1] = centre - d;
        centre_[3 * triangle + 2] = centre - e;
    };
    const double product = cross(p, q);
    if (!(product > kThin * detail::cross_bound(p, q))) {
        const Gram gram{frame.ax * frame.ax, frame.ax * frame.bx,
                        frame.bx * frame.bx + frame.by * frame.by};
        set(frame.to_plane(circumcentre(gram, at[0], at[1], at[2])));
        return;
    }
    const Vec2 weighted = d.squaredNorm() * e - e.squaredNorm() * d;
    set(Vec2(weighted.y(), -weighted.x()) / (2 * product * frame.ax * frame.by));
}

void UnwrappedCells::locate() {
    const TorusTriangulation& t = delaunay_.triangulation();
    const DelaunayCounts& counts = delaunay_.counts();
    if (counts.n_flips != n_flips_ || counts.n_rebuilds != n_rebuilds_) {
        const std::span<const SiteId> corner_site = t.corner_sites();
        for (int h = t.n_halfedges(); h-- > 0;) leaving_[corner_site[h]] = h;
        n_flips_ = counts.n_flips;
        n_rebuilds_ = counts.n_rebuilds;
    }
    const int n = t.n_triangles();
    workers_.for_each((n + kTrianglesPerTask - 1) / kTrianglesPerTask, [&](int task) {
        const int end = std::min((task + 1) * kTrianglesPerTask, n);
        for (int k = task * kTrianglesPerTask; k < end; ++k) locate_centre(k);
    });
}

/// First round all sites, where each load waits for the one before, while the centres are on their
/// way; only then what takes computing.
void UnwrappedCells::unwrap(std::span<const SiteId> sites, CellList& cells) const {
    const TorusTriangulation& t = delaunay_.triangulation();
    cells.halfedges.clear();
    cells.begin.clear();
    for (const SiteId site : sites) {
        cells.begin.push_back(static_cast<int>(cells.halfedges.size()));
        const int first = leaving_[site];
        int h = first;
        do {
            __builtin_prefetch(&centre_[h]);
            cells.halfedges.push_back(h);
            h = t.next_round_site(h);
        } while (h != first);
    }
    cells.begin.push_back(static_cast<int>(cells.halfedges.size()));
    cells.corners.resize(cells.halfedges.size());
    CellCorner* corner = cells.corners.data();
    const int* h = cells.halfedges.data();
    for (std::size_t k = 0; k < sites.size(); ++k) {
        const Vec2 origin = site(sites[k]);
        const CellCorner* const end = cells.corners.data() + cells.begin[k + 1];
        for (; corner != end; ++corner, ++h) {
            corner->plane = centre_[*h];
            corner->lattice = origin + from_frame_ * corner->plane;
        }
    }
}

}  // namespace pcvt
