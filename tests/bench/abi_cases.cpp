#include <algorithm>
#include <limits>

#include "mesher/plane/cvt/cvt.hpp"
#include "plugin/pcvt.h"
#include "tests/bench/cases.hpp"

namespace pcvt::bench {
namespace {

/// Far fewer than a run needs: the cost of the interface arises once per call.
constexpr int kAbiIterations = 100;
/// Both variants alternate, and the fastest turn of each counts: other load on the machine costs
/// more than the interface.
constexpr int kTurns = 9;

/// The time of a run, including the creation and destruction of its result.
struct Timed {
    double seconds;
    double energy;
};

Timed by_call(const Input& input, const plane::Points& sites) {
    const double start = cpu_seconds();
    double energy = 0;
    {
        plane::CvtOptions options;
        options.run.max_iterations = kAbiIterations;
        energy = compute_cvt(input.lattice, sites, options).run.energy;
    }
    return {cpu_seconds() - start, energy};
}

Timed by_interface(const Input& input, const plane::Points& sites) {
    const double start = cpu_seconds();
    pcvt_options options;
    pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION);
    options.sites = sites.data();
    options.n_sites = input.n;
    options.n_threads = 1;
    options.max_iterations = kAbiIterations;
    pcvt_result* result = nullptr;
    pcvt_sites view{};
    pcvt_generate(&options, &result);
    pcvt_get_sites(result, &view, sizeof view);
    const double before = cpu_seconds();
    // Not timed, since this call computes the cells.
    pcvt_statistics figures{};
    pcvt_get_statistics(result, &figures, sizeof figures);
    const double after = cpu_seconds();
    pcvt_free(result);
    return {cpu_seconds() - start - (after - before), figures.energy};
}

}  // namespace

void add_abi_case(const Input& input) {
    const auto body = [=](benchmark::State& state) {
        const plane::Points sites = input.sites();
        for ([[maybe_unused]] auto _ : state) {
            double least_call = std::numeric_limits<double>::infinity();
            double least_interface = least_call;
            for (int turn = 0; turn < kTurns; ++turn) {
                const Timed call = by_call(input, sites);
                const Timed interface = by_interface(input, sites);
                if (interface.energy != call.energy) state.SkipWithError("the results differ");
                least_call = std::min(least_call, call.seconds);
                least_interface = std::min(least_interface, interface.seconds);
            }
            state.counters["ratio"] = least_interface / least_call;
        }
    };
    add_case("abi", input, body)->Iterations(1);
}

}  // namespace pcvt::bench
