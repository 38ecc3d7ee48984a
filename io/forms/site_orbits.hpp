#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// Appends the lines in which files of pcvt state the orbits of sites 0, 1, ... of one period under
/// the symmetry of the run: `MARKsite_orbits K K ...`, several lines for many sites, none without
/// orbits.
///
/// Example usage:
///     append_site_orbits(text, "** pcvt ", options.site_orbits);
void append_site_orbits(std::string& text, std::string_view mark, std::span<const int> site_orbits);

/// Requires that there is an orbit for each site, or none at all, and that orbits are counted from
/// 0 in the order of their first sites. Sites without an element, which files of elements cannot
/// state, have the orbit -1 or lie at the end.
/// @param name    of the file, for the message of BadFile.
/// @param states_all  whether the file states orbits of sites without elements, too.
void require_site_orbits(const std::string& name, const std::vector<int>& site_orbits,
                         std::int64_t n_sites, bool states_all);

}  // namespace pcvt
