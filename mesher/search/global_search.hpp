#pragma once

#include <cstdint>
#include <string>

#include "mesher/cvt/cvt.hpp"
#include "mesher/search/lattice_pattern.hpp"

namespace pcvt {

struct SearchOptions {
    std::uint64_t seed = 0;
    /// Evaluations of the energy; the search ends when they are spent, which the last
    /// starts may overrun by one step each.
    int budget = 0;
    /// At least 1. The result does not depend on it.
    int n_threads = 1;
    /// Called between starts and now and then within; false cancels.
    ProgressCallback progress = {};
};

struct SearchResult {
    /// Nothing below is meant to be used then, but for the counts.
    bool cancelled = false;
    /// The best exact lattice for n.
    LatticePattern lattice;
    /// The best sites, 2 x n, length units; pattern_points(lattice) where nothing lies below it.
    Points points;
    /// Of the sites, at a residual of 1e-9; never above lattice.energy.
    double energy = 0;
    /// How they were found, in words.
    std::string found;
    int starts = 0;
    int evaluations = 0;
};

/// Evaluations that take a few seconds on one core: 2,000 n up to 100 sites, 200,000 up to 400,
/// then in inverse proportion to n.
int default_search_budget(int n);

/// Looks for the lowest periodic CVT of n sites: the best exact lattice, and local minima reached
/// from many starts (search_starts.hpp).
///
/// Starts are optimised a round of 8 at a time, in parallel; a round knows only the minima of the
/// rounds before, so the result depends on the seed and the budget alone. Starts are given up when
/// they have no hope of ending below what is known. For n where the budget allows no minimisation
/// (it is below 50 evaluations a start, so from 2e5 sites on by default) only the lattice is looked
/// at. Laws, tested by number:
///   (1) The energy is never above that of the best lattice.
///   (2) The result is the same for any number of threads.
/// @throws InvalidInput if n < 1 or the lattice cannot be reduced.
SearchResult search_minimum(const Lattice& period, int n, const SearchOptions& options);

}  // namespace pcvt
