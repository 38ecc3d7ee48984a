#pragma once

#include <string>
#include <vector>

#include "io/colours/colouring.hpp"
#include "io/surfaces/surface_list.hpp"

namespace pcvt {

/// Consecutive faces of one colour with a name of their own: a cell, or a side of the seam.
struct SurfacePart {
    /// "cell_12", or "seam_1_0_0".
    std::string name;
    int first_face = 0;
    int n_faces = 0;
    /// The index of its class of colour.
    int colour = 0;
};

/// The parts of surfaces, and their colours: of cells the number of faces, of a boundary the
/// translation to the other side.
struct SurfaceParts {
    std::vector<SurfacePart> parts;
    std::vector<ColourClass> classes;
};

/// Divides surfaces into parts.
///
/// Example usage:
///     for (const SurfacePart& part : surface_parts(list).parts) std::puts(part.name.c_str());
SurfaceParts surface_parts(const SurfaceList& list);

}  // namespace pcvt
