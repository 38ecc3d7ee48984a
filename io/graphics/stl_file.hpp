#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/closed_surfaces.hpp"

namespace pcvt {

/// A facet of an STL file: its normal and its corners, in single precision.
struct StlFacet {
    Eigen::Vector3f normal;
    std::array<Eigen::Vector3f, 3> corners;
};

/// The contents of a binary STL file.
struct StlFile {
    /// "pcvt cells, periods 1 0 0 0 1 0 0 0 1", in at most 80 bytes.
    std::string header = {};
    std::vector<StlFacet> facets = {};
};

/// Encodes closed surfaces as a binary STL, which states no unit of length and no parts, and its
/// positions in single precision. The header names the form of the surfaces, and the period vectors
/// where they fit.
///
/// Example usage:
///     const ClosedSurfaces surfaces = closed_surfaces(tile.mesh, SurfaceForm::kCells);
///     const std::vector<EncodedFile> files = encode_stl(surfaces, "cells.stl");
///
/// @throws CoarsePrecision  naming the path: rounding to single precision would bring two points
///                          together, turn a facet by more than 60 degrees, or leave it no area.
std::vector<EncodedFile> encode_stl(const ClosedSurfaces& surfaces, const std::string& path);

/// Returns the facets of closed surfaces as a file holds them.
std::vector<StlFacet> stl_facets(const ClosedSurfaces& surfaces);

/// Encodes facets as they are.
std::vector<EncodedFile> encode_stl(const StlFile& stl, const std::string& path);

/// Reads a binary STL. Zeros lose their sign.
/// @throws BadFile  naming the file: it is a text, its length is not that of its facets, or a
///                  number is not finite.
StlFile decode_stl(const EncodedFile& file);

/// Returns the form and the period vectors that the header of a file of pcvt states; nothing of
/// other programs.
std::optional<SurfaceForm> stl_form(const StlFile& stl);
std::optional<space::Lattice> stl_lattice(const StlFile& stl);

/// Returns the normal of length 1 of a facet by its corners; zeros for a facet without area.
Eigen::Vector3f stl_normal(const std::array<Eigen::Vector3f, 3>& corners);

}  // namespace pcvt
