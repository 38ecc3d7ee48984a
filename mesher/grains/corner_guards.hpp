#pragma once

#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// Corners of cells sharper than this, degrees, get a guard.
inline constexpr double kSharpCorner = 60;

/// A corner of a face, sharper than kSharpCorner.
struct SharpCorner {
    /// Its index in the cells that were given.
    int corner;
    /// Degrees, between the two edges of the face.
    double angle;
};

/// Cells whose sharp corners are guarded: both edges at such a corner have a vertex at one distance
/// from it, so that corner and vertices make a triangle with two equal sides which no refinement
/// needs to split. Edges at one vertex share the distance, so that guards side by side fit.
struct GuardedCells {
    /// The cells with the new vertices on their edges.
    PeriodicMesh cells;
    /// The corners in the tips of the guards, and their indices in `cells`.
    std::vector<SharpCorner> sharp;
    std::vector<int> tip;
    /// For each vertex of a guard, or between guards, the vertex in the guard's tip, else -1; the
    /// old vertices, which come first, are left out.
    std::vector<int> tip_of_new;
};

struct GuardOptions {
    /// Length units; no side of a guard is longer.
    double longest;
    /// Each edge is cut into so many parts, or more where guards take some; 1: not at all.
    int per_edge = 1;
    /// For each vertex of the cells the part of their usual length that its guards' sides have;
    /// empty: 1.
    std::vector<double> part = {};
};

GuardedCells guard_corners(const PeriodicMesh& cells, const GuardOptions& options);

}  // namespace pcvt
