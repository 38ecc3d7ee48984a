#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/space/space_tile.hpp"
#include "io/tiles/encoded_file.hpp"
#include "mesher/polyhedra/cell_sites.hpp"
#include "mesher/polyhedra/polyhedral_proof.hpp"

namespace pcvt {

/// A format that holds volumes, or their sites.
struct SpaceFormat {
    std::string_view extension;
    /// Whether the output is a folder.
    bool is_folder;
    /// The files of the output with this path, which encode() returns in this order.
    std::vector<std::string> (*paths)(const std::string& path);
    /// Encodes a tile; null: the file holds the sites alone.
    std::vector<EncodedFile> (*encode)(const SpaceTile& tile, const std::string& path);
};

/// Returns the format of a path by its extension, in any case; null if none holds volumes.
const SpaceFormat* find_space_format(const std::string& path);

/// Returns ".vtu, .foam or .txt".
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

/// Proves that a .txt file holds exactly these sites.
/// @throws InternalError  another site is read: a fault of pcvt.
void prove_space_site_file(const EncodedFile& file, const Points3& sites);

}  // namespace pcvt
