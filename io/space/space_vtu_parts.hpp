#pragma once

#include <string>
#include <vector>

#include "io/solvers/vtu_arrays.hpp"
#include "mesher/space/geometry/lattice.hpp"

namespace pcvt {

// The parts that VTUs of polyhedra and of tetrahedra share:
//
//     open_space_vtu(text, kSpaceVtuMark, lattice, n_points, n_cells);
//     append_images(text, mesh.point_orbit, mesh.point_offset);
//     append_space_points(text, mesh.points);
//     text += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

/// Appends all that comes before the first array of the piece.
/// @param mark         a comment.
/// @param short_edges  as PolyhedralMesh::short_edges.
void open_space_vtu(std::string& text, std::string_view mark, const space::Lattice& lattice,
                    double short_edges, int n_points, int n_cells);

/// Appends x, y and z as a line of an array.
void append_space_vector(std::string& text, const space::Vec3& vector);

/// Appends the arrays of PointData that name the point of which each point is an image, and the
/// offset from it.
void append_images(std::string& text, const std::vector<int>& orbits,
                   const std::vector<space::Offset>& offsets);

/// Appends the section of the points, length units.
void append_space_points(std::string& text, const std::vector<space::Vec3>& points);

/// Returns the lattice of a file.
/// @throws BadFile  there are not three independent vectors.
space::Lattice read_space_lattice(const std::string& name, const VtuArrays& arrays);

/// Returns PolyhedralMesh::short_edges, which a file without removed edges does not state.
/// @throws BadFile  it is not from 0 to space::kLongestShortEdge.
double read_short_edges(const std::string& name, const VtuArrays& arrays);

/// Returns the points of a file.
/// @throws BadFile  there are none in double precision.
std::vector<space::Vec3> read_space_points(const std::string& name, const VtuArrays& arrays);

/// Returns the largest distance of a point from the image that the file states for it, in one
/// coordinate, length units; 0 if it states none.
/// @throws BadFile  the images are not one for each point.
double stated_mismatch(const VtuArrays& arrays, const space::Lattice& lattice,
                       const std::vector<space::Vec3>& points);

/// Compares the images that a file states, if it does, with those of its points.
/// @throws BadFile  naming the point.
void compare_images(const std::string& name, const VtuArrays& arrays,
                    const std::vector<int>& orbits, const std::vector<space::Offset>& offsets);

}  // namespace pcvt
