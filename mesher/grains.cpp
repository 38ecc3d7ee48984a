#include "mesher/grains.hpp"

#include <algorithm>

#include "mesher/corner_guards.hpp"
#include "mesher/grain_refinement.hpp"
#include "mesher/grain_smoothing.hpp"
#include "mesher/grain_triangulation.hpp"
#include "mesher/quality.hpp"
#include "mesher/triangle_shape.hpp"

namespace pcvt {
namespace {

using Edge = GrainTriangulation::Edge;

/// Vertices that have moved may let in a vertex that found no room before; more passes were not
/// seen to help.
constexpr int kPasses = 3;

/// Makes the edges of the guards firm, where the triangulation has their triangles.
void make_guards_firm(const GuardedCells& guarded, GrainTriangulation& grains) {
    for (const int tip : guarded.tip) {
        const int h = grains.halfedge_of_corner(tip);
        const int chord = GrainTriangulation::next(h);
        const int back = GrainTriangulation::previous(h);
        if (grains.edge(chord) != Edge::kFree || grains.edge(back) == Edge::kFree) continue;
        for (const int side : {h, chord, back}) grains.make_firm(side);
    }
}

/// The only small angle of a guard is in its tip.
bool is_guard(const GrainTriangulation& grains, int t) {
    return grains.edge(3 * t) == Edge::kFirm && grains.edge(3 * t + 1) == Edge::kFirm &&
           grains.edge(3 * t + 2) == Edge::kFirm;
}

double smallest_angle(const GrainTriangulation& grains) {
    double smallest = 180;
    for (int t = 0; t < grains.n_triangles(); ++t) {
        if (is_guard(grains, t)) continue;
        for (int k = 0; k < 3; ++k) {
            smallest = std::min(smallest, angle_at(grains.triangle(t), k));
        }
    }
    return smallest;
}

}  // namespace

Grains mesh_grains(const PeriodicMesh& cells, double size) {
    const GuardedCells guarded = guard_corners(cells, size);
    GrainTriangulation grains(guarded.cells);
    make_guards_firm(guarded, grains);
    for (int pass = 0; pass < kPasses && refine(grains, size) > 0; ++pass) {
        widen_angles(grains, kWantedAngle);
    }
    Grains result{grains.mesh(cells), {}, {}, smallest_angle(grains)};
    const std::vector<int> sides = cell_sides(cells);
    for (int t = 0; t < grains.n_triangles(); ++t) {
        result.cell.push_back(grains.cell(t));
        result.triangles.whole_sides.push_back(sides[grains.cell(t)]);
    }
    for (const SharpCorner& corner : guarded.sharp) {
        if (corner.angle <= kSmallestAngle) {
            result.named_corners.push_back({corner.corner, corner.angle});
        }
    }
    return result;
}

}  // namespace pcvt
