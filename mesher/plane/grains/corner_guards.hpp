#pragma once

#include "mesher/plane/mesh/periodic_mesh.hpp"

namespace pcvt::plane {

/// Corners of cells with a smaller angle, degrees, get a guard.
inline constexpr double kSharpCorner = 60;

/// A corner of a face with an angle below kSharpCorner.
struct SharpCorner {
    /// The index of the corner in the given cells.
    int corner;
    /// The angle between the two edges of the face, degrees.
    double angle;
};

/// Cells with guarded sharp corners. Both edges at a sharp corner have a vertex at the same
/// distance from it. The corner and these vertices form the guard, an isosceles triangle that
/// refinement need not split. All edges at a vertex use the same distance, so adjacent guards fit
/// together.
struct GuardedCells {
    /// The cells with the new vertices on their edges.
    PeriodicMesh cells;
    /// The corners at the tips of the guards, and their indices in `cells`.
    std::vector<SharpCorner> sharp;
    std::vector<int> tip;
    /// For each new vertex of `cells`, the vertex at the tip of its guard, or -1 if it belongs to
    /// no guard. Entry 0 belongs to the first vertex after the old ones.
    std::vector<int> tip_of_new;
};

struct GuardOptions {
    /// The upper bound on the length of a guard's sides, length units.
    double longest;
    /// The number of parts of each edge; guards may increase it. 1: edges are not divided.
    int per_edge = 1;
    /// For each vertex of the cells, the factor by which the sides of its guards are scaled; empty:
    /// 1.
    std::vector<double> part = {};
};

/// Adds the vertices of the guards to the edges of the cells.
///
/// Example usage:
///   const GuardedCells guarded = guard_corners(cells, {.longest = 0.05});
///   GrainTriangulation grains(guarded.cells);
GuardedCells guard_corners(const PeriodicMesh& cells, const GuardOptions& options);

}  // namespace pcvt::plane
