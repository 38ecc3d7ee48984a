#include <benchmark/benchmark.h>

#include <string>
#include <utility>

#include "tests/bench/cases.hpp"

namespace pcvt::bench {
namespace {

void add_cases() {
    const std::pair<std::string, plane::Lattice> lattices[] = {
        {"unit", plane::Lattice::rectangle(1, 1)},
        {"oblique", plane::Lattice({1, 0}, {0.37, 0.81})},
        {"thin", plane::Lattice::rectangle(20, 1)},
    };
    for (const int n : {10'000, 100'000, 1'000'000}) {
        for (const auto& [name, lattice] : lattices) {
            add_peer_cases({name, lattice, n});
            add_engine_cases({name, lattice, n});
            add_mesh_cases({name, lattice, n});
        }
    }
    add_peer_cases({"unit", plane::Lattice::rectangle(1, 1), 10'000'000});
    add_large_case({"unit", plane::Lattice::rectangle(1, 1), 10'000'000});
    for (const int n : {1000, 10'000, 100'000, 1'000'000}) {
        add_area_cases({"unit", plane::Lattice::rectangle(1, 1), n});
    }
    add_small_space_cases(1000);
    for (const int n : {10'000, 100'000}) add_space_cases(n);
    for (const int n : {1000, 10'000}) add_voxel_case(n);
    add_single_cases();
}

}  // namespace
}  // namespace pcvt::bench

/// Runs the cases once, in order; tests/bench/run repeats this in interleaved rounds.
int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::AddCustomContext("compiler", PCVT_BENCH_COMPILER);
    benchmark::AddCustomContext("flags", PCVT_BENCH_FLAGS);
    pcvt::bench::warm_the_heap();
    pcvt::bench::add_cases();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
