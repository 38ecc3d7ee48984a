#pragma once

#include <optional>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/tile_file.hpp"
#include "mesher/space/tile/tile_surface.hpp"

namespace pcvt {

/// Reads the `.om` files of encode_om() byte by byte. OpenMesh is not used, because it trusts its
/// input; this reader checks that indices are in range, that partners are mutual and that chunks
/// have their stated length.
///
/// Faces, vertices and seam come back as tile() returns them (mesher/plane/tile/openmesh_tile.hpp).
///
/// Example usage:
///     const TileFile file = decode_om({{"tile.om", read_whole_file("tile.om")}}, std::nullopt);
///     const TileProof proof = prove_tile(file.tile, file.precision);
///
/// @param lattice  has no effect: encode_om() always stores the lattice.
/// @throws BadFile naming the fault, also for an `.om` file without the identification.
TileFile decode_om(const std::vector<EncodedFile>& files,
                   const std::optional<plane::Lattice>& lattice);

/// Whether a file has the properties of an OpenMesh file of encode_om_boundary().
bool holds_om_boundary(const EncodedFile& file);

/// Reads a file of encode_om_boundary() with the same care.
/// @throws BadFile naming the file.
space::TileSurface decode_om_boundary(const EncodedFile& om);

}  // namespace pcvt
