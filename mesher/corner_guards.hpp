#pragma once

#include "mesher/periodic_mesh.hpp"

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
};

/// @param size  length units; no side of a guard is longer.
GuardedCells guard_corners(const PeriodicMesh& cells, double size);

}  // namespace pcvt
