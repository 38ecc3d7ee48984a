#pragma once

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

}  // namespace pcvt
