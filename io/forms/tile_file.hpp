#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "mesher/cells/cell_materials.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Offsets beyond this are refused, so that sums of offsets stay integers.
inline constexpr int kLargestOffset = 1 << 28;

/// The most columns, and the most rows, of periods that a tile may have.
inline constexpr int kMostPeriods = 10000;
/// The largest Tile::short_edges that a file may state.
inline constexpr double kLongestRemovedEdge = 1;

/// A tile as read from a file, before any of it is believed.
struct TileFile {
    plane::Tile tile;
    plane::Precision precision;
    /// False where the file carries no pairing; tile.vertex_pairs and edge_pairs are empty then.
    bool has_vertex_pairs;
    bool has_edge_pairs;
    /// The file names the edges on walls; else tile.wall_edges follow from the positions.
    bool has_wall_edges = false;
    /// The file states its lattice, as pcvt writes it; then all of its fields follow from the tile.
    bool states_lattice = false;
    /// The materials of the sites of one period; empty where the file states none.
    CellMaterials materials = {};
    /// The phases that the names of materials show, of a file that states none; may be empty.
    CellMaterials shown = {};
    /// The orbit of each site of one period under the symmetry of the run, -1 for a site that has
    /// no element; empty where the file states none.
    std::vector<int> site_orbits = {};
    /// The height of the prisms in a file of prisms, length units; else 0.
    double thickness = 0;
    /// The origin to which the positions of the tile are relative, length units; not 0 only for
    /// distant tiles.
    plane::Vec2 translation = plane::Vec2::Zero();
    /// As the user stated it, least_tolerance of prove_tile().
    double tolerance = 0;
};

}  // namespace pcvt
