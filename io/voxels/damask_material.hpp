#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/cells/elastic_choices.hpp"

namespace pcvt {

/// A rotation as a unit quaternion with the real part first.
using Quaternion = std::array<double, 4>;

/// One entry of the list `material`: the cell with its number.
struct DamaskEntry {
    std::string phase;
    Quaternion orientation;
};

/// The name of the phase of cells without phases.
inline constexpr const char* kOnlyPhase = "default";

/// The orientation of a crystal in DAMASK's convention: the quaternion of the passive rotation from
/// the sample to the crystal with P = -1 (D. Rowenhorst et al., Modelling Simul. Mater. Sci. Eng.
/// 23, 2015, 083501, Eq. A.5; DAMASK's `Rotation.from_Euler_angles`):
///
///   c = cos(Phi / 2)    s = sin(Phi / 2)    sigma = (phi1 + phi2) / 2    delta = (phi1 - phi2) / 2
///   q = (c cos sigma, s cos delta, s sin delta, c sin sigma), or -q, with q_0 >= 0
///
/// Law, tested by number:
///   (1) The rotation matrix of q is the transpose of Bunge's matrix, and |q| = 1.
Quaternion damask_quaternion(const BungeAngles& angles);

/// Encodes the configuration of materials of DAMASK 3, which has one entry a cell. pcvt has no
/// material laws: each phase has the chosen elastic constants, or those of aluminium, for the user
/// to replace.
///
/// Example usage:
///     outputs.stage("tile.material.yaml", encode_damask_material(n_cells, materials));
///
/// @param materials  without phases, all cells belong to kOnlyPhase; without orientations, their
///                   axes are those of the sample.
std::string encode_damask_material(int n_cells, const CellMaterials& materials,
                                   const ElasticChoices& choices = {});

/// The entries of a file as encode_damask_material() writes it; users may change its phases.
/// @param name  the file's name in messages.
/// @throws BadFile naming the line if an entry has another form, names a phase or a homogenization
///                 that the file lacks, or its quaternion has not the length 1 within 1e-8, which
///                 DAMASK refuses too.
std::vector<DamaskEntry> decode_damask_material(const std::string& name, std::string_view text);

/// Requires that the entries are those of the cells.
/// @throws BadFile  naming the first cell that differs.
void compare_damask_material(const std::string& name, const std::vector<DamaskEntry>& entries,
                             int n_cells, const CellMaterials& materials);

}  // namespace pcvt
