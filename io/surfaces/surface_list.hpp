#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "io/space/space_tile.hpp"
#include "mesher/space/tile/tile_surface.hpp"

namespace pcvt {

/// What a file of surfaces shows: every cell of a tile, or the boundary of the tile.
enum class SurfaceForm { kCells, kBoundary };

struct SurfaceFormRow {
    SurfaceForm form;
    const char* word;
    int abi_value;
};
inline constexpr std::array kSurfaceForms{SurfaceFormRow{SurfaceForm::kCells, "cells", 0},
                                          SurfaceFormRow{SurfaceForm::kBoundary, "boundary", 1}};

/// Surfaces as files list them.
struct SurfaceList {
    SurfaceForm form = SurfaceForm::kCells;
    space::Lattice lattice = space::Lattice::box(1, 1, 1);
    std::vector<space::Vec3> points = {};
    /// Counter-clockwise seen from outside; of cells, cell after cell.
    Faces faces = {};
    /// The cell of each face, or behind it.
    std::vector<SiteId> cell = {};
    /// 3 x n, the site of each cell of the tile.
    space::Points sites = space::Points(3, 0);
    /// Of a boundary, as in TileSurface.
    std::vector<int> partner = {};
    std::vector<space::Offset> offset = {};
};

/// Returns the surfaces of the cells of a tile, or of its boundary.
///
/// Example usage:
///     const SurfaceList list = surface_list(tile, SurfaceForm::kCells);
///     const SpaceTile same = std::get<SpaceTile>(surface_content(list, "tile.obj"));
SurfaceList surface_list(const SpaceTile& tile, SurfaceForm form);
SurfaceList surface_list(const space::TileSurface& surface);

/// What a list holds: the cells of a tile, or a boundary.
using SurfaceContent = std::variant<SpaceTile, space::TileSurface>;

/// Makes the tile or the boundary of a list that was read from a file.
/// @throws BadFile   naming the file: an index refers to nothing, or the faces of a cell do not
///                   follow each other.
/// @throws NotATile  as assembled_mesh().
SurfaceContent surface_content(SurfaceList list, const std::string& path);

}  // namespace pcvt
