#include "mesher/weighted_energy.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include "mesher/polygon.hpp"
#include "mesher/predicates.hpp"
#include "mesher/quadrature.hpp"

namespace pcvt {
namespace {

constexpr int kSitesPerTask = 512;
constexpr int kTrianglesPerTask = 1 << 13;
/// A triangle thinner than this has its circumcentre computed in more digits.
constexpr double kThin = 1e-4;

/// An energy that jumps by so much, relatively, still counts as continuous: a hundredth of what the
/// line search resolves.
constexpr double kEnergyJump = 1e-14;

/// How far the results of two rules lie apart, in units of the cell's own.
double distance(const Moments& low, const Moments& high, double area) {
    const double mass = std::abs(high.mass - low.mass) / high.mass;
    const double first = (high.first - low.first).norm() / (high.mass * std::sqrt(area));
    const double second = std::abs(high.second - low.second) / (high.mass * area);
    return std::max({mass, first, second});
}

}  // namespace

/// A range of sites and what comes of it.
struct WeightedPass::Task {
    double value = 0;
    RuleCheck check = {};
    std::exception_ptr failure = {};
    CellPolygon cell = {};
};

WeightedPass::WeightedPass(MovingDelaunay& delaunay, Workers& workers, const Lattice& lattice,
                           const Density& density, double density_unit)
    : delaunay_(delaunay),
      workers_(workers),
      pass_(delaunay, workers),
      quadrature_(density),
      probes_(lattice, density),
      per_unit_(1 / density_unit),
      leaving_(delaunay.n_sites()),
      centre_(6 * std::size_t(delaunay.n_sites())),
      order_(delaunay.n_sites(), kLeastOrder),
      tasks_((delaunay.n_sites() + kSitesPerTask - 1) / kSitesPerTask) {
    const Reduction reduction = reduce(lattice);
    from_reduced_ << reduction.m[0], reduction.m[2], reduction.m[1], reduction.m[3];
    const MovingDelaunay::Frame& frame = delaunay.frame();
    Eigen::Matrix2d to_frame;
    to_frame << frame.ax, frame.bx, 0, frame.by;
    from_frame_ = from_reduced_ * to_frame.inverse();
}

void WeightedPass::locate_centre(int triangle) {
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

void WeightedPass::locate_cells() {
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

WeightedPass::~WeightedPass() = default;

Vec2 WeightedPass::user_coordinates(SiteId site) const {
    return from_reduced_ * delaunay_.coordinates().col(site);
}

void WeightedPass::unwrap_cell(SiteId site, CellPolygon& cell) const {
    const TorusTriangulation& t = delaunay_.triangulation();
    const Vec2 origin = user_coordinates(site);
    cell.clear();
    int h = leaving_[site];
    do {
        cell.push_back({centre_[h], origin + from_frame_ * centre_[h]});
        h = t.next_round_site(h);
    } while (h != leaving_[site]);
}

void WeightedPass::run_tasks(const std::function<void(SiteId, DensityProbe&, Task&)>& look) {
    workers_.for_each(static_cast<int>(tasks_.size()), [&](int k) {
        Task& task = tasks_[k];
        task = {.cell = std::move(task.cell)};
        try {
            probes_.lend([&](DensityProbe& probe) {
                const int end = std::min((k + 1) * kSitesPerTask, delaunay_.n_sites());
                for (SiteId s = k * kSitesPerTask; s < end; ++s) look(s, probe, task);
            });
        } catch (...) {
            task.failure = std::current_exception();
        }
    });
    for (const Task& task : tasks_) {
        if (task.failure) std::rethrow_exception(task.failure);
    }
    probes_.range().require_contrast();
}

bool WeightedPass::evaluate(Energy& energy) {
    if (!restore()) return false;
    locate_cells();
    const int n = delaunay_.n_sites();
    energy.gradient.resize(2 * n);
    energy.mass.resize(n);
    const std::int64_t before = probes_.range().n_evaluations;
    run_tasks([&](SiteId s, DensityProbe& probe, Task& task) {
        unwrap_cell(s, task.cell);
        const Moments moments = quadrature_(task.cell, user_coordinates(s), order_[s], probe);
        energy.mass[s] = per_unit_ * moments.mass;
        energy.gradient.segment<2>(2 * s) = (-2 * per_unit_) * moments.first;
        task.value += per_unit_ * moments.second;
    });
    energy.value = 0;
    for (const Task& task : tasks_) energy.value += task.value;
    evaluations_per_site_ = double(probes_.range().n_evaluations - before) / n;
    return true;
}

RuleCheck WeightedPass::choose_orders(double accuracy, bool lower) {
    locate_cells();
    run_tasks([&](SiteId s, DensityProbe& probe, Task& task) {
        unwrap_cell(s, task.cell);
        const Vec2 origin = user_coordinates(s);
        // The pieces of a cut cell come and go while it moves, and their errors with them.
        const double jump = kEnergyJump * delaunay_.n_sites();
        const bool is_cut = quadrature_.is_cut(task.cell, origin);
        const double wanted = is_cut ? std::min(accuracy, jump) : accuracy;
        int q = lower ? kLeastOrder : std::min<int>(order_[s], kGreatestOrder - 1);
        Moments moments = quadrature_(task.cell, origin, q, probe);
        double error = wanted + 1;
        for (;;) {
            const Moments finer = quadrature_(task.cell, origin, q + 1, probe);
            error = distance(moments, finer, areas()[s]);
            if (error <= wanted) break;
            ++q;
            if (q == kGreatestOrder) break;
            moments = finer;
        }
        task.check.n_rough += error > accuracy;
        task.check.n_raised += q > order_[s];
        task.check.largest_error = std::max(task.check.largest_error, error);
        order_[s] = static_cast<std::uint8_t>(q);
    });
    RuleCheck check;
    for (const Task& task : tasks_) {
        check.n_raised += task.check.n_raised;
        check.n_rough += task.check.n_rough;
        check.largest_error = std::max(check.largest_error, task.check.largest_error);
    }
    return check;
}

}  // namespace pcvt
