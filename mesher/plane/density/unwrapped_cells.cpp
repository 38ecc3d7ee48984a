#include "mesher/plane/density/unwrapped_cells.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "mesher/base/simd.hpp"
#include "mesher/base/target_clones.hpp"
#include "mesher/plane/delaunay/predicates.hpp"

namespace pcvt::plane {
namespace {

/// The circumcentre of a triangle thinner than this is computed with more digits.
constexpr double kThin = 1e-4;
constexpr std::size_t kFirstRoom = 512;

/// The maps from the reduced basis to the frame, and from the frame to the user's lattice
/// coordinates.
struct Maps {
    double ax, bx, by;
    double ux, uy, vx, vy;
};

/// The arrays of a list.
struct CornerArrays {
    const double* to_u;
    const double* to_v;
    const double* next_u;
    const double* next_v;
    double* x;
    double* y;
    double* u;
    double* v;
    double* thick;
};

/// Computes n corners, rounded up to full lanes; returns whether any of the n triangles is thin.
PCVT_TARGET_CLONES bool circumcentres(const Maps& m, int n, const CornerArrays& arrays) {
    const double twice_area = 2 * m.ax * m.by;
    for (int k = 0; k < n; k += kLanes) {
        // Load the two neighbours relative to the site.
        Lanes to_u, to_v, next_u, next_v;
        std::memcpy(&to_u, arrays.to_u + k, sizeof to_u);
        std::memcpy(&to_v, arrays.to_v + k, sizeof to_v);
        std::memcpy(&next_u, arrays.next_u + k, sizeof next_u);
        std::memcpy(&next_v, arrays.next_v + k, sizeof next_v);
        // Measure the thickness of the triangle.
        const Lanes left = to_u * next_v;
        const Lanes right = to_v * next_u;
        const Lanes cross = left - right;
        const Lanes bound = (left < 0 ? -left : left) + (right < 0 ? -right : right);
        const Lanes thick = cross - kThin * bound;
        // Compute the circumcentre in the frame, and in lattice coordinates.
        const Lanes px = m.ax * to_u + m.bx * to_v;
        const Lanes py = m.by * to_v;
        const Lanes qx = m.ax * next_u + m.bx * next_v;
        const Lanes qy = m.by * next_v;
        const Lanes pp = px * px + py * py;
        const Lanes qq = qx * qx + qy * qy;
        const Lanes scale = 1 / (cross * twice_area);
        const Lanes x = (pp * qy - qq * py) * scale;
        const Lanes y = (qq * px - pp * qx) * scale;
        const Lanes u = m.ux * x + m.uy * y;
        const Lanes v = m.vx * x + m.vy * y;
        // Store the corner.
        std::memcpy(arrays.x + k, &x, sizeof x);
        std::memcpy(arrays.y + k, &y, sizeof y);
        std::memcpy(arrays.u + k, &u, sizeof u);
        std::memcpy(arrays.v + k, &v, sizeof v);
        std::memcpy(arrays.thick + k, &thick, sizeof thick);
    }
    int n_thin = 0;
    for (int k = 0; k < n; ++k) n_thin += arrays.thick[k] > 0 ? 0 : 1;
    return n_thin > 0;
}

}  // namespace

void CellList::make_room(int n_corners) {
    const int n_used = n_corners + kLanes;
    if (n_used <= static_cast<int>(neighbours.size())) return;
    const std::size_t n = std::max(2 * std::size_t(n_used), kFirstRoom);
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
    : delaunay_(delaunay), rings_(delaunay, workers) {
    const Reduction reduction = reduce(lattice);
    from_reduced_ << reduction.m[0], reduction.m[2], reduction.m[1], reduction.m[3];
    const ReducedFrame& frame = delaunay.frame();
    Eigen::Matrix2d to_frame;
    to_frame << frame.ax, frame.bx, 0, frame.by;
    from_frame_ = from_reduced_ * to_frame.inverse();
}

/// Copies the neighbours from a complete cached ring.
void UnwrappedCells::find_near_neighbours(SiteId site, int begin, CellList& cells) const {
    const double* const coordinates = delaunay_.coordinates().data();
    const SiteRings::Ring& ring = rings_[site];
    std::memcpy(cells.neighbours.data() + begin, ring.neighbours.data(), sizeof ring.neighbours);
    double* const to_u = cells.to_u.data() + begin;
    double* const to_v = cells.to_v.data() + begin;
    Pair from;
    std::memcpy(&from, coordinates + 2 * std::size_t(site), sizeof from);
    for (int c = 0; c < ring.length; ++c) {
        Pair to;
        std::memcpy(&to, coordinates + 2 * std::size_t(ring.neighbours[c]), sizeof to);
        to -= from;
        to_u[c] = to[0];
        to_v[c] = to[1];
    }
}

/// Writes the neighbours of a site; returns their number.
int UnwrappedCells::find_neighbours(SiteId site, int begin, CellList& cells) const {
    const int length = rings_[site].length;
    cells.make_room(begin + SiteRings::kMost);
    if (length > 0) {
        find_near_neighbours(site, begin, cells);
        return length;
    }
    const TorusTriangulation& t = delaunay_.triangulation();
    int n = begin;
    rings_.go_round(site, [&](int h) {
        cells.make_room(n + 1);
        const Corner from = t.corner(h);
        const Corner to = t.corner(TorusTriangulation::next(h));
        const Vec2 d = difference(image(delaunay_.coordinates(), from.site, from.offset),
                                  image(delaunay_.coordinates(), to.site, to.offset));
        cells.neighbours[n] = to.site;
        cells.to_u[n] = d.x();
        cells.to_v[n++] = d.y();
    });
    return n - begin;
}

void UnwrappedCells::find_neighbours(std::span<const SiteId> sites, CellList& cells) const {
    cells.begin.resize(sites.size() + 1);
    int n = 0;
    for (std::size_t k = 0; k < sites.size(); ++k) {
        cells.begin[k] = n;
        n += find_neighbours(sites[k], n, cells);
    }
    cells.begin[sites.size()] = n;
    std::copy_n(cells.to_u.begin() + 1, n - 1, cells.next_u.begin());
    std::copy_n(cells.to_v.begin() + 1, n - 1, cells.next_v.begin());
    for (std::size_t k = 0; k < sites.size(); ++k) {
        cells.next_u[cells.begin[k + 1] - 1] = cells.to_u[cells.begin[k]];
        cells.next_v[cells.begin[k + 1] - 1] = cells.to_v[cells.begin[k]];
    }
}

/// The circumcentre of h's triangle relative to the site that h leaves; frame, units.
Vec2 UnwrappedCells::thin_centre(int h) const {
    const TorusTriangulation& t = delaunay_.triangulation();
    const auto at = [&](int g) {
        const Corner c = t.corner(g);
        return image(delaunay_.coordinates(), c.site, c.offset);
    };
    const ReducedFrame& frame = delaunay_.frame();
    const Gram gram{frame.ax * frame.ax, frame.ax * frame.bx,
                    frame.bx * frame.bx + frame.by * frame.by};
    return frame.to_position(circumcentre(gram, at(h), at(t.next(h)), at(t.previous(h))));
}

void UnwrappedCells::find_corners(std::span<const SiteId> sites, CellList& cells) const {
    const ReducedFrame& frame = delaunay_.frame();
    const Maps maps{frame.ax,          frame.bx,          frame.by,         from_frame_(0, 0),
                    from_frame_(0, 1), from_frame_(1, 0), from_frame_(1, 1)};
    const CornerArrays arrays{cells.to_u.data(),   cells.to_v.data(), cells.next_u.data(),
                              cells.next_v.data(), cells.x.data(),    cells.y.data(),
                              cells.u.data(),      cells.v.data(),    cells.thick.data()};
    // Compute all corners in doubles.
    if (!circumcentres(maps, cells.begin.back(), arrays)) return;
    // Compute the corners of thin triangles again with more digits.
    int c = 0;
    for (const SiteId site : sites) {
        rings_.go_round(site, [&](int h) {
            const int corner = c++;
            if (cells.thick[corner] > 0) return;
            const Vec2 centre = thin_centre(h);
            const Vec2 place = from_frame_ * centre;
            cells.x[corner] = centre.x();
            cells.y[corner] = centre.y();
            cells.u[corner] = place.x();
            cells.v[corner] = place.y();
        });
    }
}

void UnwrappedCells::unwrap(std::span<const SiteId> sites, CellList& cells) const {
    find_neighbours(sites, cells);
    find_corners(sites, cells);
}

}  // namespace pcvt::plane
