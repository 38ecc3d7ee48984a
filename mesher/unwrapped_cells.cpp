#include "mesher/unwrapped_cells.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesher/lanes.hpp"
#include "mesher/predicates.hpp"
#include "mesher/vector_clones.hpp"

namespace pcvt {
namespace {

/// A triangle thinner than this has its circumcentre computed in more digits.
constexpr double kThin = 1e-4;
constexpr int kSitesPerTask = 1 << 12;
/// Corners for which there is room at first.
constexpr std::size_t kFirstRoom = 512;

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
    if (n_corners <= neighbours.size()) return;
    const std::size_t n = std::max(2 * n_corners, kFirstRoom);
    neighbours.resize(n);
    for (auto* array : {&to_u, &to_v, &next_u, &next_v, &x, &y, &u, &v, &thick}) array->resize(n);
}

LatticeBox CellList::box(std::size_t k, const Vec2& site, double margin) const {
    double low_u = 0;
    double low_v = 0;
    double high_u = 0;
    double high_v = 0;
    for (int c = begin[k]; c < begin[k + 1]; ++c) {
        low_u = std::min(low_u, u[c]);
        low_v = std::min(low_v, v[c]);
        high_u = std::max(high_u, u[c]);
        high_v = std::max(high_v, v[c]);
    }
    return {{site.x() + low_u - margin, site.y() + low_v - margin},
            {site.x() + high_u + margin, site.y() + high_v + margin}};
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
    const FlipLog& log = delaunay_.flip_log();
    if (log.number == log_number_) {
        // Whose ring has changed is a corner of a triangle that a flip has made.
        for (; n_logged_ < log.triangles.size(); ++n_logged_) {
            const int h = 3 * log.triangles[n_logged_];
            for (int k = 0; k < 3; ++k) find_ring(h + k);
        }
        return;
    }
    for (int h = t.n_halfedges(); h-- > 0;) leaving_[t.corner_sites()[h]] = h;
    const int n = delaunay_.n_sites();
    workers_.for_each((n + kSitesPerTask - 1) / kSitesPerTask, [&](int task) {
        const SiteId end = std::min((task + 1) * kSitesPerTask, n);
        for (SiteId s = task * kSitesPerTask; s < end; ++s) find_ring(leaving_[s]);
    });
    log_number_ = log.number;
    n_logged_ = log.triangles.size();
}

/// Goes round the site that a halfedge leaves, from the neighbour of the least number on: where a
/// cell begins must not depend on the flips that led to it.
void UnwrappedCells::find_ring(int leaving) {
    const TorusTriangulation& t = delaunay_.triangulation();
    const std::span<const SiteId> corner_site = t.corner_sites();
    const SiteId site = corner_site[leaving];
    int first = leaving;
    int n = 0;
    int h = leaving;
    do {
        if (corner_site[t.next(h)] < corner_site[t.next(first)]) first = h;
        ++n;
        h = t.next_round_site(h);
    } while (h != leaving);
    leaving_[site] = first;
    ring_length_[site] = static_cast<std::uint8_t>(std::min(n, kRingLength + 1));
    for (int k = 0; k < std::min(n, kRingLength); ++k) {
        const SiteId neighbour = corner_site[t.next(first)];
        rings_[site].neighbours[k] = t.has_offsets(first) ? ~neighbour : neighbour;
        first = t.next_round_site(first);
    }
}

/// Calls take(h) for the halfedges that leave a site, in the order of its cell's corners.
template <class Take>
void UnwrappedCells::go_round(SiteId site, const Take& take) const {
    const TorusTriangulation& t = delaunay_.triangulation();
    const int first = leaving_[site];
    int h = first;
    do {
        take(h);
        h = t.next_round_site(h);
    } while (h != first);
}

/// The same where a ring does not tell all: of a site with many neighbours or at the seam.
int UnwrappedCells::find_far_neighbours(SiteId site, int begin, CellList& cells) const {
    const TorusTriangulation& t = delaunay_.triangulation();
    const auto at = [&](SiteId s) { return delaunay_.coordinates().col(s); };
    int n = begin;
    go_round(site, [&](int h) {
        cells.make_room(n + 1);
        const SiteId neighbour = t.corner_sites()[t.next(h)];
        const Offset offset = t.edge_offset(h);
        cells.neighbours[n] = neighbour;
        cells.to_u[n] = at(neighbour).x() - at(site).x() + offset.i;
        cells.to_v[n++] = at(neighbour).y() - at(site).y() + offset.j;
    });
    return n - begin;
}

void UnwrappedCells::find_neighbours(std::span<const SiteId> sites, CellList& cells) const {
    const double* const coordinates = delaunay_.coordinates().data();
    cells.begin.resize(sites.size() + 1);
    int n = 0;
    for (std::size_t k = 0; k < sites.size(); ++k) {
        const SiteId site = sites[k];
        const SiteId* const ring = rings_[site].neighbours.data();
        const int length = ring_length_[site];
        cells.begin[k] = n;
        cells.make_room(n + kRingLength);
        std::memcpy(cells.neighbours.data() + n, ring, sizeof(Ring));
        double* const to_u = cells.to_u.data() + n;
        double* const to_v = cells.to_v.data() + n;
        Pair from;
        std::memcpy(&from, coordinates + 2 * std::size_t(site), sizeof from);
        bool is_near = length <= kRingLength;
        for (int c = 0; c < length && is_near; ++c) {
            const SiteId neighbour = ring[c];
            if (neighbour < 0) {
                is_near = false;
                break;
            }
            Pair to;
            std::memcpy(&to, coordinates + 2 * std::size_t(neighbour), sizeof to);
            to -= from;
            to_u[c] = to[0];
            to_v[c] = to[1];
        }
        n += is_near ? length : find_far_neighbours(site, n, cells);
    }
    cells.begin[sites.size()] = n;
    double* const to_u = cells.to_u.data();
    double* const to_v = cells.to_v.data();
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

void UnwrappedCells::find_corners(std::span<const SiteId> sites, CellList& cells) const {
    const MovingDelaunay::Frame& frame = delaunay_.frame();
    const Maps maps{frame.ax,          frame.bx,          frame.by,         from_frame_(0, 0),
                    from_frame_(0, 1), from_frame_(1, 0), from_frame_(1, 1)};
    const int n = cells.begin.back();
    const bool any_thin = circumcentres(maps, n, cells.to_u.data(), cells.to_v.data(), cells.next_u.data(),
                  cells.next_v.data(), cells.x.data(), cells.y.data(), cells.u.data(),
                  cells.v.data(), cells.thick.data());
    if (!any_thin) return;
    for (std::size_t k = 0; k < sites.size(); ++k) {
        int c = cells.begin[k];
        go_round(sites[k], [&](int h) {
            if (!(cells.thick[c] > 0)) {
                const Vec2 centre = thin_centre(h);
                const Vec2 place = from_frame_ * centre;
                cells.x[c] = centre.x();
                cells.y[c] = centre.y();
                cells.u[c] = place.x();
                cells.v[c] = place.y();
            }
            ++c;
        });
    }
}

void UnwrappedCells::unwrap(std::span<const SiteId> sites, CellList& cells) const {
    find_neighbours(sites, cells);
    find_corners(sites, cells);
}

}  // namespace pcvt
