#include "mesher/plane/density/site_rings.hpp"

#include <algorithm>

namespace pcvt::plane {
namespace {

constexpr int kSitesPerTask = 1 << 12;

}  // namespace

SiteRings::SiteRings(const MovingDelaunay& delaunay, Workers& workers)
    : delaunay_(delaunay),
      workers_(workers),
      leaving_(delaunay.n_sites()),
      rings_(delaunay.n_sites()) {}

/// The first corner of a cell must not depend on the history of flips: it determines the order of
/// sums and the pieces of a cut cell.
void SiteRings::find(SiteId site) {
    const TorusTriangulation& t = delaunay_.triangulation();
    const auto neighbour = [&](int h) { return t.corner_sites()[t.next(h)]; };
    int first = leaving_[site];
    int n = 0;
    bool is_near = true;
    go_round(site, [&](int h) {
        if (neighbour(h) < neighbour(first)) first = h;
        is_near &= !t.has_offsets(h);
        ++n;
    });
    leaving_[site] = first;
    Ring& ring = rings_[site];
    ring.length = is_near && n <= kMost ? n : 0;
    for (int k = 0, h = first; k < ring.length; ++k, h = t.next_round_site(h)) {
        ring.neighbours[k] = neighbour(h);
    }
}

void SiteRings::find_all() {
    const std::span<const SiteId> corner_sites = delaunay_.triangulation().corner_sites();
    for (int h = delaunay_.triangulation().n_halfedges(); h-- > 0;) leaving_[corner_sites[h]] = h;
    const int n = delaunay_.n_sites();
    workers_.for_each((n + kSitesPerTask - 1) / kSitesPerTask, [&](int task) {
        const SiteId end = std::min((task + 1) * kSitesPerTask, n);
        for (SiteId s = task * kSitesPerTask; s < end; ++s) find(s);
    });
}

/// A flip changes the rings of the four corners of its two triangles, and later flips of these
/// triangles keep these sites among their corners. Every site whose ring has changed is therefore
/// now a corner of a triangle in the log.
void SiteRings::update() {
    const FlipLog& log = delaunay_.flip_log();
    if (log.number != log_number_) {
        find_all();
        log_number_ = log.number;
        n_logged_ = log.triangles.size();
        return;
    }
    for (; n_logged_ < log.triangles.size(); ++n_logged_) {
        const int first = 3 * log.triangles[n_logged_];
        for (int h = first; h < first + 3; ++h) {
            const SiteId site = delaunay_.triangulation().corner_sites()[h];
            leaving_[site] = h;
            find(site);
        }
    }
}

}  // namespace pcvt::plane
