#pragma once

#include <functional>
#include <string>

#include "mesher/plane/proof/validate.hpp"

namespace pcvt::checks {

/// Proves a tile with a tolerance of positions, and returns the mismatch that it finds.
using SeamProof = std::function<double(double tolerance)>;

/// Returns the end of the message about a tile whose sides do not agree within the usual tolerance:
/// the mismatch, and a value of --tolerance that accepts the tile. Returns "" where the tile is
/// refuted for another reason as well.
///
/// Example usage:
///     } catch (const SeamMismatch& fault) {
///         throw NotATile(fault.what() + tolerance_advice(fault, prove_again));
///     }
///
/// Cost: that of some proofs of the tile.
std::string tolerance_advice(const SeamMismatch& fault, const SeamProof& prove);

}  // namespace pcvt::checks
