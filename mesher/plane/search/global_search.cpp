#include "mesher/plane/search/global_search.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/base/workers.hpp"
#include "mesher/plane/search/search_starts.hpp"

namespace pcvt::plane {
namespace {

constexpr int kRound = 8;
/// The fewest evaluations that a start can use.
constexpr int kFewestEvaluations = 50;
/// The default budget is the smaller of a few seconds' work and a number of evaluations per site
/// beyond which small problems find no further minima.
constexpr int kBudgetPerSite = 2'000;
constexpr int kDefaultBudget = 200'000;
/// Beyond this many sites the default budget decreases.
constexpr int kMiddle = 400;
/// The number of minima that are kept as origins of restarts.
constexpr std::size_t kMinima = 8;
/// Minima whose energies differ relatively by less than this count as one minimum (at a residual of
/// 1e-4).
constexpr double kSameEnergy = 2e-6;
/// The residual to which every start is optimised, and the residual for the best one.
constexpr double kLoose = 1e-4;
constexpr double kTight = 1e-9;
/// At an RMS residual r, nine starts out of ten lower their energy further by a relative amount of
/// at most 6 r (measured for n = 30 to 2000 and r from 1e-4 to 1e-2, where the bound was 3 r to 10
/// r).
constexpr double kHope = 6;

/// One start and its result.
struct Trial {
    SearchState state;
    /// Whether the run reached a minimum: the start was not abandoned and no sites coincided.
    bool ended = false;
    int evaluations = 0;
};

/// Derives a separate seed for each start (the multiplier is the one of Knuth's MMIX generator).
std::uint64_t stream(std::uint64_t seed, int start) {
    return (seed + 1) * 6364136223846793005ULL + static_cast<std::uint64_t>(start);
}

Points positions(const Sites& sites) {
    Points points(2, sites.n_sites());
    for (SiteId s = 0; s < sites.n_sites(); ++s) points.col(s) = sites.position(s);
    return points;
}

class Search {
   public:
    Search(const Lattice& period, int n, std::uint64_t seed, const SearchOptions& options)
        : period_(period),
          n_(n),
          seed_(seed),
          options_(options),
          workers_(std::min(options.run.n_threads, kRound)),
          maker_(period, n),
          lattice_(best_lattice(period, n)),
          minima_{{pattern_points(lattice_), {n}, lattice_.energy}} {}

    SearchResult run();

   private:
    bool report();
    CvtOptions optimiser(int most_evaluations, double tolerance);
    void optimise(Trial& trial, int most_evaluations, double tolerance);
    void remember(SearchState state);
    void run_round();
    double lowest() const { return minima_.front().energy; }
    /// The energy that a start must fall below to be kept.
    double worst_kept() const {
        return minima_.size() < kMinima ? std::numeric_limits<double>::infinity()
                                        : minima_.back().energy;
    }

    Lattice period_;
    int n_;
    std::uint64_t seed_;
    const SearchOptions& options_;
    Workers workers_;
    StartMaker maker_;
    LatticePattern lattice_;
    /// Sorted by energy, lowest first.
    std::vector<SearchState> minima_;
    int starts_ = 0;
    int evaluations_ = 0;
    std::atomic<bool> cancelled_ = false;
    std::thread::id caller_ = std::this_thread::get_id();
};

/// Reports progress and returns false once the search is cancelled. Must run on the caller's
/// thread.
bool Search::report() {
    if (!options_.run.progress || cancelled_) return !cancelled_;
    Progress progress;
    progress.iteration = starts_;
    progress.evaluations = evaluations_;
    progress.value = lowest();
    progress.budget = options_.budget;
    if (!options_.run.progress(progress)) cancelled_ = true;
    return !cancelled_;
}

/// Returns options that end a start if it is hopeless or has spent its share, or if the search is
/// cancelled.
CvtOptions Search::optimiser(int most_evaluations, double tolerance) {
    CvtOptions options;
    options.run.tolerance = tolerance;
    options.run.progress = [this, most_evaluations,
                            worst = worst_kept()](const Progress& progress) {
        if (std::this_thread::get_id() == caller_) report();
        const bool hopeless = progress.value * (1 - kHope * progress.rms_residual) > worst;
        return !cancelled_ && !hopeless && progress.evaluations < most_evaluations;
    };
    return options;
}

void Search::optimise(Trial& trial, int most_evaluations, double tolerance) {
    // A start with coincident sites costs no evaluation; it counts as one so that the search ends.
    trial.evaluations = 1;
    trial.ended = false;
    try {
        const CvtResult result = compute_cvt(period_, std::move(trial.state.points),
                                             optimiser(most_evaluations, tolerance));
        trial.ended = result.run.stop != Stop::kCancelled;
        trial.evaluations = result.run.evaluations;
        trial.state.energy = result.run.energy;
        trial.state.points = positions(result.delaunay.sites());
    } catch (const DuplicateSites&) {
    }
}

/// Inserts a minimum unless one of the same energy is known already.
void Search::remember(SearchState state) {
    for (const SearchState& known : minima_) {
        if (std::abs(state.energy - known.energy) <= kSameEnergy * known.energy) return;
    }
    const auto place = std::find_if(minima_.begin(), minima_.end(), [&](const SearchState& known) {
        return state.energy < known.energy;
    });
    minima_.insert(place, std::move(state));
    if (minima_.size() > kMinima) minima_.pop_back();
}

/// Optimises one round of starts; each may spend an equal share of the remaining budget.
void Search::run_round() {
    const int share = std::max(1, (options_.budget - evaluations_) / kRound);
    std::vector<Trial> trials(kRound);
    for (Trial& trial : trials) {
        StartMaker::Random random(stream(seed_, starts_++));
        trial.state = maker_.make(random, minima_);
    }
    workers_.for_each(kRound, [&](int k) { optimise(trials[k], share, kLoose); });
    for (Trial& trial : trials) {
        evaluations_ += trial.evaluations;
        if (trial.ended) remember(std::move(trial.state));
    }
}

SearchResult Search::run() {
    const bool affordable = options_.budget / kRound >= kFewestEvaluations;
    while (affordable && evaluations_ < options_.budget && report()) run_round();
    Trial best{minima_.front()};
    const bool below = best.state.energy < lattice_.energy * (1 - kSameEnergy);
    if (below && !cancelled_) {
        optimise(best, std::numeric_limits<int>::max(), kTight);
        evaluations_ += best.evaluations;
    } else {
        best.state = {pattern_points(lattice_), {n_}, lattice_.energy};
    }
    return {.cancelled = cancelled_,
            .lattice = lattice_,
            .points = std::move(best.state.points),
            .energy = best.state.energy,
            .found = start_words(best.state.origin, n_),
            .starts = starts_,
            .evaluations = evaluations_};
}

}  // namespace

int default_search_budget(int n) {
    const std::int64_t falling = std::int64_t{kDefaultBudget} * kMiddle / std::max(n, kMiddle);
    return static_cast<int>(std::min(std::int64_t{kBudgetPerSite} * n, falling));
}

SearchResult search_minimum(const Lattice& period, int n, std::uint64_t seed,
                            const SearchOptions& options) {
    return Search(period, n, seed, options).run();
}

}  // namespace pcvt::plane
