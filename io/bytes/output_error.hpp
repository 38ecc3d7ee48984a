#pragma once

#include <string>

#include "mesher/base/error.hpp"

namespace pcvt {

/// A file could not be written. The message names the path and the system's reason.
///
/// Example usage:
///     throw OutputError("tile.obj: cannot write: No space left on device");
class OutputError : public Error {
   public:
    using Error::Error;
};

/// The file exists already and may not be replaced. The message ends there, because only the caller
/// knows how its users permit the replacement.
class OutputExists : public OutputError {
   public:
    using OutputError::OutputError;
};

/// The single precision of a file does not hold the tile. The other files of a run are written.
class CoarsePrecision : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

/// A file that a run left out for CoarsePrecision.
struct RefusedFile {
    std::string path;
    /// Begins with the path.
    std::string reason;
};

}  // namespace pcvt
