/// Measures the tetrahedra inside of cells: their angles and the time that they take.
///
///     grain_quality KIND N [SIZE [SEEDS [ROUNDS [THREADS [SHORTEST]]]]]
///
/// KIND is a word of grain_kinds(), N the number of cells, SIZE the number of edges along the cube
/// root of the volume of a cell (3), SEEDS the number of seeds or the one seed after an equals sign
/// (=7), ROUNDS those of GrainChoices (2), SHORTEST the largest edge to be removed over h (0). Each
/// line shows: tetrahedra a cell; the smallest dihedral angle, the same away from sharp features,
/// and the first percentile of the smallest angles of tetrahedra, the largest angle, degrees; the
/// tetrahedra with an angle below 10 degrees in a million; the mean of three times the inradius
/// over the circumradius; CPU seconds of faces, of filling and of all rounds; and these three
/// together over the time of one plain CGAL triangulation of as many random points as the mesh has
/// nodes.

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "mesher/space/grains/grains.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"
#include "mesher/space/mesh/short_edges.hpp"
#include "tests/bench/space_peers.hpp"
#include "tests/support/grain_cases.hpp"

namespace pcvt::bench {
namespace {

double seconds_by(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double cpu_seconds() { return seconds_by(CLOCK_PROCESS_CPUTIME_ID); }

/// The largest resident memory so far.
long peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
}

struct Choices {
    std::string kind;
    int n = 50;
    double size = 3;
    int n_rounds = 2;
    int n_threads = 1;
    double shortest = 0;
};

struct Quality {
    double smallest = 180;
    double hundredth = 0;
    double largest = 0;
    double below_ten = 0;
    double radius_ratio = 0;
};

/// Three times the inradius over the circumradius.
double radius_ratio(const std::array<space::Vec3, 4>& p) {
    const auto area = [&](int a, int b, int c) {
        return space::length(space::cross_product(p[b] - p[a], p[c] - p[a])) / 2;
    };
    const double areas = area(0, 1, 2) + area(0, 1, 3) + area(0, 2, 3) + area(1, 2, 3);
    const double inradius = space::volume6(p[0], p[1], p[2], p[3]) / 2 / areas;
    return 3 * inradius / space::circumsphere(p[0], p[1], p[2], p[3]).radius;
}

Quality quality_of(const space::TetrahedralMesh& mesh) {
    Quality quality;
    std::vector<double> angles;
    for (const auto& t : mesh.tetrahedra) {
        const std::array<space::Vec3, 4> p{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                                           mesh.points[t[3]]};
        const space::DihedralRange range = space::dihedral_range(p[0], p[1], p[2], p[3]);
        angles.push_back(range.smallest);
        quality.largest = std::max(quality.largest, range.largest);
        quality.radius_ratio += radius_ratio(p);
    }
    std::sort(angles.begin(), angles.end());
    const auto n = static_cast<double>(angles.size());
    quality.smallest = angles.front();
    quality.hundredth = angles[angles.size() / 100];
    quality.below_ten =
        static_cast<double>(std::lower_bound(angles.begin(), angles.end(), 10) - angles.begin()) /
        n * 1e6;
    quality.radius_ratio /= n;
    return quality;
}

double seconds_of_peer(int n) {
    const space::Points points = uniform_points(space::Lattice::box(1, 1, 1), n, 1);
    const double begin = cpu_seconds();
    const SpaceTriangulation result = cgal_plain_in_space(points);
    return cpu_seconds() - begin;
}

int number_of_nodes(const space::TetrahedralMesh& mesh) {
    return 1 + *std::max_element(mesh.point_site.begin(), mesh.point_site.end());
}

void measure(const Choices& choices, std::uint64_t seed) {
    testing::GrainCase grains = testing::grain_case(choices.kind, choices.n, seed);
    grains.complex = without_short_edges(std::move(grains.complex), choices.shortest,
                                         space::ShrinkRule::kWideCorners);
    Workers workers(choices.n_threads);
    std::vector<double> times{cpu_seconds()};
    const long memory = peak_bytes();
    const double wall = seconds_by(CLOCK_MONOTONIC);
    const space::Grains filled =
        mesh_grains(grains.sites, grains.complex,
                    {.size = grains.sites.spacing() / choices.size,
                     .n_rounds = choices.n_rounds,
                     .progress = [&](double) { times.push_back(cpu_seconds()); }},
                    workers);
    const long n_bytes = peak_bytes() - memory;
    const double wall_seconds = seconds_by(CLOCK_MONOTONIC) - wall;
    const space::TetrahedralMesh& mesh = filled.mesh.tetrahedra;
    const Quality quality = quality_of(mesh);
    const double peer = seconds_of_peer(number_of_nodes(mesh));
    const double rounds = times[times.size() - 2] - times[2];
    std::printf(
        "%-8s %5d %4llu  %6.0f  %5.2f %5.2f %5.2f %6.2f  %6.1f  %.3f  %7.3f %7.3f %7.3f  "
        "%5.1f  %6.3f  %5zu  %5.0f\n",
        choices.kind.c_str(), grains.complex.n_cells, static_cast<unsigned long long>(seed),
        static_cast<double>(mesh.n_tetrahedra()) / grains.complex.n_cells, quality.smallest,
        filled.angles.smallest, quality.hundredth, quality.largest, quality.below_ten,
        quality.radius_ratio, times[1] - times[0], times[2] - times[1], rounds,
        (times[times.size() - 2] - times[0]) / peer, wall_seconds, filled.sharp_features.size(),
        static_cast<double>(n_bytes) / mesh.n_tetrahedra());
    std::fflush(stdout);
}

}  // namespace
}  // namespace pcvt::bench

int main(int argc, char** argv) {
    const auto argument = [&](int k, const char* usual) { return k < argc ? argv[k] : usual; };
    pcvt::bench::Choices choices{.kind = argument(1, "cvt"),
                                 .n = std::atoi(argument(2, "50")),
                                 .size = std::atof(argument(3, "3")),
                                 .n_rounds = std::atoi(argument(5, "2")),
                                 .n_threads = std::atoi(argument(6, "1")),
                                 .shortest = std::atof(argument(7, "0"))};
    const std::string seeds = argument(4, "1");
    const bool is_one = seeds.front() == '=';
    const int first = is_one ? std::atoi(seeds.c_str() + 1) : 1;
    const int last = is_one ? first : std::atoi(seeds.c_str());
    std::printf(
        "kind         n seed   tets/c   min  away    p1    max  <10ppm  rr     faces    fill  "
        "rounds   CGAL\n");
    for (int seed = first; seed <= last; ++seed)
        pcvt::bench::measure(choices, static_cast<std::uint64_t>(seed));
    return 0;
}
