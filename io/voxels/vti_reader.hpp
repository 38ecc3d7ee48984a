#pragma once

#include <optional>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/voxels/damask_material.hpp"
#include "mesher/plane/voxels/voxel_proof.hpp"
#include "mesher/space/voxels/voxel_proof.hpp"

namespace pcvt {

/// An image of space, and where the file states them the sites of its cells.
struct SpaceVoxels {
    space::VoxelImage image;
    std::optional<space::VoxelCells> cells = {};
};

/// A voxel image as read from a file, before any of it is believed.
struct VoxelFile {
    /// The image of a file of the plane.
    plane::VoxelImage image;
    /// Where the file states the sites of the cells.
    std::optional<plane::VoxelCells> cells = {};
    /// The voxels of a file of space, whose `image` and `cells` are empty.
    std::optional<SpaceVoxels> space = {};
    /// One a cell, where the materials lie beside the image.
    std::optional<std::vector<DamaskEntry>> materials = {};
};

/// Reads a voxel image in the form that DAMASK 3 reads: VTK image data, little-endian, with the
/// array `material` of the cells as Int32 or Int64 in inline base64, compressed by zlib or not.
/// Beside it, a second file of `files` holds the materials. An image whose sites have three
/// coordinates, or without sites one whose layers along z differ, is one of space, others are of
/// the plane.
///
/// Example usage:
///     const VoxelFile file = decode_vti({{"tile.vti", read_whole_file("tile.vti")}});
///     if (file.cells) prove_voxels(file.image, *file.cells);
///
/// @throws BadFile  naming the line and the remedy.
VoxelFile decode_vti(const std::vector<EncodedFile>& files);

/// Proves all that a file states.
/// @throws NotATile  as prove_voxels() and require_voxel_ids() do.
/// @throws BadFile   the materials are not those of cells of the image.
VoxelProof prove_voxel_file(const std::vector<EncodedFile>& files, const VoxelFile& file);

}  // namespace pcvt
