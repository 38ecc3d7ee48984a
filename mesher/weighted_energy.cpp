#include "mesher/weighted_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include "mesher/fan_batch.hpp"
#include "mesher/quadrature.hpp"

namespace pcvt {
namespace {

constexpr int kSitesPerTask = 512;
constexpr int kCellsAtOnce = 32;
constexpr std::size_t kEnoughPoints = 4096;
constexpr double kFromBreak = 1e-12;

/// An energy that jumps by so much, relatively, still counts as continuous: a hundredth of what the
/// line search resolves.
constexpr double kEnergyJump = 1e-14;

/// std::floor of moderate numbers, without a call.
double floor_of(double number) {
    const auto whole = static_cast<double>(static_cast<std::int64_t>(number));
    return whole - (whole > number ? 1 : 0);
}

Vec2 wrapped(const Vec2& u) { return {u.x() - floor_of(u.x()), u.y() - floor_of(u.y())}; }

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
};

WeightedPass::WeightedPass(MovingDelaunay& delaunay, Workers& workers, const Lattice& lattice,
                           const Density& density, double density_unit)
    : delaunay_(delaunay),
      workers_(workers),
      pass_(delaunay, workers),
      cells_(delaunay, workers, lattice),
      quadrature_(density),
      probes_(lattice, density),
      per_unit_(1 / density_unit),
      order_(delaunay.n_sites(), kLeastOrder),
      tasks_((delaunay.n_sites() + kSitesPerTask - 1) / kSitesPerTask) {}

WeightedPass::~WeightedPass() = default;

/// Calls look(first, end, probe, task) for ranges of sites.
void WeightedPass::run_tasks(
    const std::function<void(SiteId, SiteId, DensityProbe&, Task&)>& look) {
    workers_.for_each(static_cast<int>(tasks_.size()), [&](int k) {
        Task& task = tasks_[k];
        task = {};
        try {
            probes_.lend([&](DensityProbe& probe) {
                const SiteId first = k * kSitesPerTask;
                look(first, std::min(first + kSitesPerTask, delaunay_.n_sites()), probe, task);
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

/// The moments of cells, under their numbers.
class CellSums {
   public:
    CellSums(const UnwrappedCells& cells, const CellQuadrature& quadrature, DensityProbe& probe,
             std::vector<Moments>& moments)
        : cells_(cells),
          quadrature_(quadrature),
          probe_(probe),
          moments_(moments),
          whole_(probe, cells.from_frame()),
          cut_(probe) {}

    /// Adds cells with rules of one order.
    /// @param numbers  of the cells.
    void add(std::span<const SiteId> sites, std::span<const int> numbers, int q) {
        cells_.unwrap(sites, list_);
        whole_.begin_order(q);
        for (std::size_t k = 0; k < sites.size(); ++k) {
            const Vec2 site = wrapped(cells_.site(sites[k]));
            const LatticeBox box = list_.box(k, site, kFromBreak);
            if (!quadrature_.is_cut(box)) {
                whole_.add(list_, k, site, numbers[k]);
                continue;
            }
            list_.copy(k, site, polygon_);
            quadrature_.add(polygon_, site, q, cut_);
            cut_numbers_.push_back(numbers[k]);
        }
        whole_.end_order();
        if (probe_.n_waiting() >= kEnoughPoints) finish();
    }
    void finish() {
        const std::span<const double> rho = probe_.ask_waiting();
        whole_.take(rho, moments_);
        if (cut_numbers_.empty()) return;
        const std::vector<Moments>& cut = cut_.take(rho);
        for (std::size_t k = 0; k < cut.size(); ++k) moments_[cut_numbers_[k]] = cut[k];
        cut_numbers_.clear();
    }

   private:
    const UnwrappedCells& cells_;
    const CellQuadrature& quadrature_;
    DensityProbe& probe_;
    std::vector<Moments>& moments_;
    FanBatch whole_;
    CellBatch cut_;
    std::vector<int> cut_numbers_;
    CellList list_;
    CellPolygon polygon_;
};

/// Puts the moments of the cells one after the other.
void WeightedPass::integrate(std::span<const OrderedCell> cells, DensityProbe& probe,
                             std::vector<Moments>& moments) const {
    moments.resize(cells.size());
    CellSums sums(cells_, quadrature_, probe, moments);
    // Cells of one order together, as they come.
    std::array<int, kGreatestOrder + 2> end{};
    for (const OrderedCell& cell : cells) ++end[cell.q + 1];
    for (int q = 1; q <= kGreatestOrder + 1; ++q) end[q] += end[q - 1];
    std::vector<SiteId> sites(cells.size());
    std::vector<int> numbers(cells.size());
    for (int k = 0; k < static_cast<int>(cells.size()); ++k) {
        const int place = end[cells[k].q]++;
        sites[place] = cells[k].site;
        numbers[place] = k;
    }
    int done = 0;
    for (int q = kLeastOrder; q <= kGreatestOrder; ++q) {
        while (done < end[q]) {
            const int n = std::min<int>(end[q] - done, kCellsAtOnce);
            sums.add({sites.data() + done, std::size_t(n)}, {numbers.data() + done, std::size_t(n)},
                     q);
            done += n;
        }
    }
    sums.finish();
}

bool WeightedPass::evaluate(Energy& energy) {
    if (!restore()) return false;
    cells_.locate();
    const int n = delaunay_.n_sites();
    energy.gradient.resize(2 * n);
    energy.mass.resize(n);
    const std::int64_t before = probes_.range().n_evaluations;
    run_tasks([&](SiteId first, SiteId end, DensityProbe& probe, Task& task) {
        std::vector<OrderedCell> cells;
        std::vector<Moments> moments;
        for (SiteId s = first; s < end; ++s) cells.push_back({s, order_[s], false});
        integrate(cells, probe, moments);
        for (SiteId s = first; s < end; ++s) {
            const Moments& m = moments[s - first];
            energy.mass[s] = per_unit_ * m.mass;
            energy.gradient.segment<2>(2 * s) = (-2 * per_unit_) * m.first;
            task.value += per_unit_ * m.second;
        }
    });
    energy.value = 0;
    for (const Task& task : tasks_) energy.value += task.value;
    evaluations_per_site_ = double(probes_.range().n_evaluations - before) / n;
    return true;
}

void WeightedPass::hessian(const Eigen::VectorXd& mass, BlockMatrix& hessian) {
    const WeightedHessian rows(delaunay_, cells_, quadrature_, order_, mass);
    rows.resize(hessian);
    run_tasks([&](SiteId first, SiteId end, DensityProbe& probe, Task&) {
        rows.fill_rows(first, end, per_unit_, probe, hessian);
    });
}

/// Compares the rules of the cells with the next ones, and those that differ with the next ones
/// again.
void WeightedPass::choose_orders(std::vector<OrderedCell> cells, double accuracy,
                                 DensityProbe& probe, Task& task) {
    // The pieces of a cut cell come and go while it moves, and their errors with them.
    const double when_cut = std::min(accuracy, kEnergyJump * delaunay_.n_sites());
    std::vector<Moments> moments;
    std::vector<Moments> finer;
    integrate(cells, probe, moments);
    while (!cells.empty()) {
        for (OrderedCell& cell : cells) ++cell.q;
        integrate(cells, probe, finer);
        std::size_t n_open = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const auto [site, q, is_cut] = cells[k];
            const double error = distance(moments[k], finer[k], areas()[site]);
            const bool enough = error <= (is_cut ? when_cut : accuracy);
            if (!enough && q < kGreatestOrder) {
                cells[n_open] = cells[k];
                moments[n_open++] = finer[k];
                continue;
            }
            const int chosen = enough ? q - 1 : q;
            task.check.n_rough += error > accuracy;
            task.check.n_raised += chosen > order_[site];
            task.check.largest_error = std::max(task.check.largest_error, error);
            order_[site] = static_cast<std::uint8_t>(chosen);
        }
        cells.resize(n_open);
    }
}

RuleCheck WeightedPass::choose_orders(double accuracy, bool lower) {
    cells_.locate();
    run_tasks([&](SiteId first, SiteId end, DensityProbe& probe, Task& task) {
        std::vector<OrderedCell> cells;
        CellList list;
        for (SiteId s = first; s < end; ++s) {
            cells_.unwrap({&s, 1}, list);
            const LatticeBox box = list.box(0, wrapped(cells_.site(s)), 0);
            cells.push_back({s, lower ? kLeastOrder : std::min<int>(order_[s], kGreatestOrder - 1),
                             quadrature_.is_cut(box)});
        }
        choose_orders(std::move(cells), accuracy, probe, task);
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
