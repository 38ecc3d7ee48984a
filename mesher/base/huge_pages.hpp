#pragma once

#include <cstddef>

namespace pcvt {

/// Asks the kernel to hold an array in its large pages (Linux: 2 MiB), as far as it fills such
/// pages. Who walks through arrays of tens of megabytes again and again, in no strict order, waits
/// for the addresses of small pages as well as for the numbers: at 10^6 sites a twelfth of an
/// iteration. What is written there already is moved at once, for the price of some copies, so this
/// is for arrays that stay. Changes no number, and does nothing where the kernel refuses.
void prefer_huge_pages(const void* begin, std::size_t n_bytes);

/// The same for all numbers of an array.
template <class Array>
void prefer_huge_pages(const Array& array) {
    prefer_huge_pages(array.data(), static_cast<std::size_t>(array.size()) * sizeof(*array.data()));
}

}  // namespace pcvt
