#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "mesher/plane/search/lattice_pattern.hpp"

namespace pcvt::plane {

/// The origin of a start of the global search.
struct StartOrigin {
    /// The start derives from a lattice of `lattice_sites` sites; 0: from random sites.
    int lattice_sites = 0;
    /// The rank of that lattice by energy among all lattices with as many sites, from 0.
    int rank = 0;
    /// Whether the removed or added sites follow a row of the lattice; otherwise they are
    /// scattered.
    bool in_row = false;
    /// How many times the minimum was shaken and optimised again.
    int restarts = 0;
};

/// Describes an origin, e.g. "lattice of 18, 2 sites removed in a row, then 3 noisy restarts"; n as
/// in StartMaker.
std::string start_words(const StartOrigin& origin, int n);

/// The sites of a local minimum or of a start.
struct SearchState {
    /// 2 x n, length units.
    Points points;
    StartOrigin origin;
    /// Set for minima; length^4.
    double energy = 0;
};

/// Generates starts that often lead to minima of low energy.
///
/// Example usage:
///   StartMaker maker(period, n);
///   StartMaker::Random random(seed);
///   const LatticePattern best = best_lattice(period, n);
///   const SearchState start = maker.make(random, {{pattern_points(best), {n}, best.energy}});
///
/// A minimum below the best lattice has four non-hexagonal cells, which form two dislocations; a
/// row of sites runs from one dislocation to the other. Half of the starts are therefore lattices
/// with a slightly different number of sites, in which a row of sites or a few scattered sites are
/// removed or added. Most of the others are the lowest minima found so far, shaken.
class StartMaker {
   public:
    using Random = std::mt19937_64;

    StartMaker(const Lattice& period, int n);

    /// Returns the same start for the same state of `random` and the same minima, on every machine.
    /// @param minima  at least one, sorted by energy.
    SearchState make(Random& random, const std::vector<SearchState>& minima);

   private:
    SearchState neighbour(Random& random);
    SearchState restart(Random& random, const std::vector<SearchState>& minima) const;
    void remove_row(const LatticePattern& pattern, Random& random, std::vector<char>& kept) const;
    void add_row(const LatticePattern& pattern, Random& random, Points& points) const;
    void shake(Points& points, double amount, Random& random) const;
    const std::vector<LatticePattern>& lattices(int n_sites);

    Lattice period_;
    int n_;
    /// h = sqrt(area / n).
    double spacing_;
    std::map<int, std::vector<LatticePattern>> lattices_;
};

}  // namespace pcvt::plane
