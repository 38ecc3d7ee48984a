#include "mesher/cvt/interface_cvt.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "mesher/base/checkpoint.hpp"
#include "mesher/density/density_survey.hpp"
#include "mesher/interfaces/empty_circles.hpp"
#include "mesher/interfaces/free_sites.hpp"
#include "mesher/interfaces/interface_fit.hpp"

namespace pcvt {
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
class CircleGuard final : public SiteGuard {
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
    GuardedRuns(const EmptyCircles& circles, int n_seeds, int n, const CvtOptions& options)
        : circles_(circles), options_(options), is_fixed_(static_cast<std::size_t>(n), false) {
        for (SiteId s = 0; s < n_seeds; ++s) fix(s);
    }

    CvtResult run(const Sites& start) {
        std::optional<CvtResult> result;
        RunStatistics before;
        for (;;) {
            CircleGuard guard(circles_, is_fixed_);
            bool cancelled = false;
            CvtOptions options = options_;
            options.numbering = Numbering::kAsGiven;
            options.fixed = fixed_;
            options.guard = &guard;
            if (options.max_iterations > 0) options.max_iterations -= before.iterations;
            options.progress = [&](Progress progress) {
                if (result && progress.iteration == 0) return true;
                progress.iteration += before.iterations;
                progress.evaluations += before.evaluations;
                cancelled = options_.progress && !options_.progress(progress);
                return !cancelled && !guard.is_blocked();
            };
            CvtResult leg = compute_cvt(result ? result->delaunay.sites() : start, options);
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
    std::vector<SiteId> take_held() { return std::move(held_); }

   private:
    void fix(SiteId s) {
        fixed_.push_back(s);
        is_fixed_[s] = true;
    }
    void hold(SiteId s) {
        fix(s);
        held_.push_back(s);
    }

    const EmptyCircles& circles_;
    const CvtOptions& options_;
    std::vector<bool> is_fixed_;
    std::vector<SiteId> fixed_;
    std::vector<SiteId> held_;
};

}  // namespace

std::vector<int> inclusions_of_sites(const Sites& sites, const InterfaceSites& interfaces) {
    std::vector<int> inclusion = interfaces.inclusion;
    inclusion.resize(static_cast<std::size_t>(sites.n_sites()), -1);
    const Lattice& reduced = sites.reduction().reduced;
    TorusGrid grid(reduced, sites.n_sites());
    for (SiteId s = interfaces.n_seeds(); s < sites.n_sites(); ++s) {
        grid.add(s, sites.coordinates().col(s));
    }
    for (std::size_t i = 0; i < interfaces.polygons.size(); ++i) {
        const Shape shape = interfaces.polygons[i];
        const Circle bounds = bounding_circle(shape);
        const Vec2 u = reduced.to_lattice(bounds.centre);
        const Vec2 whole(std::floor(u.x()), std::floor(u.y()));
        const auto visit = [&](int s, Offset offset) {
            checkpoint_each(s);
            const Vec2 place = sites.coordinates().col(s) + whole + Vec2(offset.i, offset.j);
            const Vec2 p = reduced.to_plane(place);
            if ((p - bounds.centre).squaredNorm() > bounds.radius * bounds.radius) return;
            if (signed_distance(shape, p) < 0) inclusion[s] = static_cast<int>(i);
        };
        grid.visit(u - whole, bounds.radius, visit);
    }
    return inclusion;
}

InterfaceCvt compute_interface_cvt(const InclusionSet& set, int n, std::uint64_t seed,
                                   const CvtOptions& options) {
    const Lattice& lattice = set.lattice();
    if (n < 1) throw InvalidInput("the number of sites must be at least 1");
    // Place the seeds and the free sites.
    const auto spacing = spacing_of(lattice, n, options.density);
    InterfaceFit fit = fit_interface_sites(set, n, spacing);
    const auto draw = [&](int count, std::uint64_t number) {
        return options.density ? graded_points(lattice, *options.density, count, number)
                               : uniform_points(lattice, count, number);
    };
    const auto scaled = [&](const Vec2& p) { return fit.scale * spacing(p); };
    Points coordinates(2, n);
    coordinates << fit.interfaces.coordinates,
        free_sites(set, fit.interfaces, {fit.n_free, seed, scaled, draw});
    const Sites start(lattice, set.reduction(), std::move(coordinates));
    // Minimise the energy.
    const EmptyCircles circles(set.reduction().reduced, fit.interfaces.circles);
    GuardedRuns runs(circles, fit.interfaces.n_seeds(), n, options);
    CvtResult cvt = runs.run(start);
    std::vector<int> inclusion = inclusions_of_sites(cvt.delaunay.sites(), fit.interfaces);
    std::vector<int> tag;
    for (const int i : inclusion) tag.push_back(i < 0 ? 0 : set[i].tag);
    return {.cvt = std::move(cvt),
            .interfaces = std::move(fit.interfaces),
            .inclusion = std::move(inclusion),
            .tag = std::move(tag),
            .held = runs.take_held()};
}

}  // namespace pcvt
