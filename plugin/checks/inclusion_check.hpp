#pragma once

#include <string>

#include "io/forms/tile_file.hpp"
#include "io/run_files/inclusion_reader.hpp"

namespace pcvt::checks {

/// Proves that no cell crosses the outline of an inclusion:
///   (1) A site lies in the shape whose tag its cell has, if the file states tags.
///   (2) The edges between cells inside of a shape and cells outside of it are the chords of one
///       closed polygon. The corners of a polygon are among its nodes, and its chords lie on the
///       sides. The nodes of a circle or an ellipse lie on one curve with the same centre and axes,
///       which is larger by one factor.
///   (3) The cells inside of a shape have its area, to 1e-12 of the domain.
///
/// Example usage:
///     line += prove_inclusions(path, file, proof, read_inclusions("shapes.txt"));
///
/// @returns the end of a line of proof.
/// @throws NotATile      naming the line of the shape.
/// @throws UnusableFile  the file has no cells or states no positions of its sites, or the shapes
/// are
///                   wrong.
std::string prove_inclusions(const std::string& path, const TileFile& file,
                             const plane::TileProof& proof, const InclusionFile& shapes);

}  // namespace pcvt::checks
