#include "mesher/plane/cvt/interface_cvt.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/density/density_survey.hpp"
#include "mesher/plane/interfaces/empty_circles.hpp"
#include "mesher/plane/interfaces/free_sites.hpp"
#include "mesher/plane/interfaces/interface_fit.hpp"

namespace pcvt::plane {
namespace {

/// A site that has shortened this number of steps is held where it is.
constexpr int kMostRefusals = 20;

/// h at a point for n cells.
std::function<double(const Vec2&)> spacing_of(const Lattice& lattice, int n,
                                              const std::optional<Density>& density) {
    const double h = std::sqrt(lattice.area() / n);
    if (!density) return [h](const Vec2&) { return h; };
    DensitySurvey survey(lattice, *density, kSurveyResolution);
    const double scale = h * std::sqrt(std::sqrt(survey.mean_root_squared()));
    const auto probe = std::make_shared<DensityProbe>(lattice, density->make_function());
    return [scale, probe, lattice](const Vec2& p) {
        const Vec2 u = lattice.to_lattice(p);
        const Vec2 inside = u - Vec2(std::floor(u.x()), std::floor(u.y()));
        const DensityPoint point = probe->point(inside);
        return scale / std::sqrt(std::sqrt(probe->evaluate({&point, 1})[0]));
    };
}

/// Refuses positions with a free site inside of a circle, and counts the refusals of each site.
class CircleGuard final : public SiteGuard<MovingDelaunay> {
   public:
    CircleGuard(const EmptyCircles& circles, const std::vector<bool>& is_fixed)
        : circles_(circles), is_fixed_(is_fixed), n_refusals_(is_fixed.size(), 0) {}

    bool admits(const MovingDelaunay& delaunay) override {
        bool admitted = true;
        for (SiteId s = 0; s < delaunay.n_sites(); ++s) {
            const SiteId id = delaunay.original_id(s);
            if (is_fixed_[id] || !circles_.contain(delaunay.coordinates().col(s))) continue;
            most_refusals_ = std::max(most_refusals_, ++n_refusals_[id]);
            admitted = false;
        }
        return admitted;
    }
    bool is_blocked() const { return most_refusals_ >= kMostRefusals; }
    /// The sites that were refused most often; none if there was no refusal.
    std::vector<SiteId> blocked() const {
        std::vector<SiteId> found;
        if (most_refusals_ == 0) return found;
        const int least = std::min(most_refusals_, kMostRefusals);
        for (std::size_t s = 0; s < n_refusals_.size(); ++s) {
            if (n_refusals_[s] >= least) found.push_back(static_cast<SiteId>(s));
        }
        return found;
    }

   private:
    const EmptyCircles& circles_;
    const std::vector<bool>& is_fixed_;
    std::vector<int> n_refusals_;
    int most_refusals_ = 0;
};

/// Runs with the fixed sites, again and again with more of them where sites are blocked.
class GuardedRuns {
   public:
    GuardedRuns(const EmptyCircles& circles, int n_seeds) : circles_(circles), n_seeds_(n_seeds) {}

    CvtResult run(const Sites& start, const CvtOptions& options) {
        orbit_.resize(static_cast<std::size_t>(start.n_sites()));
        std::iota(orbit_.begin(), orbit_.end(), 0);
        return repeated_run(options, [&](const CvtResult* before, const CvtOptions& leg) {
            return compute_cvt(before != nullptr ? before->delaunay.sites() : start, leg);
        });
    }
    /// @param start  the site of the domain in each orbit is the first one.
    CvtResult run(const SymmetricSites& start, const CvtOptions& options) {
        orbit_.clear();
        for (const int orbit : start.orbit) orbit_.push_back(start.orbits[orbit].representative);
        SymmetricSites sites = start;
        return repeated_run(options, [&](const CvtResult* before, const CvtOptions& leg) {
            if (before != nullptr) sites.sites = before->delaunay.sites();
            return compute_cvt(sites, leg);
        });
    }
    std::vector<SiteId> take_held() { return std::move(held_); }

   private:
    /// @param leg  continues from the result before, if there is one.
    template <class Leg>
    CvtResult repeated_run(const CvtOptions& all, const Leg& leg_after) {
        is_fixed_.assign(orbit_.size(), false);
        fixed_.clear();
        held_.clear();
        for (std::size_t s = 0; s < orbit_.size(); ++s) {
            if (orbit_[s] < n_seeds_) fix(static_cast<SiteId>(s));
        }
        std::optional<CvtResult> result;
        RunStatistics before;
        for (;;) {
            CircleGuard guard(circles_, is_fixed_);
            bool cancelled = false;
            CvtOptions options = all;
            options.numbering = Numbering::kAsGiven;
            options.fixed = fixed_;
            options.guard = &guard;
            if (options.run.max_iterations > 0) options.run.max_iterations -= before.iterations;
            options.run.progress = [&](Progress progress) {
                if (result && progress.iteration == 0) return true;
                progress.iteration += before.iterations;
                progress.evaluations += before.evaluations;
                cancelled = all.run.progress && !all.run.progress(progress);
                return !cancelled && !guard.is_blocked();
            };
            CvtResult leg = leg_after(result ? &*result : nullptr, options);
            leg.run.add_counts(before);
            before = leg.run;
            result.emplace(std::move(leg));
            const Stop stop = result->run.stop;
            const bool ended = stop == Stop::kConverged || stop == Stop::kIterationLimit;
            const std::vector<SiteId> blocked = guard.blocked();
            if (ended || cancelled || blocked.empty()) return *std::move(result);
            for (const SiteId s : blocked) hold(s);
        }
    }
    void fix(SiteId s) {
        fixed_.push_back(s);
        is_fixed_[s] = true;
    }
    /// Holds a site and its mirror images.
    void hold(SiteId s) {
        if (is_fixed_[s]) return;
        for (std::size_t t = 0; t < orbit_.size(); ++t) {
            if (orbit_[t] == orbit_[s]) fix(static_cast<SiteId>(t));
        }
        held_.push_back(orbit_[s]);
    }

    const EmptyCircles& circles_;
    int n_seeds_;
    /// For each site, the site of the domain of which it is an image, or itself.
    std::vector<SiteId> orbit_;
    std::vector<bool> is_fixed_;
    std::vector<SiteId> fixed_;
    std::vector<SiteId> held_;
};

/// The places of sites between walls.
Points points_of(const InclusionSet& set, const Points& coordinates) {
    Points points(2, coordinates.cols());
    for (Eigen::Index s = 0; s < coordinates.cols(); ++s) {
        Vec2 p = set.reduction().reduced.to_position(coordinates.col(s));
        for (int axis = 0; axis < 2; ++axis) {
            if (!has_walls_across(set.walls(), axis)) continue;
            const double side = side_length(set.domain(), axis);
            p[axis] = std::clamp(p[axis] - std::floor(p[axis] / (2 * side)) * 2 * side, 0.0, side);
        }
        points.col(s) = p;
    }
    return points;
}

/// Requires that half cells have left the seeds in place and the circles empty.
/// @param start  seeds and free sites before any run.
void require_seeds_off_walls(const Points& coordinates, const Points& start, int n_seeds,
                             const EmptyCircles& circles) {
    constexpr double kRounding = 1e-12;
    bool is_kept = true;
    for (Eigen::Index s = 0; s < start.cols() && is_kept; ++s) {
        const Vec2 moved = coordinates.col(s) - start.col(s);
        is_kept = s < n_seeds ? (moved - Vec2(moved.array().round())).norm() < kRounding
                              : !circles.contain(coordinates.col(s));
    }
    if (is_kept) return;
    throw InvalidInput(
        "the outline of a shape is too near to a wall for half cells; take whole cells or more "
        "sites, or move the shape");
}

}  // namespace

std::vector<int> inclusions_of_sites(const Sites& sites, const InterfaceSites& interfaces) {
    std::vector<int> inclusion = interfaces.inclusion;
    inclusion.resize(static_cast<std::size_t>(sites.n_sites()), -1);
    const Lattice& reduced = sites.reduction().reduced;
    TorusGrid grid(reduced, sites.n_sites());
    for (SiteId s = interfaces.n_seeds(); s < sites.n_sites(); ++s) {
        grid.add(s, sites.coordinates().col(s));
    }
    // The larger ones first, because an inner one replaces the inclusion around it.
    std::vector<std::size_t> order(interfaces.polygons.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<double> areas;
    for (const Polygon& polygon : interfaces.polygons) areas.push_back(polygon_area(polygon));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return areas[i] > areas[j]; });
    for (const std::size_t i : order) {
        const PolygonSides sides(interfaces.polygons[i]);
        const Circle bounds = bounding_circle(interfaces.polygons[i]);
        const Vec2 u = reduced.to_lattice(bounds.centre);
        const Vec2 whole(std::floor(u.x()), std::floor(u.y()));
        const auto visit = [&](int s, Offset offset) {
            checkpoint_each(s);
            const Vec2 place = sites.coordinates().col(s) + whole + Vec2(offset.i, offset.j);
            const Vec2 p = reduced.to_position(place);
            if ((p - bounds.centre).squaredNorm() > bounds.radius * bounds.radius) return;
            if (sides.signed_distance(p) < 0) inclusion[s] = static_cast<int>(i);
        };
        grid.visit(u - whole, bounds.radius, visit);
    }
    return inclusion;
}

InterfaceCvt compute_interface_cvt(const InclusionSet& set, int n, std::uint64_t seed,
                                   const CvtOptions& options, WallCells cells) {
    const Lattice& domain = set.domain();
    if (n < 1) throw InvalidInput("the number of sites must be at least 1");
    // Place the seeds and the free sites.
    const auto spacing = spacing_of(domain, n, options.density);
    InterfaceFit fit = fit_interface_sites(set, n, spacing);
    const auto draw = [&](int count, std::uint64_t number) {
        return options.density ? graded_points(domain, *options.density, count, number)
                               : uniform_points(domain, count, number);
    };
    const auto scaled = [&](const Vec2& p) { return fit.scale * spacing(p); };
    Points start(2, n);
    start << fit.interfaces.coordinates,
        free_sites(set, fit.interfaces, {fit.n_free, seed, scaled, draw});
    // Minimise the energy.
    const int n_seeds = fit.interfaces.n_seeds();
    const EmptyCircles circles(set.reduction().reduced, fit.interfaces.circles);
    GuardedRuns runs(circles, n_seeds);
    std::optional<WalledDomain> walled;
    const auto run = [&]() -> CvtResult {
        if (set.walls() == Walls::kNone) {
            return runs.run(Sites(domain, set.reduction(), std::move(start)), options);
        }
        CvtOptions numbered = options;
        numbered.numbering = Numbering::kAsGiven;
        const SymmetricRun round = [&](const SymmetricSites& sites, const CvtOptions& of_torus) {
            require_seeds_off_walls(sites.sites.coordinates(), start, n_seeds, circles);
            return runs.run(sites, of_torus);
        };
        WalledCvt result = compute_walled_cvt({set.walls(), domain, n}, cells,
                                              points_of(set, start), numbered, round);
        fit.interfaces.coordinates = result.torus.delaunay.sites().coordinates().leftCols(n_seeds);
        walled = result.domain;
        return std::move(result.torus);
    };
    CvtResult cvt = run();
    std::vector<int> inclusion = inclusions_of_sites(cvt.delaunay.sites(), fit.interfaces);
    inclusion.resize(static_cast<std::size_t>(n));
    std::vector<int> tag;
    for (const int i : inclusion) tag.push_back(i < 0 ? 0 : set[i].tag);
    return {.cvt = std::move(cvt),
            .walled = walled,
            .interfaces = std::move(fit.interfaces),
            .inclusion = std::move(inclusion),
            .tag = std::move(tag),
            .held = runs.take_held()};
}

}  // namespace pcvt::plane
