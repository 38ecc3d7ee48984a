#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/formats/formats.hpp"
#include "plugin/checks/check_proof.hpp"

namespace pcvt::checks {

/// Returns what files of this kind hold, "a periodic tile of polyhedra".
std::string space_content_text(SpaceFileKind kind);

/// Proves the files of a tile of polyhedra: the laws of PolyhedralMesh, the pairs of the seam, and
/// that the cells are the Voronoi cells of the sites; or those of a tile of tetrahedra: the laws of
/// TetrahedralMesh, and all groups and links of the file; or those of the boundary of a tile; or
/// triangles in single precision, which close.
///
/// Example usage:
///     if (space_file_kind(files)) return prove_space_tile("tile.vtu", files, {});
///
/// @param question  the volumes of the cells; cvt_tolerance, in units of h = (volume / n)^(1/3);
///                  tolerance, 0: 4 ulps of the largest coordinate. Its other members are not used.
/// @returns a line that states the proved properties.
/// @pre space_file_kind(files) is not empty.
/// @throws NotATile      where the files are refuted.
/// @throws UnusableFile  where they cannot have the property; BadFile where they are wrong.
std::string prove_space_tile(const std::string& path, const std::vector<EncodedFile>& files,
                             const Question& question);

}  // namespace pcvt::checks
