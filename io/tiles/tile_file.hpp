#pragma once

#include <optional>
#include <string>

#include "mesher/base/error.hpp"
#include "mesher/proof/validate.hpp"
#include "mesher/tile/flat_tile.hpp"

namespace pcvt {

/// A file's content is at fault. The message reads `file:line: what; what to do` (no line where the
/// fault has none).
class BadFile : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

/// A tile as read from a file, before any of it is believed.
struct TileFile {
    FlatTile tile;
    Precision precision;
    /// False where the file carries no pairing; tile.vertex_pairs and edge_pairs are empty then.
    bool has_vertex_pairs;
    bool has_edge_pairs;
};

}  // namespace pcvt
