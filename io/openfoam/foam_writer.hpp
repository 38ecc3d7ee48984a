#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/openfoam/foam_case.hpp"

namespace pcvt {

/// Returns the paths of the files in the case folder `folder`, in the order of encode_foam().
std::vector<std::string> foam_paths(const std::string& folder, FoamCells cells);
/// The same as a member of a table of formats.
template <FoamCells kCells>
std::vector<std::string> foam_paths(const std::string& folder) {
    return foam_paths(folder, kCells);
}

/// Encodes a case folder for OpenFOAM that icoFoam, pimpleFoam and potentialFoam, and with a tracer
/// scalarTransportFoam, run without further input: a pair of cyclic patches for each translation, a
/// wall patch for each wall, empty patches at back and front of a layer, and an exact flow as the
/// initial state, which falls to 1/e by the end of the run. An empty file with the name of the
/// folder opens the case in ParaView.
///
/// Example usage:
///     OutputSet output;
///     output.stage_folder("tile.foam");
///     for (const EncodedFile& file : encode_foam(foam_case(tile, layer), "tile.foam")) {
///         output.stage(file.path, file.bytes);
///     }
std::vector<EncodedFile> encode_foam(const FoamCase& foam, const std::string& folder);

}  // namespace pcvt
