#pragma once

#include <string>

#include "io/tiles/tile_file.hpp"

namespace pcvt::cli {

/// Returns the end of the message about a file whose sides do not agree within the usual tolerance:
/// the mismatch, and a value of --tolerance that accepts the file. Returns "" where the tile is
/// refuted for another reason as well.
///
/// Example usage:
///     } catch (const SeamMismatch& fault) {
///         throw NotATile(fault.what() + tolerance_advice(file, fault.mismatch()));
///     }
///
/// Cost: that of some proofs of the tile.
std::string tolerance_advice(const TileFile& file, double mismatch);

}  // namespace pcvt::cli
