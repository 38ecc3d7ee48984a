#include "io/forms/finite.hpp"

#include <string>

#include "mesher/base/error.hpp"

namespace pcvt {

void require_finite(const plane::Tile& tile) {
    for (int v = 0; v < tile.n_vertices(); ++v) {
        if (!tile.points[v].allFinite()) {
            throw InternalError("vertex " + std::to_string(v) + " of the tile is not finite");
        }
    }
}

}  // namespace pcvt
