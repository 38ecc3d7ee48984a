#pragma once

#include <string>

#include "mesher/base/error.hpp"

namespace pcvt::testing {

/// The message with which a call refuses its input, by an error of the type Fault; empty if it
/// takes it.
///
/// Example usage:
///     EXPECT_THAT(refusal_of([&] { decode_stl(file); }), HasSubstr("facets"));
template <class Fault = InvalidInput, class Call>
std::string refusal_of(const Call& call) {
    try {
        call();
    } catch (const Fault& fault) {
        return fault.what();
    }
    return "";
}

}  // namespace pcvt::testing
