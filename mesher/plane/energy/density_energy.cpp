#include "mesher/plane/energy/density_energy.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "mesher/plane/density/cell_sums.hpp"

namespace pcvt::plane {
namespace {

constexpr int kSitesPerTask = 512;

/// A relative jump of the energy that still counts as continuous: a hundredth of the line search's
/// resolution.
constexpr double kEnergyJump = 1e-14;

/// The difference between the results of two rules, relative to the cell's own moments.
double distance(const Moments& low, const Moments& high, double area) {
    const double mass = std::abs(high.mass - low.mass) / high.mass;
    const double first = (high.first - low.first).norm() / (high.mass * std::sqrt(area));
    const double second = std::abs(high.second - low.second) / (high.mass * area);
    return std::max({mass, first, second});
}

}  // namespace

/// The results of one range of sites.
struct DensityPass::Task {
    double value = 0;
    RuleCheck check = {};
    std::exception_ptr failure = {};
};

DensityPass::DensityPass(MovingDelaunay& delaunay, Workers& workers, const Lattice& lattice,
                         const Density& density, double density_unit)
    : delaunay_(delaunay),
      workers_(workers),
      pass_(delaunay, workers),
      cells_(delaunay, workers, lattice),
      quadrature_(density),
      probes_(lattice, density),
      per_unit_(1 / density_unit),
      order_(delaunay.n_sites(), static_cast<std::uint8_t>(quadrature_.least_order())),
      tasks_((delaunay.n_sites() + kSitesPerTask - 1) / kSitesPerTask) {}

DensityPass::~DensityPass() = default;

/// Calls work(first, end, probe, task) for ranges of sites.
void DensityPass::run_tasks(const std::function<void(SiteId, SiteId, DensityProbe&, Task&)>& work) {
    workers_.for_each(static_cast<int>(tasks_.size()), [&](int k) {
        Task& task = tasks_[k];
        task = {};
        try {
            probes_.with_probe([&](DensityProbe& probe) {
                const SiteId first = k * kSitesPerTask;
                work(first, std::min(first + kSitesPerTask, delaunay_.n_sites()), probe, task);
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

std::unique_ptr<CellSums> DensityPass::take_sums(DensityProbe& probe) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(idle_.begin(), idle_.end(),
                                    [&](const auto& sums) { return &sums->probe() == &probe; });
    if (found == idle_.end()) return std::make_unique<CellSums>(cells_, quadrature_, probe);
    std::unique_ptr<CellSums> sums = std::move(*found);
    idle_.erase(found);
    return sums;
}

/// The same with sums in place of the probe; those of a task that fails are not used again.
void DensityPass::sum_tasks(const std::function<void(SiteId, SiteId, CellSums&, Task&)>& work) {
    run_tasks([&](SiteId first, SiteId end, DensityProbe& probe, Task& task) {
        std::unique_ptr<CellSums> sums = take_sums(probe);
        work(first, end, *sums, task);
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(sums));
    });
}

bool DensityPass::evaluate(Energy& energy) {
    if (!restore()) return false;
    cells_.locate();
    // Integrate over the cells, range by range.
    const int n = delaunay_.n_sites();
    energy.gradient.resize(2 * n);
    energy.mass.resize(n);
    const std::int64_t before = probes_.range().n_evaluations;
    sum_tasks([&](SiteId first, SiteId end, CellSums& sums, Task& task) {
        std::vector<OrderedCell> cells;
        std::vector<Moments> moments;
        cells.reserve(std::size_t(end - first));
        for (SiteId s = first; s < end; ++s) cells.push_back({s, order_[s], false});
        sums.integrate(cells, moments);
        for (SiteId s = first; s < end; ++s) {
            const Moments& m = moments[s - first];
            energy.mass[s] = per_unit_ * m.mass;
            energy.gradient.segment<2>(2 * s) = (-2 * per_unit_) * m.first;
            task.value += per_unit_ * m.second;
        }
    });
    // Add up the ranges in order.
    energy.value = 0;
    for (const Task& task : tasks_) energy.value += task.value;
    evaluations_per_site_ = double(probes_.range().n_evaluations - before) / n;
    return true;
}

void DensityPass::hessian(const Eigen::VectorXd& mass, BlockMatrix& hessian) {
    cells_.locate();
    const DensityHessian rows(delaunay_, cells_, quadrature_, order_, mass);
    rows.resize(hessian);
    run_tasks([&](SiteId first, SiteId end, DensityProbe& probe, Task&) {
        rows.fill_rows(first, end, per_unit_, probe, hessian);
    });
}

/// Compares the rule of each cell with the next order, and repeats this with the cells that still
/// differ.
void DensityPass::choose_orders(std::vector<OrderedCell> cells, double accuracy, CellSums& sums,
                                Task& task) {
    // The pieces of a cut cell appear and vanish while it moves, and their errors jump with them.
    const double when_cut = std::min(accuracy, kEnergyJump * delaunay_.n_sites());
    // Integrate with the current orders.
    std::vector<Moments> moments;
    std::vector<Moments> finer;
    sums.integrate(cells, moments);
    while (!cells.empty()) {
        // Integrate with the next orders, and keep the cells that differ.
        for (OrderedCell& cell : cells) ++cell.q;
        sums.integrate(cells, finer);
        std::size_t n_open = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const auto [site, q, is_cut] = cells[k];
            const double error = distance(moments[k], finer[k], areas()[site]);
            const bool accurate = error <= (is_cut ? when_cut : accuracy);
            if (!accurate && q < kGreatestOrder) {
                cells[n_open] = cells[k];
                moments[n_open++] = finer[k];
                continue;
            }
            const int chosen = accurate ? q - 1 : q;
            task.check.n_rough += error > accuracy;
            task.check.n_raised += chosen > order_[site];
            task.check.largest_error = std::max(task.check.largest_error, error);
            order_[site] = static_cast<std::uint8_t>(chosen);
        }
        cells.resize(n_open);
    }
}

RuleCheck DensityPass::choose_orders(double accuracy, bool lower) {
    cells_.locate();
    sum_tasks([&](SiteId first, SiteId end, CellSums& sums, Task& task) {
        std::vector<OrderedCell> cells;
        for (SiteId s = first; s < end; ++s) {
            cells.push_back(
                {s,
                 lower ? quadrature_.least_order() : std::min<int>(order_[s], kGreatestOrder - 1),
                 sums.is_cut(s)});
        }
        choose_orders(std::move(cells), accuracy, sums, task);
    });
    RuleCheck check;
    for (const Task& task : tasks_) {
        check.n_raised += task.check.n_raised;
        check.n_rough += task.check.n_rough;
        check.largest_error = std::max(check.largest_error, task.check.largest_error);
    }
    return check;
}

}  // namespace pcvt::plane
