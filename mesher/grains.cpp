#include "mesher/grains.hpp"

#include <algorithm>

#include "mesher/grain_refinement.hpp"
#include "mesher/grain_smoothing.hpp"
#include "mesher/grain_triangulation.hpp"
#include "mesher/quality.hpp"
#include "mesher/triangle_shape.hpp"

namespace pcvt {
namespace {

/// Makes the edges of the guards firm, where the triangulation has their triangles.
void make_guards_firm(const GuardedCells& guarded, GrainTriangulation& grains) {
    for (const SharpCorner& tip : guarded.sharp) {
        const int h = grains.halfedge_of_corner(tip.corner);
        const int chord = GrainTriangulation::next(h);
        const int back = GrainTriangulation::previous(h);
        if (grains.edge(chord) != GrainTriangulation::Edge::kFree ||
            grains.edge(back) == GrainTriangulation::Edge::kFree) {
            continue;
        }
        for (const int side : {h, chord, back}) grains.make_firm(side);
    }
}

}  // namespace

Grains mesh_grains(const PeriodicMesh& cells, double size) {
    const GuardedCells guarded = guard_corners(cells, size);
    GrainTriangulation grains(guarded.cells);
    make_guards_firm(guarded, grains);
    refine(grains, size);
    if (!getenv("NOSMOOTH")) widen_angles(grains, kWantedAngle);
    for (int t = 0; getenv("DUMP") && t < grains.n_triangles(); ++t) {
        if (smallest_sine(grains.triangle(t)) > 0.342) continue;
        bool guard = true;
        for (int k = 0; k < 3; ++k) guard = guard && grains.edge(3*t+k) == GrainTriangulation::Edge::kFirm;
        if (guard) continue;
        printf("bad: ");
        for (int k = 0; k < 3; ++k) printf(" v%d%s (%.6f %.6f) %.2f %s |", grains.vertex(3*t+k), grains.vertex(3*t+k)<cells.n_vertices()?"*": grains.vertex(3*t+k)<guarded.cells.n_vertices()?"g":"", grains.point(3*t+k).x(), grains.point(3*t+k).y(), angle_at(grains.triangle(t),k), grains.edge(3*t+k)==GrainTriangulation::Edge::kFirm?"firm":grains.edge(3*t+k)==GrainTriangulation::Edge::kCell?"cell":"-");
        printf(" size %g\n", size);
    }
    Grains result{grains.mesh(cells), {}, {}, 180};
    for (int t = 0; t < grains.n_triangles(); ++t) result.cell.push_back(grains.cell(t));
    return result;
}

}  // namespace pcvt
