#pragma once

#include <optional>

#include "io/graphics/stl_file.hpp"

namespace pcvt {

/// Figures that the proof of an STL file finds.
struct StlProof {
    int n_triangles = 0;
    /// The closed surfaces, which follow each other.
    int n_surfaces = 0;
    /// The sum of the volumes inside of the surfaces, and its largest possible error by single
    /// precision.
    double volume = 0;
    double tolerance = 0;
    /// Whether the header states the periods, whose volume it is.
    bool has_periods = false;
    /// Whether law (3) was tested; false where single precision might join two images of corners.
    bool repeats = false;
};

/// Proves what a binary STL holds:
///   (1) The triangles are closed surfaces, one after the other: each directed edge of a surface
///       occurs as often as its reverse.
///   (2) Each triangle has an area, and each surface encloses a positive volume. The volumes sum to
///       that of the period vectors, where the header states them.
///   (3) Where the header states period vectors, translations by them map each triangle to another
///       one of the opposite orientation, or it occurs twice with both. This is tested where no two
///       images of corners are so near that single precision might join them.
///   (4) A file whose header is that of pcvt is, byte for byte, the one that encode_stl() gives for
///       its corners.
/// An STL holds no cells, no sites and no unit.
///
/// Example usage:
///     std::cout << prove_stl({"cells.stl", read_whole_file("cells.stl")}).n_surfaces;
///
/// @throws BadFile   as decode_stl(), or a field of a file of pcvt is another one.
/// @throws NotATile  naming the law and the triangle.
StlProof prove_stl(const EncodedFile& file);

/// Whether a file holds exactly these surfaces, in single precision.
/// @throws BadFile as decode_stl().
bool holds_surfaces(const EncodedFile& file, const ClosedSurfaces& surfaces);

}  // namespace pcvt
