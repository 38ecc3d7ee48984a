#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "mesher/cells/elastic_choices.hpp"
#include "mesher/plane/voxels/voxel_proof.hpp"
#include "mesher/space/voxels/voxel_proof.hpp"

namespace pcvt {

/// The image and, beside it, the materials: tile.vti, tile.material.yaml.
std::vector<std::string> vti_paths(const std::string& path);

/// Encodes a voxel image as VTK image data (`.vti`) in the form that DAMASK 3 reads: equal
/// layers of an image of the plane, or all layers of one of space, little-endian, whole extent from
/// 0, the array `material` of the cells, x fastest, inline base64 on one line, compressed by zlib
/// in blocks with 64-bit headers. The field data hold the positions, weights and metric of the
/// sites, by which `pcvt check` proves each voxel. Beside it lies encode_damask_material().
///
/// Example usage:
///     for (const EncodedFile& file : encode_vti(image, cells, materials, {}, "tile.vti")) {
///         outputs.stage(file.path, file.bytes);
///     }
std::vector<EncodedFile> encode_vti(const plane::VoxelImage& image, const plane::VoxelCells& cells,
                                    const CellMaterials& materials, const ElasticChoices& elastic,
                                    const std::string& path);
std::vector<EncodedFile> encode_space_vti(const space::VoxelImage& image,
                                          const space::VoxelCells& cells,
                                          const CellMaterials& materials,
                                          const ElasticChoices& elastic, const std::string& path);

}  // namespace pcvt
