#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>

#include "mesher/lattice/lattice.hpp"

namespace pcvt::bench {

/// Random sites, the same ones for all cases: uniform in the fundamental domain.
struct Input {
    std::string lattice_name;
    Lattice lattice;
    int n;

    Points sites() const;
};

/// Registers the case `<what>/<lattice>/<n>`. Cases run in the order in which they were added, so
/// that those which a ratio compares should stand side by side.
benchmark::internal::Benchmark* add_case(const std::string& what, const Input& input,
                                         const std::function<void(benchmark::State&)>& body);

/// Of all threads of this process.
double cpu_seconds();

/// Makes the heap large and lets it keep what is freed. Without this a build pays for fresh pages,
/// a tenth of CGAL's time, or not, according to what ran before it. Called once, before all cases.
void warm_the_heap();

/// Gives back what is free and lets malloc do as it does by itself, from here on: for the last
/// case.
void cool_the_heap();

/// The other ways to a diagram (peers.hpp): one case each, as far as it suits lattice and n.
void add_peer_cases(const Input& input);

/// The periodic Delaunay triangulation that moves, and the optimiser on it.
void add_engine_cases(const Input& input);

/// What the C interface costs: a run by it over the same run by a call of the mesher.
void add_abi_case(const Input& input);

/// Cases of one size only: many small runs, and resident memory, which must come last.
void add_single_cases();

}  // namespace pcvt::bench
