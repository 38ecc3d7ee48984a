#pragma once

#include <cstdint>
#include <string>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/search/lattice_pattern.hpp"

namespace pcvt::plane {

struct SearchOptions {
    /// The threads, on which the result does not depend, and the callback, which is called between
    /// rounds of starts and from time to time within a round; returning false cancels.
    RunOptions run = {};
    /// Evaluations of the energy after which the search ends; each start of the last round may
    /// exceed its share by one step.
    int budget = 0;
};

struct SearchResult {
    /// If true, only the counts below are meaningful.
    bool cancelled = false;
    /// The best exact lattice for n.
    LatticePattern lattice;
    /// The best sites, 2 x n, length units; pattern_points(lattice) if no lower minimum was found.
    Points points;
    /// The energy of `points` at a residual of 1e-9; never above lattice.energy.
    double energy = 0;
    /// The origin of `points` in words (see start_words).
    std::string found;
    int starts = 0;
    int evaluations = 0;
};

/// Returns a number of evaluations that takes a few seconds on one core: 2,000 n up to 100 sites,
/// 200,000 up to 400 sites, then inversely proportional to n.
int default_search_budget(int n);

/// Searches for the periodic CVT of n sites with the lowest energy, among the exact lattices and
/// the local minima reached from many starts (search_starts.hpp).
///
/// Example usage:
///   const Lattice unit = Lattice::rectangle(1, 1);
///   const SearchResult best =
///       search_minimum(unit, 18, 1, {.budget = default_search_budget(18)});
///   std::cout << best.found << ": " << best.energy << "\n";
///
/// Starts are optimised in parallel, in rounds of 8. A round uses only the minima of earlier
/// rounds, so the result depends only on the seed and the budget. A start is abandoned once it
/// cannot be expected to end below the minima found so far. If the budget is too small for a
/// minimisation (less than 50 evaluations per start; with the default budget this holds from 2e5
/// sites on), only lattices are compared. Laws, tested by number:
///   (1) The energy is never above that of the best lattice.
///   (2) The result is the same for any number of threads.
/// @throws InvalidInput if n < 1 or the lattice cannot be reduced.
SearchResult search_minimum(const Lattice& period, int n, std::uint64_t seed,
                            const SearchOptions& options);

}  // namespace pcvt::plane
