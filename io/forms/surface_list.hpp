#pragma once

#include <string>

#include "io/bytes/text.hpp"
#include "io/colours/colouring.hpp"
#include "io/forms/file_options.hpp"
#include "io/forms/note_table.hpp"
#include "io/forms/space_tile.hpp"
#include "mesher/space/tile/tile_surface.hpp"

namespace pcvt {

/// Surfaces in space as files list them. Those of cells have no pairs; their faces follow cell
/// after cell, and `cell` is that of each face.
struct SurfaceList {
    SurfaceForm form = SurfaceForm::kCells;
    space::TileSurface surface = {.lattice = space::Lattice::box(1, 1, 1)};
    /// The weights of the sites, length^2; empty for Voronoi cells.
    Eigen::VectorXd weights = {};
    CellMaterials materials = {};
    /// What the colours of the cells show; a boundary has those of its seam.
    Colouring colouring = Colouring::kFaces;
    /// For Colouring::kCells, of each cell the number of its colour.
    std::vector<int> cell_class = {};
};

/// The colouring of the cells of a tile where the user leaves the choice: the phases, or the
/// orientations, if there are some, else the numbers of faces.
Colouring default_colouring(const CellMaterials& materials);

/// Returns of each cell the number of a colour that its neighbours do not have, inside the tile and
/// across its seam, where kCellColours suffice.
std::vector<int> cells_apart(const space::PolyhedralMesh& mesh);

/// Returns a list with the weights and the materials of its tile, and with the colours of its
/// cells.
SurfaceList with_materials(SurfaceList list, const SpaceTile& tile, Colouring colouring);

/// Returns the surfaces of the cells of a tile, or of its boundary.
///
/// Example usage:
///     const SurfaceList list = surface_list(tile.mesh, tile.sites, SurfaceForm::kCells);
///     const space::PolyhedralMesh same = assembled_cells(list, "tile.obj");
SurfaceList surface_list(const space::PolyhedralMesh& mesh, const space::Points& sites,
                         SurfaceForm form);

/// Requires that a list that was read from a file has the materials that its colours show.
/// @throws BadFile naming the file.
void require_shown_materials(const SurfaceList& list, const std::string& path);

/// Collects the surfaces that the comments of a file state beside its points and faces.
///
/// Example usage:
///     SurfaceListBuilder builder;
///     if (!builder.take_comment(scanner, "kind", words)) scanner.throw_bad_file("...");
///     return builder.finish(path);
class SurfaceListBuilder {
   public:
    /// Reads the words after the key of the comments `kind polyhedra|boundary`, `lattice`, `site`,
    /// `cells`, `face_pair`, `weights`, `colouring` and those of materials; faces are counted from
    /// 1.
    /// @returns whether the key is one of these.
    /// @throws BadFile with the line.
    bool take_comment(const LineScanner& scanner, std::string_view key,
                      std::span<const std::string_view> words);

    /// Adds the statements of the comments to the surfaces, whose points and faces the reader has
    /// added.
    /// @throws BadFile  naming the file: the lattice is missing, or a pair names a missing face.
    SurfaceList finish(const std::string& path) &&;

    SurfaceList list = {};

   private:
    void link_pairs(const std::string& path);

    bool has_lattice_ = false;
    /// The notes `lattice`, `site`, `cells`, `face_pair` and `weights`.
    std::array<NoteTable, 5> notes_{
        NoteTable{.word = "lattice", .width = 9, .numbers = std::vector<double>()},
        NoteTable{.word = "site", .width = 3, .numbers = std::vector<double>()},
        NoteTable{.word = "cells"}, NoteTable{.word = "face_pair", .width = 5, .n_indices = 2},
        NoteTable{.word = "weights", .numbers = std::vector<double>()}};
};

/// Requires that an offset that a file states is not too large to add.
/// @throws BadFile naming the file.
space::Offset stated_offset(int i, int j, int k, const std::string& path);

/// Requires the faces of a list that was read from a file to have corners, and these to be points.
/// @throws BadFile naming the file.
void require_faces(const SurfaceList& list, const std::string& path);

/// Makes the tile of a list of cells that was read from a file.
/// @throws BadFile   naming the file: as require_faces(), the faces of a cell do not follow each
///                   other, or there is not one site a cell.
/// @throws NotATile  as assembled_mesh().
space::PolyhedralMesh assembled_cells(SurfaceList list, const std::string& path);

/// Whether a file says in a comment at its head that it holds surfaces in space.
bool states_surfaces(std::string_view bytes);

}  // namespace pcvt
