#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/openfoam/foam_case.hpp"
#include "mesher/cells/cell_materials.hpp"
#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt {

/// The numbers in the comments of a case in space, in the order of the file.
struct FoamSpaceNotes {
    /// Nine for each lattice that is stated.
    std::vector<double> lattice = {};
    std::vector<double> short_edges = {};
    /// Three a site.
    std::vector<double> sites = {};
    std::vector<double> weights = {};
    /// The number of tetrahedra in each cell.
    std::vector<int> tetrahedra = {};
    CellMaterials materials = {};
};

/// Returns the first comments of a boundary file in space: its kind and its lattice.
std::string foam_space_notes(std::string_view kind, const space::Lattice& lattice);

/// Whether the files of a case state this kind.
bool is_foam_of(std::string_view kind, const std::vector<EncodedFile>& files);

/// Reads the comments of a boundary file.
///
/// Example usage:
///     const FoamSpaceNotes notes = read_foam_space_notes(boundary);
///     const space::Lattice lattice = foam_lattice(notes, boundary.path);
///
/// @throws BadFile  with the line.
FoamSpaceNotes read_foam_space_notes(const EncodedFile& boundary);

/// Returns the lattice.
/// @throws BadFile  naming the file: it states none, or two.
space::Lattice foam_lattice(const FoamSpaceNotes& notes, const std::string& path);

/// Reads the cells of a case. The orbits of the points follow from the pairs of boundary faces,
/// names and separations of the patches from their offsets.
/// @param tolerance  within which partners on the seam agree at least, length units.
/// @throws BadFile, NotATile  as decode_foam_polyhedra().
space::PolyhedralMesh foam_cells(const std::vector<EncodedFile>& files,
                                 const space::Lattice& lattice, double tolerance);

/// Returns the zones phase_NAME.
/// @param phase_of_cell  the index of the name of each cell; empty without phases.
std::vector<FoamZone> phase_zones(const std::vector<std::string>& names,
                                  const std::vector<int>& phase_of_cell);

}  // namespace pcvt
