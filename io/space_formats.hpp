#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/space/space_tile.hpp"
#include "io/surfaces/surface_list.hpp"
#include "io/tiles/encoded_file.hpp"
#include "mesher/polyhedra/cell_sites.hpp"
#include "mesher/polyhedra/polyhedral_proof.hpp"
#include "mesher/surfaces/surface_proof.hpp"
#include "mesher/tetrahedra/tetrahedral_proof.hpp"

namespace pcvt {

/// What a file of a tile in space holds: its cells, its Delaunay tetrahedra, its boundary, or the
/// triangles of either of the first and the last in single precision.
enum class SpaceFileKind { kPolyhedra, kTetrahedra, kBoundary, kTriangles };

/// Whether a format holds surfaces: none, those of the cells or the boundary as
/// SpaceFileOptions::surfaces chooses, or always the boundary.
enum class FormatSurfaces { kNone, kChosen, kBoundary };

/// The forms of files that a user chooses.
struct SpaceFileOptions {
    SurfaceForm surfaces = SurfaceForm::kCells;
};

/// A format that holds volumes, their surfaces, or their sites.
struct SpaceFormat {
    std::string_view extension;
    /// Whether the output is a folder.
    bool is_folder;
    FormatSurfaces surfaces;
    /// The memory of a run that writes one such file, bytes a site. Measured at 2e4 to 5e5 random
    /// sites, whose cells have the most faces: the largest of several runs, because the peak of
    /// equal runs with two threads differs by a sixth.
    double memory;
    /// The files of the output with this path, which encode() returns in this order.
    std::vector<std::string> (*paths)(const std::string& path);
    /// Encodes a tile of polyhedra, or of tetrahedra; both null: the file holds the sites alone.
    std::vector<EncodedFile> (*encode)(const SpaceTile& tile, const SpaceFileOptions& options,
                                       const std::string& path);
    std::vector<EncodedFile> (*encode_tetrahedra)(const TetrahedralMesh& mesh,
                                                  const std::string& path);
    /// Returns what files of this extension hold, as `pcvt check` reads them; nothing if they hold
    /// no tile in space. Null for pictures and sites.
    std::optional<SpaceFileKind> (*kind)(const std::vector<EncodedFile>& files);

    /// Whether its files are written and never read back.
    bool is_picture() const { return encode != nullptr && kind == nullptr; }
    bool shows_boundary(const SpaceFileOptions& options) const {
        return surfaces == FormatSurfaces::kBoundary ||
               (surfaces == FormatSurfaces::kChosen && options.surfaces == SurfaceForm::kBoundary);
    }
};

/// Returns the format of a path by its extension, in any case; null if none holds volumes.
const SpaceFormat* find_space_format(const std::string& path);

/// Returns ".vtu, .foam, .msh, ... or .txt".
std::string space_extensions();
/// Returns those whose form SpaceFileOptions::surfaces chooses, ".obj, .ply or .glb".
std::string surface_extensions();

/// Returns what these files, as `pcvt check` reads them, hold; nothing if it is no tile in space.
std::optional<SpaceFileKind> space_file_kind(const std::vector<EncodedFile>& files);

/// The figures that the proof of a file finds.
struct SpaceFileProof {
    SpaceTile tile;
    PolyhedralProof proof;
    /// Of files that state sites.
    std::optional<CellSiteFigures> sites;
};

/// Proves all that the files state: the laws of PolyhedralMesh, the pairs of the seam, the
/// volumes, that the cells are the Voronoi cells of the sites, the files of a case beside its mesh,
/// and the names and colours of surfaces.
///
/// Example usage:
///     const SpaceFileProof proof = prove_space_files(encode_space_vtu(tile, "tile.vtu"));
///
/// @pre space_file_kind(files) is kPolyhedra.
/// @throws BadFile, NotATile as the readers and the proofs do.
SpaceFileProof prove_space_files(const std::vector<EncodedFile>& files);

/// The boundary of a tile in a file, and the figures that its proof finds.
struct BoundaryFileProof {
    TileSurface surface;
    SurfaceProof proof;
};

/// Proves all that files of the boundary state: the laws of TileSurface, and the names and colours.
/// @pre space_file_kind(files) is kBoundary.
/// @throws BadFile, NotATile as the readers and the proof do.
BoundaryFileProof prove_boundary_files(const std::vector<EncodedFile>& files);

/// Proves a file, of any of these kinds, that pcvt is about to write, which must hold `tile` as
/// well.
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_own_space_files(const std::vector<EncodedFile>& files, const SpaceTile& tile);

/// The tetrahedra of a file, and the figures that their proof finds.
struct TetrahedralFileProof {
    TetrahedralMesh mesh;
    TetrahedralProof proof;
};

/// Proves all that an MSH file states: the laws of TetrahedralMesh, the groups and the links of the
/// seam.
/// @pre space_file_kind({msh}) is kTetrahedra.
/// @throws BadFile, NotATile as the reader and the proof do.
TetrahedralFileProof prove_tetrahedral_file(const EncodedFile& msh);

/// The same for a file that pcvt is about to write, which must hold `mesh` as well.
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_own_tetrahedra(const EncodedFile& msh, const TetrahedralMesh& mesh);

/// Proves that a .txt file holds exactly these sites.
/// @throws InternalError  another site is read: a fault of pcvt.
void prove_space_site_file(const EncodedFile& file, const Points3& sites);

}  // namespace pcvt
