#pragma once

#include <vector>

#include "io/formats/formats.hpp"
#include "mesher/finite_volume/mpas_grid_proof.hpp"

namespace pcvt {

/// Proves the tile of a file: its laws, its stored pairs and its site ids.
/// @throws NotATile naming the first fault.
plane::TileProof prove_tile_file(const TileFile& file);

/// Proves all that `files` state: the tile that was read from them, and, where they state its
/// lattice as pcvt writes it, each further field that follows from the tile. These fields follow
/// unless a cell touches another image of itself so that the cells of some faces are not clear
/// (FaceImages::are_clear).
///
/// Example usage:
///   const TileFile file = decode_tile(format, files, std::nullopt);
///   const TileProof proof = prove_file(format, files, file);
///
/// @throws NotATile as prove_tile_file().
/// @throws BadFile  naming the file, the line and the field that is wrong.
plane::TileProof prove_file(const Format& format, const std::vector<EncodedFile>& files,
                            const TileFile& file);

/// Proves the tile that `format` reads in `files`, with the stored pairs. Skips the proof if every
/// number is that of `original`: its encoding is the bytes of `files`, so that each field is the
/// one that follows from the tile.
/// @pre decode_tile() takes the format.
/// @param original  the encoded tile, proved.
/// @param origin    the corner of its domain, for the advice in a message.
/// @param options   with which it was encoded; materials and orbits are compared.
/// @throws CoarsePrecision  `original` is too fine for the format's single precision.
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_tile_files(const Format& format, const std::vector<EncodedFile>& files,
                      const plane::Tile& original, const plane::Vec2& origin,
                      const FileOptions& options = {});

/// Proves the staggered grid that was read from `files`, and the graph of its cells beside it.
/// @throws NotATile  the grid violates a law.
/// @throws BadFile   the graph is another one.
MpasGridProof prove_grid(const std::vector<EncodedFile>& files, const MpasGrid& grid);

/// Proves the staggered grid that `format` reads in `files`.
/// @pre format.reads_grid().
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_grid_files(const Format& format, const std::vector<EncodedFile>& files);

/// Proves the voxels that `format` reads in `files`, and that the materials are these.
/// @pre format.reads_voxels().
/// @throws InternalError  a law is violated: a fault of pcvt.
void prove_voxel_files(const Format& format, const std::vector<EncodedFile>& files,
                       const CellMaterials& materials);

/// Proves that `format` reads exactly `sites` in `files`.
/// @pre format.reads_sites().
/// @throws InternalError  another site is read: a fault of pcvt.
void prove_site_files(const Format& format, const std::vector<EncodedFile>& files,
                      const plane::Points& sites);

/// Proves that `format` reads exactly `rows` in `files`.
/// @pre format.reads_cells().
/// @throws InternalError  another row is read: a fault of pcvt.
void prove_cell_files(const Format& format, const std::vector<EncodedFile>& files,
                      const CellRows& rows);

}  // namespace pcvt
