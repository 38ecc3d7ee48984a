#pragma once

#include <string>

#include "mesher/base/error.hpp"

namespace pcvt::testing {

/// The message with which a call refuses its input; empty if it takes it.
///
/// Example usage:
///     EXPECT_THAT(refusal_of([&] { decode_stl(file); }), HasSubstr("facets"));
template <class Call>
std::string refusal_of(const Call& call) {
    try {
        call();
    } catch (const InvalidInput& fault) {
        return fault.what();
    }
    return "";
}

}  // namespace pcvt::testing
