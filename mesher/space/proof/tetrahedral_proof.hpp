#pragma once

#include <array>
#include <vector>

#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt::space {

/// Solvers cannot use flatter tetrahedra: parts of the smaller of V / n, the mean volume of a cell,
/// and of the cube over the longest edge. Sites of exact lattices that doubles do not represent may
/// have tetrahedra as flat as the rounding.
inline constexpr double kFlatTetrahedron = 1e-9;

/// Two triangles of the boundary, counter-clockwise seen from outside. Point k of the second is
/// point k of the first plus the translation by `offset`, so it is traversed backwards.
struct TrianglePair {
    std::array<int, 3> first;
    std::array<int, 3> second;
    Offset offset;
};

/// The figures that prove_tetrahedra() derives.
struct TetrahedralProof {
    int n_sites = 0;
    int n_edges = 0;      ///< after gluing
    int n_triangles = 0;  ///< after gluing
    /// The pairs of boundary triangles, each once, from the side with the positive offset.
    std::vector<TrianglePair> pairs = {};
    double volume = 0;           ///< length^3
    double smallest_volume = 0;  ///< of a tetrahedron, length^3
    double tolerance = 0;        ///< of positions, length units
    double mismatch = 0;         ///< the largest one of a point and its image, in one coordinate
};

/// The volume of a tetrahedron, length^3; negative where it is turned over.
double tetrahedron_volume(const TetrahedralMesh& mesh, int t);

/// Returns the tetrahedra that are too flat for law (1), or that rounding has turned over, of the
/// Delaunay tetrahedra of `n_sites` sites.
std::vector<int> flat_tetrahedra(const TetrahedralMesh& mesh, int n_sites);

/// Returns the number of points, but for one of each site, that are corners of no second triangle
/// of a pair. Programs that give each node of a second triangle one master, and no other node, find
/// as many nodes too many.
int n_untied_points(const TetrahedralMesh& mesh, const TetrahedralProof& proof);

/// Proves the laws of a tile of tetrahedra from positions, tetrahedra, sites and period vectors.
///
/// Example usage:
///   const TetrahedralProof proof = prove_tetrahedra(mesh);
///   for (const TrianglePair& pair : proof.pairs) glue(pair.first, pair.second);
///
/// @param least_tolerance  of positions, length units: of files of other programs.
/// @throws NotATile  naming the law and the place; as SeamMismatch where a wider tolerance may
/// help.
TetrahedralProof prove_tetrahedra(const TetrahedralMesh& mesh, double least_tolerance = 0);

/// Names the first of these tetrahedra by its sites, for messages.
std::string flat_in_words(const TetrahedralMesh& mesh, const std::vector<int>& flat);

}  // namespace pcvt::space
