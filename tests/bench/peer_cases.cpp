#include <cstdint>
#include <string>

#include "tests/bench/cases.hpp"
#include "tests/bench/peers.hpp"

namespace pcvt::bench {
namespace {

/// One peer, its expected results, and the largest number of sites for which it is run.
struct PeerCase {
    std::string what;
    Peer* peer;
    int stored_copies;
    bool periodic;
    int most_sites;
};

const PeerCase kPlain{"cgal_plain", cgal_plain, 1, false, 10'000'000};
const PeerCase kOnUnitSquare[] = {
    {"cgal_nine_copies", cgal_nine_copies, 9, true, 100'000},
    {"cgal_periodic", cgal_periodic, 1, true, 1'000'000},
    {"mirrors", mirrors, 1, true, 1'000'000},
    {"voro", voro_prisms, 1, true, 100'000},
};

bool did_the_work(const PeerCase& peer_case, int n, const Diagram& diagram) {
    return diagram.n_vertices == std::int64_t{n} * peer_case.stored_copies &&
           (!peer_case.periodic || diagram.n_triangles == 2 * std::int64_t{n});
}

/// Times the computation from points to diagram, without the diagram's destruction.
void add_peer(const PeerCase& peer_case, const Input& input) {
    if (input.n > peer_case.most_sites) return;
    add_case(peer_case.what, input, [=](benchmark::State& state) {
        const plane::Points points = input.sites();
        for ([[maybe_unused]] auto _ : state) {
            Diagram diagram = peer_case.peer(points);
            state.PauseTiming();
            if (!did_the_work(peer_case, input.n, diagram)) {
                state.SkipWithError("not the diagram of these sites");
                break;
            }
            diagram.structure.reset();
            state.ResumeTiming();
        }
    });
}

}  // namespace

void add_peer_cases(const Input& input) {
    add_peer(kPlain, input);
    if (input.lattice_name != "unit") return;
    for (const PeerCase& peer_case : kOnUnitSquare) add_peer(peer_case, input);
}

}  // namespace pcvt::bench
