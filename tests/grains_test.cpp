#include "mesher/grains.hpp"

#include <gtest/gtest.h>
#include <cstdio>
#include <chrono>

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
        stats(cut_along_box(cells, find_box_origin(cells)).pieces, part);
    }
}
}  // namespace
}  // namespace pcvt
