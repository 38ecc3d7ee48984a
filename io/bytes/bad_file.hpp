#pragma once

#include "mesher/base/error.hpp"

namespace pcvt {

/// A file's content is at fault. The message reads `file:line: what; what to do` (no line where the
/// fault has none).
class BadFile : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

}  // namespace pcvt
