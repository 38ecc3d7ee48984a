#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/space/space_tile.hpp"
#include "io/tiles/encoded_file.hpp"
#include "mesher/polyhedra/cell_sites.hpp"
#include "mesher/polyhedra/polyhedral_proof.hpp"
#include "mesher/tetrahedra/tetrahedral_proof.hpp"

namespace pcvt {

/// A format that holds volumes, or their sites.
struct SpaceFormat {
    std::string_view extension;
    /// Whether the output is a folder.
    bool is_folder;
    /// The files of the output with this path, which encode() returns in this order.
    std::vector<std::string> (*paths)(const std::string& path);
    /// Encodes a tile of polyhedra, or of tetrahedra; both null: the file holds the sites alone.
    std::vector<EncodedFile> (*encode)(const SpaceTile& tile, const std::string& path);
    std::vector<EncodedFile> (*encode_tetrahedra)(const TetrahedralMesh& mesh,
                                                  const std::string& path) = nullptr;
};

/// Returns the format of a path by its extension, in any case; null if none holds volumes.
const SpaceFormat* find_space_format(const std::string& path);

/// Returns ".vtu, .foam, .msh or .txt".
std::string space_extensions();

/// Returns whether these files, as `pcvt check` reads them, hold a tile of polyhedra.
bool hold_space_tile(const std::vector<EncodedFile>& files);

/// The figures that the proof of a file finds.
struct SpaceFileProof {
    SpaceTile tile;
    PolyhedralProof proof;
    /// Of files that state sites.
    std::optional<CellSiteFigures> sites;
};

/// Proves all that the files state: the laws of PolyhedralMesh, the pairs of the seam, the
/// volumes, that the cells are the Voronoi cells of the sites, and the files of a case beside its
/// mesh.
///
/// Example usage:
///     const SpaceFileProof proof = prove_space_files(encode_space_vtu(tile, "tile.vtu"));
///
/// @pre hold_space_tile(files).
/// @throws BadFile, NotATile as the readers and the proofs do.
SpaceFileProof prove_space_files(const std::vector<EncodedFile>& files);

/// The same for files that pcvt is about to write, which must hold `tile` as well.
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_own_space_files(const std::vector<EncodedFile>& files, const SpaceTile& tile);

/// Returns whether these files, as `pcvt check` reads them, hold a tile of tetrahedra.
bool hold_tetrahedra(const std::vector<EncodedFile>& files);

/// The tetrahedra of a file, and the figures that their proof finds.
struct TetrahedralFileProof {
    TetrahedralMesh mesh;
    TetrahedralProof proof;
};

/// Proves all that an MSH file states: the laws of TetrahedralMesh, the groups and the links of the
/// seam.
/// @pre hold_tetrahedra({msh}).
/// @throws BadFile, NotATile as the reader and the proof do.
TetrahedralFileProof prove_tetrahedral_file(const EncodedFile& msh);

/// The same for a file that pcvt is about to write, which must hold `mesh` as well.
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_own_tetrahedra(const EncodedFile& msh, const TetrahedralMesh& mesh);

/// Proves that a .txt file holds exactly these sites.
/// @throws InternalError  another site is read: a fault of pcvt.
void prove_space_site_file(const EncodedFile& file, const Points3& sites);

}  // namespace pcvt
