#include "mesher/grains.hpp"

#include <gtest/gtest.h>
#include <cstdio>
#include <chrono>
#include <optional>
#include <random>

#include "mesher/error.hpp"
#include "mesher/box_origin.hpp"
#include "mesher/box_outline.hpp"
#include "mesher/short_edges.hpp"
#include "mesher/triangle_shape.hpp"
#include "mesher/voronoi.hpp"
#include "mesher/cvt.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt {
namespace {
void stats(const PeriodicMesh& cells, double part) {
    const double h = std::sqrt(cells.lattice.area() / cells.n_faces());
    const auto t0 = std::chrono::steady_clock::now();
    const Grains g = mesh_grains(cells, part * h);
    const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    int below[5] = {0,0,0,0,0};
    double smallest = 180, sum = 0;
    for (int t = 0; t < g.triangles.n_faces(); ++t) {
        std::array<Vec2, 3> tri{g.triangles.point(3*t), g.triangles.point(3*t+1), g.triangles.point(3*t+2)};
        for (int k = 0; k < 3; ++k) {
            const double a = angle_at(tri, k);
            smallest = std::min(smallest, a);
            if (a < 20) { ++below[0];
               if (g.triangles.corner_vertex[3*t+k] < cells.n_vertices() && a < 20) ++below[1]; }
            sum += side_lengths(tri)[k];
        }
    }
    std::printf("cells %d triangles %d smallest %.3f below20 %d at corners %d, mean edge/size %.3f  %.3f s\n", cells.n_faces(), g.triangles.n_faces(), smallest, below[0], below[1], sum/(3*g.triangles.n_faces())/(part*h), s);
}
TEST(Grains, Scratch) {
    const int n = atoi(getenv("N") ? getenv("N") : "100");
    const double part = atof(getenv("P") ? getenv("P") : "0.333");
    for (int seed = 0; seed < 5; ++seed) {
        const Lattice unit = Lattice::rectangle(1, 1);
        CvtOptions o; o.max_iterations = atoi(getenv("K") ? getenv("K") : "0"); o.tolerance=1e-3;
        const PeriodicMesh all = periodic_mesh(compute_cvt(unit, uniform_points(unit, n, seed), o), TileKind::kCells);
        const PeriodicMesh cells = without_short_edges(all, 0.02 / std::sqrt(n));
        stats(cells, part);
        stats(cut_along_box(cells, find_box_origin(cells), 0.01 / std::sqrt(n)).pieces, part);
    }
}
}  // namespace
}  // namespace pcvt
namespace pcvt { namespace {
TEST(Grains, Fuzz) {
    std::mt19937_64 random(std::strtoull(getenv("S") ? getenv("S") : "1", nullptr, 10));
    int worst_cases = 0;
    for (int k = 0; k < atoi(getenv("M") ? getenv("M") : "300"); ++k) {
        const Lattice lattice = k % 3 ? testing::random_lattice(random) : testing::lattices()[k / 3 % 10].lattice;
        const int n = 1 + int(random() % (k % 5 == 0 ? 60 : 9));
        const Sites sites(lattice, uniform_points(lattice, n, random()));
        const PeriodicMesh all = cell_mesh(PeriodicDelaunay(sites));
        const double h = std::sqrt(lattice.area() / n);
        const PeriodicMesh cells = without_short_edges(all, 0.02 * h);
        const double part = std::array{0.1, 0.333, 1.0, 3.0}[random() % 4];
        const std::array<Vec2, 3> origins{find_box_origin(cells), Vec2(0, 0), cells.vertices[0] + Vec2(3e-3 * h, 1e-2 * h)};
        for (int o = -1; o < 3; ++o) {
            const PeriodicMesh in = o < 0 ? cells : cut_along_box(cells, origins[o], 0.01 * h).pieces;
            std::fprintf(stderr, "case %d n %d part %g o %d\n", k, n, part, o);
            std::optional<Grains> og;
            try { og = mesh_grains(in, part * h); } catch (const LimitExceeded& e) { std::printf("limit: case %d o %d\n", k, o); continue; }
            const Grains& g = *og; int bad = 0; double smallest = 180;
            for (int t = 0; t < g.triangles.n_faces(); ++t) {
                std::array<Vec2, 3> tri{g.triangles.point(3*t), g.triangles.point(3*t+1), g.triangles.point(3*t+2)};
                for (int c = 0; c < 3; ++c) {
                    const double a = angle_at(tri, c);
                    if (a < 20 && g.triangles.corner_vertex[3*t+c] >= in.n_vertices()) { ++bad; smallest = std::min(smallest, a); }
                }
            }
            double sharpest = 180;
            for (const auto& s : guard_corners(in, part * h).sharp) sharpest = std::min(sharpest, s.angle);
            if (bad) { ++worst_cases; std::printf("case %d n %d part %g o %d: %d triangles, %d bad, smallest %g, sharpest corner %g\n", k, n, part, o, g.triangles.n_faces(), bad, smallest, sharpest); }
        }
    }
    std::printf("bad cases %d\n", worst_cases);
}
}}
