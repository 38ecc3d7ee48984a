#pragma once

#include "mesher/base/error.hpp"

namespace pcvt {

/// The content of a file is invalid. The message reads `file:line: problem; remedy`; the line is
/// left out where the problem has none.
///
/// Example usage:
///     if (n_faces == 0) throw BadFile(name + ": there is no face; give a mesh");
class BadFile : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

/// A file may be right, but cannot be examined: it cannot be opened, its format is unknown or does
/// not have what is to be examined, or it names no lattice, and none is given.
class UnusableFile : public BadFile {
   public:
    using BadFile::BadFile;
};

}  // namespace pcvt
