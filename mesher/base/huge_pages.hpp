#pragma once

#include <cstddef>

namespace pcvt {

/// Advises the kernel to back an array with huge pages (Linux: 2 MiB) as far as the array covers
/// whole pages. Repeated, irregular access to arrays of tens of megabytes otherwise suffers from
/// TLB misses: at 10^6 sites they take a twelfth of an iteration. Pages that have been written are
/// copied at once, so this pays only for long-lived arrays. Contents never change, and the call has
/// no effect where the kernel refuses.
///
/// Example usage:
///
///     std::vector<double> values(n);
///     prefer_huge_pages(values);
void prefer_huge_pages(const void* begin, std::size_t n_bytes);

/// The same for all elements of an array.
template <class Array>
void prefer_huge_pages(const Array& array) {
    prefer_huge_pages(array.data(), static_cast<std::size_t>(array.size()) * sizeof(*array.data()));
}

}  // namespace pcvt
