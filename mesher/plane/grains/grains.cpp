#include "mesher/plane/grains/grains.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/grains/corner_guards.hpp"
#include "mesher/plane/grains/grain_refinement.hpp"
#include "mesher/plane/grains/grain_smoothing.hpp"
#include "mesher/plane/grains/grain_triangulation.hpp"
#include "mesher/plane/grains/triangle_shape.hpp"

namespace pcvt::plane {
namespace {

using Edge = GrainTriangulation::Edge;

/// Passes of refinement and smoothing: smoothing may make room for a vertex that did not fit
/// before. Further passes gave no improvement in experiments.
constexpr int kPasses = 3;

/// A corner with a smaller angle, degrees, cuts the edges at its vertex so finely that firm chords
/// leave no room for good triangles there.
constexpr double kVerySharp = 7;

/// Returns for each vertex the angle of its sharpest corner, degrees; 180 if none is sharp.
std::vector<double> sharpest_corners(const PeriodicMesh& cells, const GuardedCells& guarded) {
    std::vector<double> sharpest(cells.vertices.size(), 180);
    for (const SharpCorner& corner : guarded.sharp) {
        double& angle = sharpest[cells.corner_vertex[corner.corner]];
        angle = std::min(angle, corner.angle);
    }
    return sharpest;
}

/// Marks the guards that the triangulation contains. The chord of a guard may be split, which
/// divides the angle at the tip, if that angle is small in any case or another corner at the vertex
/// is very sharp.
void make_guards(const PeriodicMesh& cells, const GuardedCells& guarded,
                 GrainTriangulation& grains) {
    const std::vector<double> sharpest = sharpest_corners(cells, guarded);
    for (std::size_t k = 0; k < guarded.tip.size(); ++k) {
        const SharpCorner& corner = guarded.sharp[k];
        const bool splits = corner.angle <= kSmallestAngle ||
                            sharpest[cells.corner_vertex[corner.corner]] < kVerySharp;
        const int h = grains.halfedge_of_corner(guarded.tip[k]);
        const int chord = GrainTriangulation::next(h);
        const int back = GrainTriangulation::previous(h);
        if (grains.edge(chord) != Edge::kFree || grains.edge(back) == Edge::kFree) continue;
        grains.make_guard(h, splits ? Edge::kCell : Edge::kFirm);
    }
}

/// Returns the smallest angle outside the guards; the only small angle of a guard is at its tip.
double smallest_angle(const GrainTriangulation& grains) {
    double smallest = 180;
    for (int t = 0; t < grains.n_triangles(); ++t) {
        checkpoint_each(t);
        if (grains.is_guard(t)) continue;
        for (int k = 0; k < 3; ++k) {
            smallest = std::min(smallest, angle_at(grains.triangle(t), k));
        }
    }
    return smallest;
}

/// The largest number of attempts; each halves the guards that blocked good triangles before.
constexpr int kAttempts = 12;

/// The target sizes for the two steps that use them, and the callback for the progress.
struct Sizes {
    RefinementSizes refinement;
    GuardOptions guards;
    const std::function<void(double)>& progress;
};

struct Attempt {
    GuardedCells guarded;
    GrainTriangulation grains;
    double smallest_angle = 0;
    /// The vertices whose guards blocked good triangles.
    std::set<int> in_the_way = {};
};

Attempt attempt(const PeriodicMesh& cells, const Sizes& sizes) {
    GuardedCells guarded = guard_corners(cells, sizes.guards);
    GrainTriangulation grains(guarded.cells);
    Attempt result{std::move(guarded), std::move(grains)};
    make_guards(cells, result.guarded, result.grains);
    RefinementLeft left;
    for (int pass = 0; pass < kPasses; ++pass) {
        left = refine(result.grains, sizes.refinement, sizes.progress);
        if (left.too_thin >= 0) throw ThinCell(cells.site[left.too_thin]);
        if (left.n_given_up == 0) break;
        widen_angles(result.grains, kWantedAngle);
    }
    result.smallest_angle = smallest_angle(result.grains);
    for (const int v : left.in_the_way) {
        if (v < cells.n_vertices()) continue;
        const int tip = result.guarded.tip_of_new[v - cells.n_vertices()];
        if (tip >= 0) result.in_the_way.insert(tip);
    }
    return result;
}

/// Repeats the meshing with smaller guards while guards leave no room for good triangles beside
/// their long sides, and returns the best attempt.
Attempt best_attempt(const PeriodicMesh& cells, Sizes sizes) {
    sizes.guards.part.assign(cells.vertices.size(), 1);
    Attempt best = attempt(cells, sizes);
    std::set<int> in_the_way = best.in_the_way;
    for (int k = 1; k < kAttempts && best.smallest_angle <= kSmallestAngle; ++k) {
        if (in_the_way.empty()) break;
        for (const int v : in_the_way) sizes.guards.part[v] /= 2;
        Attempt next = attempt(cells, sizes);
        in_the_way = next.in_the_way;
        if (next.smallest_angle > best.smallest_angle) best = std::move(next);
    }
    return best;
}

/// Returns the corners with small angles in the triangles of their guards.
std::vector<NamedCorner> named_corners(const PeriodicMesh& cells, const Attempt& attempt) {
    std::set<std::tuple<int, double, double>> tips;
    const GrainTriangulation& grains = attempt.grains;
    for (int t = 0; t < grains.n_triangles(); ++t) {
        checkpoint_each(t);
        for (int k = 0; k < 3 && grains.is_guard(t); ++k) {
            if (angle_at(grains.triangle(t), k) > kSmallestAngle) continue;
            const Vec2& tip = grains.point(3 * t + k);
            tips.emplace(grains.cell(t), tip.x(), tip.y());
        }
    }
    std::vector<NamedCorner> named;
    for (const SharpCorner& corner : attempt.guarded.sharp) {
        const Vec2 tip = cells.point(corner.corner);
        if (corner.angle > kSmallestAngle &&
            !tips.contains({cells.corner_face[corner.corner], tip.x(), tip.y()})) {
            continue;
        }
        named.push_back({corner.corner, corner.angle});
    }
    return named;
}

/// Requires that corners of cells are not so sharp that the triangles beside them are too many:
/// about as many as the reciprocal of the angle says, in radians.
void require_meshable(const PeriodicMesh& cells) {
    constexpr double kMostSharp = 1e5;
    constexpr double kMostSharpAVertex = 50;
    double sum = 0;
    int sharpest = 0;
    double least_sine = 1;
    for (int c = 0; c < cells.n_corners(); ++c) {
        checkpoint_each(c);
        const Vec2 before = cells.point(cells.previous(c)) - cells.point(c);
        const Vec2 after = cells.point(cells.next(c)) - cells.point(c);
        const double sine = std::abs(cross(after, before)) / (before.norm() * after.norm());
        if (!(after.dot(before) > 0)) continue;
        sum += 1 / sine;
        if (sine < least_sine) {
            least_sine = sine;
            sharpest = c;
        }
    }
    if (sum <= kMostSharp + kMostSharpAVertex * cells.n_vertices()) return;
    throw ThinCell(cells.site[cells.corner_face[sharpest]]);
}

Grains mesh(const PeriodicMesh& cells, const Sizes& sizes) {
    require_meshable(cells);
    const Attempt best = best_attempt(cells, sizes);
    const GrainTriangulation& grains = best.grains;
    Grains result{grains.mesh(cells), {}, named_corners(cells, best), best.smallest_angle};
    for (int t = 0; t < grains.n_triangles(); ++t) {
        checkpoint_each(t);
        result.cell.push_back(grains.cell(t));
    }
    return result;
}

}  // namespace

Grains mesh_grains(const PeriodicMesh& cells, double size,
                   const std::function<void(double)>& progress) {
    return mesh(cells, {{std::vector<double>(cells.site.size(), size), size}, {size}, progress});
}

Grains mesh_grains_per_edge(const PeriodicMesh& cells, int parts,
                            const std::function<void(double)>& progress) {
    constexpr double kNoLimit = std::numeric_limits<double>::infinity();
    RefinementSizes refinement{{}, kNoLimit};
    for (int f = 0; f < cells.n_faces(); ++f) {
        checkpoint_each(f);
        double perimeter = 0;
        for (int c = cells.face_begin[f]; c < cells.face_begin[f + 1]; ++c) {
            perimeter += (cells.point(cells.next(c)) - cells.point(c)).norm();
        }
        refinement.of_cell.push_back(perimeter /
                                     ((cells.face_begin[f + 1] - cells.face_begin[f]) * parts));
    }
    return mesh(cells, {std::move(refinement), {kNoLimit, parts}, progress});
}

}  // namespace pcvt::plane
