#pragma once

#include "mesher/corner_guards.hpp"
#include "mesher/periodic_mesh.hpp"

namespace pcvt {

/// Angles of grains are larger than this, degrees, but for the corners that are named.
inline constexpr double kSmallestAngle = 20;

/// Edges shorter than this, in units of h = sqrt(area / number of cells), are removed before cells
/// are meshed (short_edges.hpp).
inline constexpr double kShortGrainEdge = 0.02;

/// Cells meshed by triangles.
struct Grains {
    /// One face a triangle (`kGrains`), with the site of its cell.
    PeriodicMesh triangles;
    /// For each triangle the face of the cells in whose frame it stands.
    std::vector<int> cell;
    /// Corners of the cells that are so sharp that a triangle there has an angle of kSmallestAngle
    /// or less; of their number among the corners of the cells, and their angle.
    std::vector<SharpCorner> sharp;
    /// Degrees, away from these corners.
    double smallest_angle;
};

/// Meshes each cell, or each piece of one, by triangles with edges about `size` long.
///
/// Laws, tested by number:
///   (1) The triangles are a mesh of the same torus: V - E + F = 0, and those of a cell cover it.
///   (2) Neighbouring cells share the vertices on their edge; on a seam they are one orbit.
///   (3) All angles are larger than kSmallestAngle, but for the corners in `sharp`.
/// Cost: O(n log n) in the number of triangles.
///
/// @param cells  of what is still to be laid out: the placement of a triangle is that of its cell.
/// @param size   length units, above 0.
Grains mesh_grains(const PeriodicMesh& cells, double size);

}  // namespace pcvt
