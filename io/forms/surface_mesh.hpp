#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "io/colours/colouring.hpp"
#include "io/forms/note_table.hpp"
#include "mesher/base/faces.hpp"
#include "mesher/plane/tile/texture_coordinates.hpp"

namespace pcvt {

/// Consecutive faces with a name of their own: a cell, or a side of the seam.
struct FaceGroup {
    /// "cell_12", or "seam_1_0_0".
    std::string name;
    /// The group ends where the next one begins.
    int first_face;
};

/// How a file states a seam: in lines of pairs, as OBJ does; in columns of its vertices or its
/// faces, as PLY does; or not at all.
enum class SeamForm { kLines, kColumns, kNone };

/// Polygons with their colours and notes, as files for graphics programs hold them: a tile of the
/// plane, the cells of a tile in space, or its boundary.
///
/// Example usage:
///     SurfaceMesh mesh = surface_mesh(surface_list(tile.mesh, tile.sites, SurfaceForm::kCells),
///                                     SeamForm::kLines);
///     const std::vector<EncodedFile> files = encode_obj_mesh(mesh, "tile.obj");
struct SurfaceMesh {
    /// Lines that explain the file and its notes to a reader, without the marks of comments.
    std::string explanation = {};
    /// "cells", "polyhedra", ...
    std::string kind = {};
    /// Length units; z = 0 in the plane.
    std::vector<Eigen::Vector3d> points = {};
    /// On these points; counter-clockwise seen from above, or from outside.
    Faces faces = {};
    /// One a point, or none.
    std::vector<plane::TextureCoordinate> texture = {};
    /// The colours; of each face and of each point the index of its colour, or none.
    std::vector<ColourClass> classes = {};
    std::vector<int> face_class = {};
    std::vector<int> vertex_class = {};
    /// Groups of all faces, in their order, or none.
    std::vector<FaceGroup> groups = {};
    /// In the order of files, the lattice first.
    std::vector<NoteTable> notes = {};
    /// Lines of words that files state beside the notes, such as the names of phases.
    std::string statements = {};
    /// Whether files state reals as 32-bit floats.
    bool is_single = false;

    /// The face behind the last one of a group.
    int group_end(std::size_t group) const {
        return group + 1 < groups.size() ? groups[group + 1].first_face : faces.n_faces();
    }
};

}  // namespace pcvt
