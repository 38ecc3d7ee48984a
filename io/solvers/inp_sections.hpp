#pragma once

#include <span>
#include <string>

#include "io/forms/file_options.hpp"
#include "mesher/cells/elastic_choices.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt {

/// Returns the lines with which an input begins: whether it holds only the mesh, sections, or a
/// job.
std::string inp_head(const FileOptions& options);

/// Explains the mean strain of a mesh in space, behind inp_head().
inline constexpr const char* kInpStrainsInSpace =
    " FIXED 1,2,3 holds the tile. The\n** mean strain is the displacement of the control nodes: "
    "CONTROL_1 has e_xx, e_xy, e_xz in\n** 1, 2, 3, CONTROL_2 has e_yy, e_yz in 2, 3, and "
    "CONTROL_3 has e_zz in 3. Lines that begin\n** with \"** pcvt\" hold what no card does.\n";

/// Appends the site of each node as comments; nothing where nodes have none.
void append_inp_sites(std::string& text, std::span<const SiteId> sites);

/// Returns the sets of the cells of each orbit: `*ELSET,ELSET=ORBIT_k` with sets CELL_s.
/// @param site_orbits  of all sites; empty: no sets.
/// @param cells        the sites that have a set CELL_s, rising.
std::string inp_orbit_sets(std::span<const int> site_orbits, std::span<const SiteId> cells);

/// Returns the sections of the cells:
///
///   *ELSET,ELSET=PHASE_name         the sets CELL_s of the cells of one phase
///   *ORIENTATION,NAME=ORI_s         rows 1 and 2 of the Bunge matrix of site s
///   *SOLID SECTION,ELSET=CELL_s,MATERIAL=name,ORIENTATION=ORI_s
///
/// The name of a material is that of the phase, or kOneMaterial. Materials without
/// phases have no sets, and materials without angles no orientations.
///
/// Example usage:
///     text += inp_sections(materials, cells);
///
/// @param cells      the sites that have a set CELL_s, rising.
/// @param dimension  2: elements are 1 thick.
std::string inp_sections(const CellMaterials& materials, std::span<const SiteId> cells,
                         int dimension);

/// The elastic constants of all materials of a job where the user gives none, in MPa:
///
///   without orientations  steel, isotropic: E = 210000, nu = 0.3
///   with orientations     iron, cubic: C11 = 231400, C12 = 134700, C44 = 116400, along the axes of
///                         each crystal
ElasticConstants inp_standard_constants(const CellMaterials& materials);

/// Returns the materials and the steps with which the mesh of a tile becomes a job that CalculiX
/// runs as it is: one *MATERIAL a phase, with the chosen constants or the standard ones.
///
/// Three linear steps prescribe a unit mean strain each, at the control nodes: e_xx = 1, e_yy = 1
/// and e_xy = 1/2, which is the shear gamma_xy = 1; in space six: e_xx, e_yy, e_zz = 1, and e_yz,
/// e_xz, e_xy = 1/2. The mean stress of a step, that is the sum of S
/// x volume over the volume of the period, is a column of the homogenised stiffness. The results
/// are S, E and the volumes of the elements as text (.dat), and U, S and E for pictures (.frd).
///
/// Example usage:
///     text += inp_elastic_job(materials, options.elastic, tile.lattice.area(), 2);
///
/// @param materials  without phases and orientations: a section of all elements is added.
/// @param period     the area or the volume of the period, by which the sum of S x volume is
///                   divided, also where the elements leave holes; a comment states it.
std::string inp_elastic_job(const CellMaterials& materials, const ElasticChoices& choices,
                            double period, int dimension);

}  // namespace pcvt
