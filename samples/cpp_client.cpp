// Uses the C interface of pcvt from C++: computes the Delaunay triangles of 60 given sites, prints
// their edge lengths, and shows that coincident sites are refused. Needs libpcvt.so and pcvt.h, but
// neither Eigen nor OpenMesh.
#include <pcvt.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct FreeResult {
    void operator()(pcvt_result* result) const { pcvt_free(result); }
};
using Result = std::unique_ptr<pcvt_result, FreeResult>;

void require(pcvt_status status) {
    if (status < 0) throw std::runtime_error(pcvt_last_error());
}

Result generate(const std::vector<double>& sites) {
    pcvt_options options;
    require(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION));
    options.sites = sites.data();
    options.n_sites = static_cast<int>(sites.size() / 2);
    pcvt_result* result = nullptr;
    require(pcvt_generate(&options, &result));
    return Result(result);
}

/// Returns points that fill the unit square evenly: multiples of powers of the plastic number.
std::vector<double> even_sites(int n) {
    std::vector<double> sites;
    for (int k = 1; k <= n; ++k) {
        sites.insert(sites.end(), {std::fmod(k * 0.7548776662, 1), std::fmod(k * 0.5698402910, 1)});
    }
    return sites;
}

void print_edge_lengths(const pcvt_tile& tile) {
    double shortest = INFINITY;
    double longest = 0;
    for (int f = 0; f < tile.n_faces; ++f) {
        for (int k = 0; k < 3; ++k) {
            const double* p = tile.points + 2 * tile.corners[3 * f + k];
            const double* q = tile.points + 2 * tile.corners[3 * f + (k + 1) % 3];
            const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
            shortest = std::min(shortest, length);
            longest = std::max(longest, length);
        }
    }
    std::printf("%d triangles, edges from %.4f to %.4f, %d pairs on the seam\n", tile.n_faces,
                shortest, longest, tile.n_edge_pairs);
}

}  // namespace

int main() {
    std::vector<double> sites = even_sites(60);
    const Result result = generate(sites);
    pcvt_tile tile;
    require(pcvt_get_tile(result.get(), PCVT_DELAUNAY, PCVT_WHOLE, &tile, sizeof tile));
    print_edge_lengths(tile);
    try {
        sites.insert(sites.end(), {sites[0] + 3, sites[1] - 1});
        generate(sites);
    } catch (const std::runtime_error& error) {
        std::printf("refused as it should be: %s\n", error.what());
    }
}
