#pragma once

#include <algorithm>
#include <cfenv>
#include <cstddef>
#include <cstring>

#include "mesher/base/error.hpp"
#include "plugin/abi/guard.hpp"
#include "plugin/abi/struct_versions.hpp"

namespace pcvt::abi {

/// Fills a view, in the size that the host knows.
///
/// Example usage:
///     return give("pcvt_tile", view, view_size, [&] { return result.tile(layout); });
template <class View, class Look>
pcvt_status give(const char* name, View* view, std::size_t size, const Look& look) {
    return guarded([&](const std::fenv_t&) {
        if (view == nullptr) throw InvalidInput("view is a null pointer");
        check_struct_size(name, size, kOldestSize<View>);
        const View full = look();
        std::memset(static_cast<void*>(view), 0, size);
        std::memcpy(static_cast<void*>(view), &full, std::min(size, sizeof full));
        return pcvt_status{PCVT_OK};
    });
}

/// Fills the defaults into options, in the size that the host knows.
/// @param look  returns them. The options do not change where it throws.
template <class Options, class Look>
pcvt_status give_defaults(const char* name, Options* options, std::size_t size,
                          std::uint32_t abi_version, const Look& look) {
    return guarded([&](const std::fenv_t&) {
        if (options == nullptr) throw InvalidInput("options is a null pointer");
        check_version(abi_version);
        check_struct_size(name, size, kOldestSize<Options>);
        const Options defaults = look();
        std::memset(static_cast<void*>(options), 0, size);
        std::memcpy(static_cast<void*>(options), &defaults, std::min(size, sizeof defaults));
        options->struct_size = size;
        return pcvt_status{PCVT_OK};
    });
}

}  // namespace pcvt::abi
