#include "mesher/plane/search/search_starts.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {
namespace {

/// The number of lattices per number of sites from which starts are drawn.
constexpr int kLattices = 12;
/// The largest number of scattered sites that are removed or added, and the longest row in units of
/// sqrt(n) sites. Such a row spans about half of the domain; a longer one ends near its beginning.
constexpr int kLooseSites = 4;
constexpr double kLongestRow = 0.6;
/// The longest move of a site in units of h: the jitter breaks the symmetry of a lattice without
/// moving sites out of their places; the shakes are large enough to change neighbours.
constexpr double kJitter = 0.15;
constexpr double kWeakestShake = 0.15;
constexpr double kStrongestShake = 0.6;
/// The fractions of starts from neighbouring lattices and of restarts.
constexpr double kNeighbours = 0.5;
constexpr double kRestarts = 0.4;
/// The probability that a row continues straight.
constexpr double kStraight = 0.8;

/// Returns a uniform number in [0, 1).
double uniform(StartMaker::Random& random) {
    return std::ldexp(static_cast<double>(random() >> 11), -53);
}

/// Returns a uniform integer in 0 ... count - 1.
int pick(StartMaker::Random& random, int count) {
    return static_cast<int>(uniform(random) * count);
}

/// Returns an integer in 0 ... count - 1, small ones with a higher probability.
int pick_low(StartMaker::Random& random, int count) {
    return static_cast<int>(uniform(random) * uniform(random) * count);
}

/// Returns a uniform point in the unit disc; uses no functions that machines round differently.
Vec2 in_disc(StartMaker::Random& random) {
    for (;;) {
        const double x = 2 * uniform(random) - 1;
        const double y = 2 * uniform(random) - 1;
        if (x * x + y * y <= 1) return {x, y};
    }
}

/// Returns the three shortest vectors of a lattice, as steps.
std::array<Offset, 3> directions(const LatticePattern& pattern) {
    const auto [s, t] = pattern.steps;
    const bool obtuse = pattern.basis.a().dot(pattern.basis.b()) <= 0;
    return {s, t, obtuse ? s + t : t - s};
}

/// Walks along a row of sites, mostly straight and sometimes in a neighbouring direction.
class RowWalk {
   public:
    RowWalk(const LatticePattern& pattern, StartMaker::Random& random)
        : random_(random),
          directions_(directions(pattern)),
          main_(pick(random, 3)),
          turned_((main_ + 1 + pick(random, 2)) % 3) {}

    Offset here() const { return here_; }
    /// Returns a direction across the row.
    Offset across() const { return directions_[turned_]; }
    Offset along() const { return directions_[main_]; }
    void advance() {
        const bool straight = uniform(random_) < kStraight;
        here_ = here_ + directions_[straight ? main_ : turned_];
    }

   private:
    StartMaker::Random& random_;
    std::array<Offset, 3> directions_;
    int main_;
    int turned_;
    Offset here_;
};

std::string count_words(int count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

std::string start_words(const StartOrigin& origin, int n) {
    std::string words = "random sites";
    if (origin.lattice_sites > 0) {
        words = "lattice of " + std::to_string(origin.lattice_sites);
        if (origin.rank > 0) words += " (number " + std::to_string(origin.rank + 1) + " by energy)";
    }
    if (origin.lattice_sites > 0 && origin.lattice_sites != n) {
        words += ", " + count_words(std::abs(origin.lattice_sites - n), "site") +
                 (origin.lattice_sites > n ? " removed" : " added") +
                 (origin.in_row ? " in a row" : "");
    }
    if (origin.restarts > 0) words += ", then " + count_words(origin.restarts, "noisy restart");
    return words;
}

StartMaker::StartMaker(const Lattice& period, int n)
    : period_(period), n_(n), spacing_(std::sqrt(period.area() / n)) {}

const std::vector<LatticePattern>& StartMaker::lattices(int n_sites) {
    std::vector<LatticePattern>& known = lattices_[n_sites];
    if (known.empty()) known = best_lattices(period_, n_sites, kLattices);
    return known;
}

void StartMaker::shake(Points& points, double amount, Random& random) const {
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        checkpoint_each(s);
        points.col(s) += amount * spacing_ * in_disc(random);
    }
}

/// Clears sites in `kept` along a row until n are left, or for at most 4 n steps (the row may
/// close).
void StartMaker::remove_row(const LatticePattern& pattern, Random& random,
                            std::vector<char>& kept) const {
    int surplus = pattern.n_sites() - n_;
    RowWalk walk(pattern, random);
    for (int step = 0; surplus > 0 && step < 4 * n_; ++step) {
        checkpoint_each(step);
        char& site = kept[static_cast<std::size_t>(
            pattern_site(pattern.form, walk.here().i, walk.here().j))];
        surplus -= site;
        site = 0;
        walk.advance();
    }
}

/// Fills the columns from pattern.n_sites() on with a row of sites between two rows.
void StartMaker::add_row(const LatticePattern& pattern, Random& random, Points& points) const {
    RowWalk walk(pattern, random);
    const Lattice reduced = reduce(period_).reduced;
    const Vec2 middle = 0.5 * reduced.translation(walk.along() + walk.across());
    for (Eigen::Index s = pattern.n_sites(); s < n_; ++s) {
        points.col(s) = (reduced.translation(walk.here()) + middle) / pattern.n_sites();
        walk.advance();
    }
}

SearchState StartMaker::neighbour(Random& random) {
    // Draw the kind and the number of the changes, and a lattice.
    const bool in_row = pick(random, 2) == 0;
    const int most = in_row ? std::max(kLooseSites, int(kLongestRow * std::sqrt(n_))) : kLooseSites;
    const int change = 1 + pick(random, most);
    const bool fewer = pick(random, 2) == 0 && change < n_;
    const int m = fewer ? n_ - change : n_ + change;
    const int rank = pick_low(random, static_cast<int>(lattices(m).size()));
    const LatticePattern& pattern = lattices(m)[static_cast<std::size_t>(rank)];
    // Remove surplus sites.
    const Points sites = pattern_points(pattern);
    std::vector<char> kept(static_cast<std::size_t>(m), 1);
    if (in_row && !fewer) remove_row(pattern, random, kept);
    auto surplus = std::count(kept.begin(), kept.end(), 1) - n_;
    while (surplus > 0) {
        checkpoint();
        char& site = kept[static_cast<std::size_t>(pick(random, m))];
        surplus -= site;
        site = 0;
    }
    // Copy the remaining sites, add missing ones and break the symmetry.
    SearchState start{Points(2, n_), {m, rank, in_row}};
    Eigen::Index column = 0;
    for (int s = 0; s < m; ++s) {
        if (kept[static_cast<std::size_t>(s)] != 0) start.points.col(column++) = sites.col(s);
    }
    if (in_row && fewer) {
        add_row(pattern, random, start.points);
    } else {
        for (; column < n_; ++column) {
            start.points.col(column) = period_.to_position({uniform(random), uniform(random)});
        }
    }
    shake(start.points, kJitter, random);
    return start;
}

SearchState StartMaker::restart(Random& random, const std::vector<SearchState>& minima) const {
    const int which = pick_low(random, static_cast<int>(minima.size()));
    SearchState start = minima[static_cast<std::size_t>(which)];
    ++start.origin.restarts;
    const double amount = kWeakestShake + (kStrongestShake - kWeakestShake) * uniform(random);
    shake(start.points, amount, random);
    return start;
}

SearchState StartMaker::make(Random& random, const std::vector<SearchState>& minima) {
    const double kind = uniform(random);
    if (kind < kNeighbours) return neighbour(random);
    if (kind < kNeighbours + kRestarts) return restart(random, minima);
    return {uniform_points(period_, n_, random()), {}};
}

}  // namespace pcvt::plane
