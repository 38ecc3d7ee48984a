#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::bench {

/// The RMS residuals at which "converging" begins, and at which a run from random sites ends.
inline constexpr double kConverging = 1e-3;
inline constexpr double kEnd = 1e-4;

/// Random sites, the same for all cases: uniform in the fundamental domain.
struct Input {
    std::string lattice_name;
    plane::Lattice lattice;
    int n;

    plane::Points sites() const;
};

/// Registers a case by its name, in the form `<what>/<lattice>/<n>`.
benchmark::internal::Benchmark* add_case(const std::string& name,
                                         const std::function<void(benchmark::State&)>& body);

/// Registers the case `<what>/<lattice>/<n>`. Cases run in the order of registration, so cases that
/// a ratio compares should be registered next to each other.
benchmark::internal::Benchmark* add_case(const std::string& what, const Input& input,
                                         const std::function<void(benchmark::State&)>& body);

/// The CPU time of all threads of this process.
double cpu_seconds();

/// Enlarges the heap and makes it keep freed memory. Otherwise a build pays for new pages, a tenth
/// of CGAL's time, depending on the cases before it. Called once, before all cases.
void warm_the_heap();

/// Releases free memory and restores malloc's default behaviour from here on; for the last case.
void cool_the_heap();

/// The other methods to compute a diagram (peers.hpp): one case each, where it supports the lattice
/// and n.
void add_peer_cases(const Input& input);

/// The moving periodic Delaunay triangulation, and the optimiser on it.
void add_engine_cases(const Input& input);
/// The first iterations of the optimiser, which take most of a minute at 1e7 sites.
void add_large_case(const Input& input);

/// The tile of the cells and its proof; files of it, which are read back and proved.
void add_mesh_cases(const Input& input);
/// Cells of prescribed areas, on random sites.
void add_area_cases(const Input& input);

/// The cost of the C interface: a run through it over the same run through a call of the mesher.
void add_abi_case(const Input& input);

/// Three dimensions: n random sites of the unit cube, this program's tetrahedra and those of CGAL.
void add_space_cases(int n);
/// Only cells of prescribed volumes in space, and their unit.
void add_small_space_cases(int n);
/// The image of the cells of n random sites of the unit cube in 256 x 256 x 256 voxels, one thread.
void add_voxel_case(int n);

/// Cases of one size only: many small runs, and resident memory, which must come last.
void add_single_cases();

}  // namespace pcvt::bench
