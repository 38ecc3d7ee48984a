#pragma once

#include <vector>

#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// Positions of partners may differ by this many double ulps of the largest coordinate.
inline constexpr double kPositionUlps = 4;

/// Two boundary faces, the second of which is the first plus a translation, traversed backwards.
struct FacePair {
    int first;
    int second;
    Offset offset;
    /// Corner k of the first face answers corner (start - k) modulo their number of the second.
    int start;
};

/// Finds the pairs of boundary faces from only positions and period vectors, sorted by first faces;
/// each pair occurs once, from the side with the positive offset.
///
/// Example usage:
///     for (const FacePair& pair : seam_pairs(mesh, 1e-15)) glue(pair.first, pair.second);
///
/// @param tolerance  of positions, length units.
/// @throws NotATile for a boundary face that has no partner, or more than one.
std::vector<FacePair> seam_pairs(const PolyhedralMesh& mesh, double tolerance);

}  // namespace pcvt::space
