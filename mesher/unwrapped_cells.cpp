#include "mesher/unwrapped_cells.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "mesher/predicates.hpp"
#include "mesher/vector_clones.hpp"

namespace pcvt {
namespace {

/// A triangle thinner than this has its circumcentre computed in more digits.
constexpr double kThin = 1e-4;
/// From corner 0, 1, 2 of a triangle to the next one and to the one before: looked up, since no
/// branch could be foretold.
constexpr std::array<int, 3> kToNext{1, 1, -2};
constexpr std::array<int, 3> kToPrevious{2, -1, -1};
constexpr int kSitesPerTask = 1 << 12;
/// Corners for which there is room at first.
constexpr std::size_t kFirstRoom = 512;

int next_round_site(const TorusTriangulation& t, int h) {
    return t.opposite(h + kToPrevious[h % 3]);
}

/// The maps from the frame and from the reduced basis, entry by entry.
struct Maps {
    double ax, bx, by;
    double ux, uy, vx, vy;
};

/// The circumcentres of the triangles (0, to, next).
PCVT_VECTOR_CLONES bool circumcentres(const Maps& maps, int n, const double* __restrict to_u,
                                      const double* __restrict to_v,
                                      const double* __restrict next_u,
                                      const double* __restrict next_v, double* __restrict x,
                                      double* __restrict y, double* __restrict u,
                                      double* __restrict v, double* __restrict thick) {
    const Maps m = maps;
    const double twice_area = 2 * m.ax * m.by;
    for (int k = 0; k < n; ++k) {
        const double left = to_u[k] * next_v[k];
        const double right = to_v[k] * next_u[k];
        const double cross = left - right;
        thick[k] = cross - kThin * (std::abs(left) + std::abs(right));
        const double px = m.ax * to_u[k] + m.bx * to_v[k];
        const double py = m.by * to_v[k];
        const double qx = m.ax * next_u[k] + m.bx * next_v[k];
        const double qy = m.by * next_v[k];
        const double pp = px * px + py * py;
        const double qq = qx * qx + qy * qy;
        const double scale = 1 / (cross * twice_area);
        const double cx = (pp * qy - qq * py) * scale;
        const double cy = (qq * px - pp * qx) * scale;
        x[k] = cx;
        y[k] = cy;
        u[k] = m.ux * cx + m.uy * cy;
        v[k] = m.vx * cx + m.vy * cy;
    }
    int n_thin = 0;
    for (int k = 0; k < n; ++k) n_thin += thick[k] > 0 ? 0 : 1;
    return n_thin > 0;
}

}  // namespace

void CellList::make_room(std::size_t n_corners) {
    if (n_corners <= halfedges.size()) return;
    const std::size_t n = std::max(2 * n_corners, kFirstRoom);
    halfedges.resize(n);
    for (auto* array : {&to_u, &to_v, &next_u, &next_v, &x, &y, &u, &v, &thick}) array->resize(n);
}

LatticeBox CellList::box(std::size_t k) const {
    LatticeBox box{{u[begin[k]], v[begin[k]]}, {u[begin[k]], v[begin[k]]}};
    for (int c = begin[k] + 1; c < begin[k + 1]; ++c) {
        box.low.x() = std::min(box.low.x(), u[c]);
        box.low.y() = std::min(box.low.y(), v[c]);
        box.high.x() = std::max(box.high.x(), u[c]);
        box.high.y() = std::max(box.high.y(), v[c]);
    }
    return box;
}

void CellList::copy(std::size_t k, const Vec2& site, CellPolygon& polygon) const {
    polygon.clear();
    for (int c = begin[k]; c < begin[k + 1]; ++c) {
        polygon.push_back({{x[c], y[c]}, site + Vec2(u[c], v[c])});
    }
}

UnwrappedCells::UnwrappedCells(const MovingDelaunay& delaunay, Workers& workers,
                               const Lattice& lattice)
    : delaunay_(delaunay),
      workers_(workers),
      leaving_(delaunay.n_sites()),
      rings_(delaunay.n_sites()),
      ring_length_(delaunay.n_sites()) {
    const Reduction reduction = reduce(lattice);
    from_reduced_ << reduction.m[0], reduction.m[2], reduction.m[1], reduction.m[3];
    const MovingDelaunay::Frame& frame = delaunay.frame();
    Eigen::Matrix2d to_frame;
    to_frame << frame.ax, frame.bx, 0, frame.by;
    from_frame_ = from_reduced_ * to_frame.inverse();
}

void UnwrappedCells::locate() {
    const TorusTriangulation& t = delaunay_.triangulation();
    const DelaunayCounts& counts = delaunay_.counts();
    if (counts.n_flips == n_flips_ && counts.n_rebuilds == n_rebuilds_) return;
    const std::span<const SiteId> corner_site = t.corner_sites();
    for (int h = t.n_halfedges(); h-- > 0;) leaving_[corner_site[h]] = h;
    const int n = delaunay_.n_sites();
    workers_.for_each((n + kSitesPerTask - 1) / kSitesPerTask, [&](int task) {
        const SiteId end = std::min((task + 1) * kSitesPerTask, n);
        for (SiteId s = task * kSitesPerTask; s < end; ++s) find_ring(s);
    });
    n_flips_ = counts.n_flips;
    n_rebuilds_ = counts.n_rebuilds;
}

/// The ring as it was is a good guess: where it holds no load has to wait for the one before.
void UnwrappedCells::find_ring(SiteId site) {
    const TorusTriangulation& t = delaunay_.triangulation();
    Ring& ring = rings_[site];
    const int first = leaving_[site];
    if (ring.halfedges[0] == first) {
        for (int k = 0; k < kRingLength; ++k) {
            const int h = next_round_site(t, ring.halfedges[k]);
            if (h == first) {
                ring_length_[site] = static_cast<std::uint8_t>(k + 1);
                return;
            }
            if (k + 1 == kRingLength || ring.halfedges[k + 1] != h) break;
        }
    }
    int n = 0;
    int h = first;
    do {
        if (n < kRingLength) ring.halfedges[n] = h;
        ++n;
        h = next_round_site(t, h);
    } while (h != first);
    ring_length_[site] = static_cast<std::uint8_t>(std::min(n, kRingLength + 1));
}

/// The halfedges round a site that has more neighbours than fit into a ring; returns their number.
int UnwrappedCells::walk(SiteId site, int begin, CellList& cells) const {
    const TorusTriangulation& t = delaunay_.triangulation();
    const int first = leaving_[site];
    int n = begin;
    int h = first;
    do {
        cells.make_room(n + 1);
        cells.halfedges[n++] = h;
        h = next_round_site(t, h);
    } while (h != first);
    return n - begin;
}

void UnwrappedCells::find_neighbours(std::span<const SiteId> sites, CellList& cells) const {
    const TorusTriangulation& t = delaunay_.triangulation();
    const SiteId* const corner_site = t.corner_sites().data();
    const CornerOffsets* const offsets = t.corner_offsets().data();
    const double* const coordinates = delaunay_.coordinates().data();
    cells.begin.resize(sites.size() + 1);
    cells.shifted.clear();
    int n = 0;
    for (std::size_t k = 0; k < sites.size(); ++k) {
        const SiteId site = sites[k];
        cells.begin[k] = n;
        cells.make_room(n + kRingLength);
        int length = ring_length_[site];
        if (length <= kRingLength) {
            std::memcpy(cells.halfedges.data() + n, &rings_[site], sizeof(Ring));
        } else {
            length = walk(site, n, cells);
        }
        const int* const halfedges = cells.halfedges.data() + n;
        double* const to_u = cells.to_u.data() + n;
        double* const to_v = cells.to_v.data() + n;
        const double u = coordinates[2 * std::size_t(site)];
        const double v = coordinates[2 * std::size_t(site) + 1];
        for (int c = 0; c < length; ++c) {
            const int h = halfedges[c];
            const int triangle = h / 3;
            const SiteId neighbour = corner_site[h + kToNext[h - 3 * triangle]];
            const double* const to = coordinates + 2 * std::size_t(neighbour);
            to_u[c] = to[0] - u;
            to_v[c] = to[1] - v;
            if (!offsets[triangle].all_zero()) cells.shifted.push_back(n + c);
        }
        n += length;
    }
    cells.begin[sites.size()] = n;
    double* const to_u = cells.to_u.data();
    double* const to_v = cells.to_v.data();
    for (const int c : cells.shifted) {
        const Offset offset = t.edge_offset(cells.halfedges[c]);
        to_u[c] += offset.i;
        to_v[c] += offset.j;
    }
    double* const next_u = cells.next_u.data();
    double* const next_v = cells.next_v.data();
    std::copy(to_u + 1, to_u + n, next_u);
    std::copy(to_v + 1, to_v + n, next_v);
    for (std::size_t k = 0; k < sites.size(); ++k) {
        next_u[cells.begin[k + 1] - 1] = to_u[cells.begin[k]];
        next_v[cells.begin[k + 1] - 1] = to_v[cells.begin[k]];
    }
}

/// The centre of h's triangle relative to the site that h leaves; frame, units.
Vec2 UnwrappedCells::thin_centre(int h) const {
    const TorusTriangulation& t = delaunay_.triangulation();
    const auto at = [&](int g) {
        const Corner c = t.corner(g);
        return image(delaunay_.coordinates(), c.site, c.offset);
    };
    const MovingDelaunay::Frame& frame = delaunay_.frame();
    const Gram gram{frame.ax * frame.ax, frame.ax * frame.bx,
                    frame.bx * frame.bx + frame.by * frame.by};
    return frame.to_plane(circumcentre(gram, at(h), at(t.next(h)), at(t.previous(h))));
}

void UnwrappedCells::find_corners(CellList& cells) const {
    const MovingDelaunay::Frame& frame = delaunay_.frame();
    const Maps maps{frame.ax,          frame.bx,          frame.by,         from_frame_(0, 0),
                    from_frame_(0, 1), from_frame_(1, 0), from_frame_(1, 1)};
    const int n = cells.begin.back();
    const bool any_thin = circumcentres(maps, n, cells.to_u.data(), cells.to_v.data(), cells.next_u.data(),
                  cells.next_v.data(), cells.x.data(), cells.y.data(), cells.u.data(),
                  cells.v.data(), cells.thick.data());
    if (!any_thin) return;
    for (int c = 0; c < n; ++c) {
        if (cells.thick[c] > 0) continue;
        const Vec2 centre = thin_centre(cells.halfedges[c]);
        const Vec2 place = from_frame_ * centre;
        cells.x[c] = centre.x();
        cells.y[c] = centre.y();
        cells.u[c] = place.x();
        cells.v[c] = place.y();
    }
}

void UnwrappedCells::unwrap(std::span<const SiteId> sites, CellList& cells) const {
    find_neighbours(sites, cells);
    find_corners(cells);
}

}  // namespace pcvt
