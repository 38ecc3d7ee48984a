#include "mesher/plane/cvt/wall_rounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/symmetry/walled_sites.hpp"

namespace pcvt::plane {
namespace {

/// The search for half cells ends after this number of rounds. None of 2,000 random jobs with up to
/// 300 sites needed more.
constexpr int kMostRounds = 40;

/// The torus with the numbers of images exchanged so that the sites of the domain come first again:
/// in a long step a site and its image may pass through the wall between them.
PeriodicDelaunay with_domain_first(PeriodicDelaunay torus, const std::vector<int>& orbit,
                                   const WalledDomain& domain) {
    const int n = torus.sites().n_sites();
    const auto is_inside = [&](SiteId s) {
        const Vec2 p = torus.sites().position(s);
        for (int axis = 0; axis < 2; ++axis) {
            if (!has_walls_across(domain.walls, axis)) continue;
            const double side = side_length(domain.lattice, axis);
            if (p[axis] - std::floor(p[axis] / (2 * side)) * 2 * side > side) return false;
        }
        return true;
    };
    // The site of each orbit that lies in the domain; by rounding there may be two on a wall.
    std::vector<SiteId> inside(static_cast<std::size_t>(domain.n_sites), -1);
    std::vector<SiteId> first(static_cast<std::size_t>(domain.n_sites), -1);
    for (SiteId s = 0; s < n; ++s) {
        if (first[orbit[s]] < 0) first[orbit[s]] = s;
        if (inside[orbit[s]] < 0 && is_inside(s)) inside[orbit[s]] = s;
    }
    std::vector<SiteId> number(static_cast<std::size_t>(n));
    std::iota(number.begin(), number.end(), 0);
    bool any = false;
    for (std::size_t k = 0; k < inside.size(); ++k) {
        if (inside[k] < 0 || inside[k] == first[k]) continue;
        std::swap(number[first[k]], number[inside[k]]);
        any = true;
    }
    if (!any) return torus;
    Points coordinates(2, n);
    for (SiteId s = 0; s < n; ++s) {
        coordinates.col(number[s]) = torus.sites().coordinates().col(s);
    }
    TorusTriangulation triangulation = torus.triangulation();
    triangulation.renumber_sites(number);
    // Images have equal weights.
    return {Sites(torus.sites().lattice(), torus.sites().reduction(), std::move(coordinates)),
            std::move(triangulation), torus.weights()};
}

/// Sites for each square between two walls. In a survey of channels 4 and 12 times as long as wide,
/// with six seeds each, none had rows of half cells up to one site a square, nine of twelve at 1.5,
/// and all of them from this number on.
constexpr double kSitesPerSquare = 2;

/// Requires that the cell of a site on a wall does not reach the opposite one. It does unless a
/// site on the opposite wall is nearer to the point straight across than the walls are to each
/// other; so two alternating rows need more sites than the walls are longer than distant.
/// @param offset  from the site to a neighbouring image of itself.
void require_no_bridge(const PeriodicDelaunay& torus, Offset offset, const WalledDomain& domain) {
    const Vec2 way = torus.sites().reduction().reduced.translation(offset);
    for (int axis = 0; axis < 2; ++axis) {
        if (!has_walls_across(domain.walls, axis)) continue;
        const double distance = side_length(domain.lattice, axis);
        if (std::abs(way[axis]) < distance) continue;
        const double n =
            std::ceil(kSitesPerSquare * side_length(domain.lattice, 1 - axis) / distance);
        const bool is_known = domain.n_sites < n && n <= kMostSites;
        throw InvalidInput(
            "half cells need rows of sites on both walls, but the cell of a site on one wall "
            "reaches the opposite one; take " +
            (is_known ? "at least " + std::to_string(static_cast<int>(n)) + " sites"
                      : "more sites, another seed") +
            " or whole cells");
    }
}

/// Where the cell of a site off the walls meets its mirror images.
struct WallContact {
    /// Across x, and across y.
    std::array<bool, 2> across{false, false};
    bool holds_corner = false;
};

/// @param orbit  of each site of the torus.
/// @returns the contacts of the sites of the domain.
std::vector<WallContact> wall_contacts(const PeriodicDelaunay& torus, const std::vector<int>& orbit,
                                       const WalledDomain& domain) {
    const TorusTriangulation& triangulation = torus.triangulation();
    std::vector<WallContact> contacts(static_cast<std::size_t>(domain.n_sites));
    for (int h = 0; h < triangulation.n_halfedges(); ++h) {
        checkpoint_each(h);
        const SiteId s = triangulation.corner(h).site;
        const SiteId t = triangulation.corner(TorusTriangulation::next(h)).site;
        if (s >= domain.n_sites || orbit[s] != orbit[t]) continue;
        if (s == t) {
            require_no_bridge(torus, triangulation.edge_offset(h), domain);
            continue;
        }
        for (int axis = 0; axis < 2; ++axis) {
            // The image has another coordinate across the wall only.
            if (torus.sites().position(s)[axis] == torus.sites().position(t)[axis]) continue;
            contacts[s].across[axis] = has_walls_across(domain.walls, axis);
        }
        // Four images meet in a corner of walls.
        const SiteId third = triangulation.corner(TorusTriangulation::previous(h)).site;
        if (orbit[third] == orbit[s] && third != s) contacts[s].holds_corner = true;
    }
    return contacts;
}

/// The corners of the walls, numbered by the sides that meet there: bit k for the far side of axis
/// k.
struct WallCorners {
    std::array<bool, 4> is_taken{};

    bool& operator[](const std::array<double, 2>& wall) {
        return is_taken[(wall[0] > 0 ? 1 : 0) + (wall[1] > 0 ? 2 : 0)];
    }
};

/// Moves each site whose cell touches a wall onto it, and into a corner of walls only the site
/// whose cell holds the corner. A cell in a narrow domain may hold two corners, of which the nearer
/// one may have a site; then its site waits for the next round.
/// @param orbit  of each site of the torus.
/// @returns the number of coordinates that changed, and of sites that wait.
int move_onto_walls(const PeriodicDelaunay& torus, const std::vector<int>& orbit,
                    const WalledDomain& domain, Points& points) {
    const std::vector<WallContact> contacts = wall_contacts(torus, orbit, domain);
    std::vector<std::array<double, 2>> walls(static_cast<std::size_t>(domain.n_sites));
    WallCorners corners;
    for (SiteId s = 0; s < domain.n_sites; ++s) {
        for (int axis = 0; axis < 2; ++axis) {
            const double side = side_length(domain.lattice, axis);
            walls[s][axis] = points(axis, s) < side / 2 ? 0 : side;
        }
        if (points(0, s) == walls[s][0] && points(1, s) == walls[s][1]) corners[walls[s]] = true;
    }
    int n_moved = 0;
    for (SiteId s = 0; s < domain.n_sites; ++s) {
        const std::array<double, 2>& wall = walls[s];
        const auto& [across, holds_corner] = contacts[s];
        const bool is_at_corner = across[0] && across[1] && holds_corner;
        const bool waits = is_at_corner && corners[wall];
        if (is_at_corner) corners[wall] = true;
        n_moved += waits;
        const int nearest =
            std::abs(points(0, s) - wall[0]) < std::abs(points(1, s) - wall[1]) ? 0 : 1;
        for (int axis = 0; axis < 2; ++axis) {
            const bool is_second = across[1 - axis] && axis != nearest;
            if (!across[axis] || (is_second && (!holds_corner || waits))) continue;
            n_moved += points(axis, s) != wall[axis];
            points(axis, s) = wall[axis];
        }
    }
    return n_moved;
}

/// The first n_sites points of the torus, each replaced by its mirror image if that one lies
/// between the walls.
Points folded_between_walls(Points torus, const WalledDomain& domain) {
    Points points = torus.leftCols(domain.n_sites);
    for (int axis = 0; axis < 2; ++axis) {
        if (!has_walls_across(domain.walls, axis)) continue;
        const double side = side_length(domain.lattice, axis);
        for (double& at : points.row(axis)) {
            at -= std::floor(at / (2 * side)) * 2 * side;
            if (at > side) at = 2 * side - at;
        }
    }
    return points;
}

}  // namespace

Points points_between_walls(const PeriodicDelaunay& torus, const WalledDomain& domain) {
    Points points(2, domain.n_sites);
    for (SiteId s = 0; s < domain.n_sites; ++s) {
        Vec2 p = torus.sites().position(s);
        for (int axis = 0; axis < 2; ++axis) {
            if (!has_walls_across(domain.walls, axis)) continue;
            const double side = side_length(domain.lattice, axis);
            const double period = 2 * side;
            p[axis] = std::clamp(p[axis] - std::floor(p[axis] / period) * period, 0.0, side);
        }
        points.col(s) = p;
    }
    return points;
}

ProgressCallback progress_between_walls(const ProgressCallback& progress,
                                        const WalledDomain& domain, const RunStatistics& before) {
    if (!progress) return {};
    return [&progress, domain, &before](Progress of_torus) {
        of_torus.value /= domain.n_images();
        of_torus.iteration += before.iterations;
        of_torus.evaluations += before.evaluations;
        const auto* const on_torus = of_torus.positions;
        const std::function<Points()> between_walls = [&domain, on_torus] {
            return folded_between_walls((*on_torus)(), domain);
        };
        if (on_torus != nullptr) of_torus.positions = &between_walls;
        return progress(of_torus);
    };
}

WalledDomain run_wall_rounds(WalledDomain domain, WallCells cells, Points points,
                             const WallRound& round) {
    RunStatistics before;
    for (int k = 0; k < kMostRounds; ++k) {
        const SymmetricSites sites = walled_sites(domain.lattice, domain.walls, points);
        const WallRoundResult result = round(sites, before);
        result.run.add_counts(before);
        result.delaunay = with_domain_first(std::move(result.delaunay), sites.orbit, domain);
        domain.n_on_walls = 0;
        for (const SiteOrbit& orbit : sites.orbits) domain.n_on_walls += orbit.freedom < 2;
        bool ends = cells == WallCells::kWhole || result.run.stop == Stop::kCancelled;
        if (!ends) {
            points = points_between_walls(result.delaunay, domain);
            ends = move_onto_walls(result.delaunay, sites.orbit, domain, points) == 0;
        }
        before = result.run;
        if (!ends) continue;
        result.run.energy /= domain.n_images();
        return domain;
    }
    throw InvalidInput(
        "no cells of sites on the walls came about; take more sites, another seed or whole cells");
}

}  // namespace pcvt::plane
