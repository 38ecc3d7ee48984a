#pragma once

#include <optional>
#include <vector>

#include "io/formats/formats.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "mesher/space/proof/surface_proof.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"

namespace pcvt {

/// The figures that the proof of a file finds.
struct SpaceFileProof {
    SpaceTile tile;
    space::PolyhedralProof proof;
    /// The figures of the sites, if the files state them.
    std::optional<space::CellSiteFigures> sites;
};

/// Proves all that the files state: the laws of PolyhedralMesh, the pairs of the seam, the
/// volumes, that the cells are the Voronoi cells of the sites, the files of a case beside its mesh,
/// and the names and colours of surfaces.
///
/// Example usage:
///     const SpaceFileProof proof = prove_space_files(encode_vtu(vtu_grid(tile), "tile.vtu"));
///
/// @pre space_file_kind(files) is kPolyhedra.
/// @param tolerance  least_tolerance of prove_polyhedra().
/// @throws BadFile, NotATile as the readers and the proofs do.
SpaceFileProof prove_space_files(const std::vector<EncodedFile>& files, double tolerance = 0);

/// The boundary of a tile in a file, and the figures that its proof finds.
struct BoundaryFileProof {
    space::TileSurface surface;
    /// Of the cells behind the boundary, where the file states some.
    CellMaterials materials = {};
    space::SurfaceProof proof;
};

/// Proves all that files of the boundary state: the laws of TileSurface, and the names and colours.
/// @pre space_file_kind(files) is kBoundary.
/// @throws BadFile, NotATile as the readers and the proof do.
BoundaryFileProof prove_boundary_files(const std::vector<EncodedFile>& files);

/// Proves a file, of any of these kinds or of closed surfaces, that pcvt is about to write, which
/// must hold `tile` as well.
/// @throws CoarsePrecision  the tile is too fine for the single precision of the format.
/// @throws InternalError    a law is violated: a fault of pcvt.
void prove_own_space_files(const std::vector<EncodedFile>& files, const SpaceTile& tile);

/// The tetrahedra of a file, and the figures that their proof finds.
struct TetrahedralFileProof {
    TetrahedralTile tile;
    space::TetrahedralProof proof;
};

/// Proves all that files of tetrahedra state: the laws of TetrahedralMesh, the nodes in the
/// middle of edges, groups, sets, links and equations, the images of points.
/// @pre space_file_kind(files) is kTetrahedra.
/// @param tolerance  least_tolerance of prove_tetrahedra().
/// @throws BadFile, NotATile as the reader and the proof do.
TetrahedralFileProof prove_tetrahedral_files(const std::vector<EncodedFile>& files,
                                             double tolerance = 0);

/// The same for files that pcvt is about to write, which must hold `mesh` as well, and the
/// materials, as far as their format states them.
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_own_tetrahedra(const std::vector<EncodedFile>& files, const space::TetrahedralMesh& mesh,
                          const CellMaterials* materials = nullptr);

/// Proves that a .txt file holds exactly these sites.
/// @throws InternalError  another site is read: a fault of pcvt.
void prove_space_site_file(const EncodedFile& file, const space::Points& sites);

}  // namespace pcvt
