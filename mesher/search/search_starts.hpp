#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "mesher/search/lattice_pattern.hpp"

namespace pcvt {

/// How a start of the global search was made.
struct StartOrigin {
    /// A lattice of `lattice_sites` sites, 0: random sites.
    int lattice_sites = 0;
    /// Its place by energy among the lattices of that many sites, from 0.
    int rank = 0;
    /// How many of the changed sites followed a row of the lattice; else they lay anywhere.
    bool in_row = false;
    /// How often the minimum was shaken and optimised again.
    int restarts = 0;
};

/// "lattice of 18, 2 sites removed in a row, then 3 noisy restarts"; n as in StartMaker.
std::string start_words(const StartOrigin& origin, int n);

/// A local minimum, or a start for one.
struct SearchState {
    /// 2 x n, length units.
    Points points;
    StartOrigin origin;
    /// length^4; of a minimum.
    double energy = 0;
};

/// Makes starts from which minima of low energy are often reached.
///
/// A minimum below the best lattice has four cells without six sides: two dislocations, between
/// which a row of sites ends. So half of the starts are lattices of a neighbouring number of sites
/// in which a row of sites, or some anywhere, is removed or added. Most others are the lowest
/// minima found so far, shaken.
class StartMaker {
   public:
    using Random = std::mt19937_64;

    StartMaker(const Lattice& period, int n);

    /// The same for the same state of `random` and the same minima, on every machine.
    /// @param minima  at least one, from the lowest on.
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

}  // namespace pcvt
