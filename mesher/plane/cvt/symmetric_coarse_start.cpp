#include "mesher/plane/cvt/symmetric_coarse_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/symmetry/folded_density.hpp"

namespace pcvt::plane {
namespace {

/// A Delaunay edge whose Voronoi edge is shorter than this part of its length joins sites that are
/// cocircular with two others up to rounding.
constexpr double kTie = 1e-6;

/// A new site, length units.
struct NewSite {
    Vec2 at;
    /// The local h of the finer level.
    double spacing;
};

/// The sites that the edges of one level add.
struct NewSites {
    std::vector<NewSite> at_midpoints;
    std::vector<NewSite> at_thirds;
};

/// The optimised sites of one level.
class Level {
   public:
    Level(const SymmetricSites& start, const CvtResult& result)
        : start_(start), sites_(result.delaunay.sites()), t_(result.delaunay.triangulation()) {}

    Vec2 position(int orbit) const {
        return reduced().to_position(sites_.coordinates().col(start_.orbits[orbit].representative));
    }
    const Vec2 coordinates(int orbit) const {
        return sites_.coordinates().col(start_.orbits[orbit].representative);
    }
    const Lattice& reduced() const { return sites_.reduction().reduced; }

    /// @param spacing  per orbit: becomes the mean over the edges of its representative.
    NewSites new_sites(std::vector<double>& spacing) const {
        NewSites added;
        std::vector<int> n_edges(start_.orbits.size());
        for (int h = 0; h < t_.n_halfedges(); ++h) {
            checkpoint_each(h);
            const Corner from = t_.corner(h);
            const int orbit = start_.orbit[from.site];
            if (start_.orbits[orbit].representative != from.site || is_tie(h)) continue;
            const Vec2 u = way(from, t_.corner(TorusTriangulation::next(h)));
            const double own = kSpacingPerEdge * reduced().to_position(u).norm() / 2;
            spacing[orbit] += (own - spacing[orbit]) / ++n_edges[orbit];
            add(h, u, own, added);
        }
        return added;
    }

   private:
    Vec2 way(const Corner& from, const Corner& to) const {
        return difference(image(sites_.coordinates(), from.site, from.offset),
                          image(sites_.coordinates(), to.site, to.offset));
    }

    /// The cotangent of the angle opposite to the halfedge.
    double opposite_cotangent(int h) const {
        const Corner apex = t_.corner(TorusTriangulation::previous(h));
        const Vec2 p = reduced().to_position(way(apex, t_.corner(h)));
        const Vec2 q = reduced().to_position(way(apex, t_.corner(TorusTriangulation::next(h))));
        return p.dot(q) / (p.x() * q.y() - p.y() * q.x());
    }

    bool is_tie(int h) const {
        return opposite_cotangent(h) + opposite_cotangent(t_.opposite(h)) < 2 * kTie;
    }

    /// Appends the site of a halfedge from a representative, once for each orbit of edges.
    void add(int h, const Vec2& u, double spacing, NewSites& added) const {
        const int orbit = start_.orbit[t_.corner(h).site];
        const SiteId to = t_.corner(TorusTriangulation::next(h)).site;
        const int other = start_.orbit[to];
        if (start_.orbits[orbit].freedom < 2) return;
        const bool is_same = other == orbit;
        const bool is_later = start_.orbits[other].freedom < 2 || orbit < other;
        if (!is_same && !is_later) return;
        const Vec2 at = sites_.coordinates().col(t_.corner(h).site);
        if (is_same) {
            // The operation that maps the representative to the other end maps the edge that
            // leaves with this direction to the same edge in the opposite direction.
            const Vec2 backwards = -inverse_image(start_.ties[to].matrix, u);
            if (std::pair(backwards.x(), backwards.y()) < std::pair(u.x(), u.y())) return;
            if (backwards == u) {
                added.at_thirds.push_back({reduced().to_position(Vec2(at + u / 3)), spacing});
                return;
            }
        }
        added.at_midpoints.push_back({reduced().to_position(Vec2(at + u / 2)), spacing});
    }

    /// @param m  row by row, with determinant +1 or -1.
    static Vec2 inverse_image(const std::array<std::int8_t, 4>& m, const Vec2& u) {
        const int determinant = m[0] * m[3] - m[1] * m[2];
        return determinant * Vec2(m[3] * u.x() - m[1] * u.y(), -m[2] * u.x() + m[0] * u.y());
    }

    const SymmetricSites& start_;
    const Sites& sites_;
    const TorusTriangulation& t_;
};

/// Exactly n new sites: midpoints, then evenly distributed thirds, then random places.
std::vector<NewSite> chosen(NewSites added, std::size_t n, const Lattice& lattice, double h,
                            std::uint64_t seed) {
    std::vector<NewSite> sites = std::move(added.at_midpoints);
    if (sites.size() > n) sites.resize(n, {Vec2::Zero(), h});
    const std::size_t n_thirds = std::min(n - sites.size(), added.at_thirds.size());
    for (std::size_t k = 0; k < n_thirds; ++k) {
        sites.push_back(added.at_thirds[k * added.at_thirds.size() / n_thirds]);
    }
    if (sites.size() == n) return sites;
    const Points points = uniform_points(lattice, static_cast<int>(n - sites.size()), seed);
    for (Eigen::Index s = 0; s < points.cols(); ++s) sites.push_back({points.col(s), h});
    return sites;
}

/// The places of the next level, shaken.
/// @param even  whether all sites have the spacing of the finer level on average.
OrbitPlaces refined(const SymmetricSites& start, const CvtResult& result, OrbitPlaces places,
                    int n_finer, bool even, std::uint64_t seed) {
    const Level level(start, result);
    const PlaneGroup& group = start.group;
    const int n_general = static_cast<int>(places.general.cols());
    const double n_sites = start.sites.n_sites() + double(n_finer - n_general) * group.order();
    const double h = std::sqrt(group.lattice().area() / n_sites);
    std::vector<double> spacing(start.orbits.size(), h);
    const std::vector<NewSite> added =
        chosen(level.new_sites(spacing), static_cast<std::size_t>(n_finer - n_general),
               group.lattice(), h, seed);
    Shakes shakes(seed);
    const auto shake = [&](double own) { return kShake * (even ? h : own) * shakes.next(); };
    // Move the sites on mirrors along them; those at centres come first.
    int orbit =
        static_cast<int>(std::count(places.at_centres.begin(), places.at_centres.end(), true));
    const std::vector<MirrorLine> mirrors = special_positions(group).mirrors;
    for (std::size_t k = 0; k < mirrors.size(); ++k) {
        const auto& along = mirrors[k].along;
        const int axis = std::abs(along[0]) == 1 ? 0 : 1;
        const double length = level.reduced().to_position(Vec2(along[0], along[1])).norm();
        for (double& part : places.on_mirrors[k]) {
            const double through = double(mirrors[k].through[axis]) / kTwelfths;
            part = (level.coordinates(orbit)[axis] - through) * along[axis] +
                   shake(spacing[orbit]) / length;
            ++orbit;
        }
    }
    // Shake the sites in general positions, and append the new ones.
    places.general.resize(2, n_finer);
    for (int s = 0; s < n_finer; ++s) {
        const bool is_old = s < n_general;
        const double own = is_old ? spacing[orbit + s] : added[s - n_general].spacing;
        const double x = shake(own);
        const double y = shake(own);
        const Vec2 at = is_old ? level.position(orbit + s) : added[s - n_general].at;
        places.general.col(s) = at + Vec2(x, y);
    }
    return places;
}

}  // namespace

std::optional<SymmetricSites> symmetric_coarse_start(const PlaneGroup& group, const OrbitPlan& plan,
                                                     std::uint64_t seed,
                                                     const CoarseStartOptions& options) {
    std::optional<Density> density;
    if (options.density) density = folded_density(*options.density, group);
    const int n_others =
        n_sites(group, special_positions(group), plan) - plan.n_general * group.order();
    CoarseLevels levels(kLevelGrowth, {plan.n_general, group.order(), n_others}, seed, options.run);
    OrbitPlan coarsest = plan;
    coarsest.n_general = levels.n_coarsest();
    OrbitPlaces places = random_places(group, coarsest, seed, density);
    while (levels.next()) {
        const SymmetricSites start = numbered_by_columns(sites_at(group, places));
        const CvtResult result = compute_cvt(start, level_options(levels, options));
        if (levels.cancelled()) return std::nullopt;
        places = refined(start, result, std::move(places), levels.n_finer(), !options.density,
                         levels.seed());
    }
    return numbered_by_columns(sites_at(group, places));
}

}  // namespace pcvt::plane
