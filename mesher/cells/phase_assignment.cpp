#include "mesher/cells/phase_assignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// Separates the numbers from those that uniform_points draws from the same seed.
constexpr std::uint64_t kSeedOfPhases = 0xd1b54a32d192ed03;

/// Passes over all cells, and partners with which each cell may be exchanged in a pass.
constexpr int kSweeps = 3;
constexpr int kPartners = 12;
/// Steps towards the prescribed areas.
constexpr int kMostSteps = 200;
/// Attempts, with fewer of many cells.
constexpr int kMostAttempts = 64;
constexpr int kCellsOfAllAttempts = 1 << 20;

using Random = std::mt19937_64;

/// A number from 0 to n - 1. The remainder favours some numbers by less than n / 2^64.
int draw(Random& random, int n) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(n));
}

std::vector<int> shuffled(int n, Random& random) {
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    for (int k = n - 1; k > 0; --k) std::swap(order[k], order[draw(random, k + 1)]);
    return order;
}

/// The phases of all cells, with the sums that Q and the areas need.
class Assignment {
   public:
    Assignment(const CellTable& cells, std::span<const double> fractions, Random& random)
        : cells_(cells),
          fractions_(fractions),
          random_(random),
          n_(cells.n_cells()),
          total_(std::accumulate(cells.measure.begin(), cells.measure.end(), 0.0)) {
        assign_at_random();
        count();
    }

    /// Exchanges cells with equally many sides at random places where that lowers Q.
    void spread() {
        std::map<int, std::vector<int>> with_sides;
        for (int s = 0; s < n_; ++s) with_sides[cells_.n_neighbours(s)].push_back(s);
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            for (const int s : shuffled(n_, random_)) {
                checkpoint_each(s);
                const std::vector<int>& partners = with_sides[cells_.n_neighbours(s)];
                for (int k = 0; k < kPartners; ++k) {
                    improve(s, partners[draw(random_, static_cast<int>(partners.size()))]);
                }
            }
        }
    }

    /// Moves and exchanges cells until each phase has its area to `tolerance`, or nothing helps.
    void fit(double tolerance) {
        // Without the rounding of all the exchanges.
        forget_areas();
        for (int s = 0; s < n_; ++s) excess_[phase_[s]] += cells_.measure[s];
        for (int step = 0; step < kMostSteps && error() > tolerance; ++step) {
            checkpoint();
            if (!step_towards_areas(tolerance)) return;
        }
    }

    /// The largest difference of a phase's area from its target.
    double error() const { return largest(excess_); }
    const std::vector<int>& phases() const { return phase_; }

   private:
    /// A change of phases: s goes from p to q, and t, if there is one, from q to p.
    struct Change {
        int s = -1;
        int t = -1;
        double error = std::numeric_limits<double>::infinity();
        double unevenness = 0;
    };

    static double largest(const std::vector<double>& values) {
        double most = 0;
        for (const double value : values) most = std::max(most, std::abs(value));
        return most;
    }

    int n_phases() const { return static_cast<int>(fractions_.size()); }

    /// The excess of phases without cells.
    void forget_areas() {
        excess_.clear();
        for (const double fraction : fractions_) excess_.push_back(-fraction * total_);
    }

    /// Each cell gets the phase that lacks most area.
    void assign_at_random() {
        forget_areas();
        phase_.assign(static_cast<std::size_t>(n_), 0);
        for (const int s : shuffled(n_, random_)) {
            const auto least = std::min_element(excess_.begin(), excess_.end());
            phase_[s] = static_cast<int>(least - excess_.begin());
            *least += cells_.measure[s];
        }
    }

    template <class Visit>
    void for_each_around(int s, const Visit& visit) const {
        visit(s);
        for (int k = cells_.neighbour_begin[s]; k < cells_.neighbour_begin[s + 1]; ++k) {
            visit(cells_.neighbours[k]);
        }
    }

    double& around(int s, int phase) {
        return around_[static_cast<std::size_t>(s) * fractions_.size() + phase];
    }

    void count() {
        around_.resize(static_cast<std::size_t>(n_) * fractions_.size());
        for (int s = 0; s < n_; ++s) {
            for (int k = 0; k < n_phases(); ++k) {
                around(s, k) = -fractions_[k] * (1 + cells_.n_neighbours(s));
            }
        }
        for (int s = 0; s < n_; ++s) {
            for_each_around(s, [&](int u) { around(u, phase_[s]) += 1; });
        }
    }

    /// Gives s the phase q. Returns the change of Q.
    double move(int s, int q) {
        const int p = phase_[s];
        double change = 0;
        for_each_around(s, [&](int u) {
            double& left = around(u, p);
            double& entered = around(u, q);
            change += 2 * (1 - left + entered);
            left -= 1;
            entered += 1;
        });
        phase_[s] = q;
        excess_[p] -= cells_.measure[s];
        excess_[q] += cells_.measure[s];
        return change;
    }

    /// Exchanges the phases of both, or moves s to q if t < 0. Returns the change of Q.
    double apply(int s, int t, int q) {
        const int p = phase_[s];
        const double change = move(s, q);
        return t < 0 ? change : change + move(t, p);
    }

    double unevenness_of(int s, int t, int q) {
        const int p = phase_[s];
        const std::vector<double> excess = excess_;
        const double change = apply(s, t, q);
        apply(s, t, p);
        // Without the rounding of the way back.
        excess_ = excess;
        return change;
    }

    /// Exchanges s and t if that lowers Q and leaves the areas about as good as they are.
    void improve(int s, int t) {
        const int p = phase_[s];
        const int q = phase_[t];
        if (p == q) return;
        const double d = cells_.measure[s] - cells_.measure[t];
        const double before = std::max(std::abs(excess_[p]), std::abs(excess_[q]));
        const double after = std::max(std::abs(excess_[p] - d), std::abs(excess_[q] + d));
        if (after > std::max(before, total_ / n_)) return;
        const std::vector<double> excess = excess_;
        if (apply(s, t, q) < -0.5) return;
        apply(s, t, p);
        excess_ = excess;
    }

    /// Makes the best change between the phases with the most and the least excess.
    /// @returns whether the error became smaller.
    bool step_towards_areas(double tolerance) {
        const auto [least, most] = std::minmax_element(excess_.begin(), excess_.end());
        const int q = static_cast<int>(least - excess_.begin());
        const int p = static_cast<int>(most - excess_.begin());
        const Change change = best_change(p, q, tolerance);
        if (!(change.error < std::max(*most, -*least))) return false;
        apply(change.s, change.t, q);
        return true;
    }

    Change best_change(int p, int q, double tolerance) {
        std::vector<int> from;
        std::vector<int> to;
        for (int s = 0; s < n_; ++s) {
            if (phase_[s] == p) from.push_back(s);
            if (phase_[s] == q) to.push_back(s);
        }
        const auto smaller = [this](int s, int t) {
            return cells_.measure[s] != cells_.measure[t] ? cells_.measure[s] < cells_.measure[t]
                                                          : s < t;
        };
        std::sort(to.begin(), to.end(), smaller);
        // This much area shall go from p to q.
        const double wanted = (excess_[p] - excess_[q]) / 2;
        Change best;
        for (const int s : from) {
            checkpoint_each(s);
            consider(s, -1, q, tolerance, best);
            const auto next =
                std::lower_bound(to.begin(), to.end(), cells_.measure[s] - wanted,
                                 [this](int t, double area) { return cells_.measure[t] < area; });
            if (next != to.end()) consider(s, *next, q, tolerance, best);
            if (next != to.begin()) consider(s, *(next - 1), q, tolerance, best);
        }
        return best;
    }

    /// Errors within the tolerance count as equal; then the more even change is the better one.
    void consider(int s, int t, int q, double tolerance, Change& best) {
        const int p = phase_[s];
        const double d = cells_.measure[s] - (t < 0 ? 0 : cells_.measure[t]);
        const double error = std::max(std::abs(excess_[p] - d), std::abs(excess_[q] + d));
        if (std::max(error, tolerance) > std::max(best.error, tolerance)) return;
        const bool ties = std::max(error, tolerance) == std::max(best.error, tolerance);
        const double unevenness = error <= tolerance ? unevenness_of(s, t, q) : 0;
        if (ties && unevenness >= best.unevenness) return;
        best = {s, t, error, unevenness};
    }

    const CellTable& cells_;
    std::span<const double> fractions_;
    Random& random_;
    int n_;
    double total_;
    std::vector<int> phase_;
    /// The area of each phase less its target.
    std::vector<double> excess_;
    /// c_sk - f_k m_s
    std::vector<double> around_;
};

}  // namespace

std::vector<int> assign_phases(const CellTable& cells, std::span<const double> fractions,
                               std::uint64_t seed) {
    const double smallest = *std::min_element(cells.measure.begin(), cells.measure.end());
    const double tolerance = (1 - 1 / static_cast<double>(fractions.size())) * smallest;
    const int n_attempts = std::clamp(kCellsOfAllAttempts / cells.n_cells(), 1, kMostAttempts);
    Random random(seed ^ kSeedOfPhases);
    std::vector<int> best;
    double error = std::numeric_limits<double>::infinity();
    for (int k = 0; k < n_attempts && error > tolerance; ++k) {
        Assignment assignment(cells, fractions, random);
        assignment.spread();
        assignment.fit(tolerance);
        if (!(assignment.error() < error)) continue;
        error = assignment.error();
        best = assignment.phases();
    }
    return best;
}

std::vector<double> phase_shares(const CellTable& cells, std::span<const int> site_phase,
                                 std::size_t n_phases) {
    std::vector<double> shares(n_phases, 0);
    for (int s = 0; s < cells.n_cells(); ++s) shares[site_phase[s]] += cells.measure[s];
    const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (double& share : shares) share /= total;
    return shares;
}

}  // namespace pcvt
