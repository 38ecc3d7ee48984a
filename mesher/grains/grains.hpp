#pragma once

#include "mesher/lattice/triangle_shape.hpp"
#include "mesher/mesh/periodic_mesh.hpp"

namespace pcvt {

/// Edges shorter than this, in units of h = sqrt(area / number of cells), are removed before cells
/// are meshed (short_edges.hpp).
inline constexpr double kShortGrainEdge = 0.02;
/// Vertices nearer to the box than this, in units of h, are moved onto it before the pieces are
/// meshed (box_outline.hpp), so that fewer pieces are slivers.
inline constexpr double kGrainSnap = 0.01;

/// A corner of a cell, or of a piece of one, where an angle of kSmallestAngle or less cannot be
/// helped: one that is as sharp itself, or one of up to 60 degrees at the vertex of a corner under
/// 7 degrees.
struct NamedCorner {
    /// Index of the corner in the cells.
    int corner;
    /// Degrees.
    double angle;
};

/// Cells meshed by triangles.
struct Grains {
    /// One face a triangle (`kGrains`), with the site of its cell.
    PeriodicMesh triangles;
    /// For each triangle the face of the cells in whose frame it stands.
    std::vector<int> cell;
    std::vector<NamedCorner> named_corners;
    /// Of all angles but those in the named corners, degrees.
    double smallest_angle;
};

/// Meshes each cell, or each piece of one, by triangles with edges about `size` long.
///
/// Sharp corners get a guard (corner_guards.hpp), Ruppert's refinement does the rest
/// (grain_refinement.hpp), and vertices inside of cells move where that helps. Laws, tested by
/// number:
///   (1) The triangles are a mesh of the same torus: V - E + F = 0, and those of a cell cover it.
///   (2) Neighbouring cells share the vertices on their edge; on a seam they are one orbit.
///   (3) All angles but those in the named corners are above kSmallestAngle. (No proof is known;
///       thousands of hard random cells were tried, and smallest_angle tells.)
/// Cost: O(n log n) in the number of triangles.
///
/// @param cells  simple polygons. The placement of a triangle in a tile is that of its cell.
/// @param size   length units, above 0.
/// @throws LimitExceeded if a cell is thousands of times longer than wide.
Grains mesh_grains(const PeriodicMesh& cells, double size);

/// The same with each edge of the cells cut into `parts` parts, and into more where good angles or
/// the guards of sharp corners need that; triangles inside of a cell are as large as the parts of
/// its edges on average.
/// @param parts  above 0.
Grains mesh_grains_per_edge(const PeriodicMesh& cells, int parts);

}  // namespace pcvt
