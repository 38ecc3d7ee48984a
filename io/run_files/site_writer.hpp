#pragma once

#include <string>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// The bytes of a .txt file of sites: a comment, then "x y" a line in the order of the input, which
/// read_sites gives back exactly.
/// @throws InternalError if a coordinate is not finite.
std::string encode_sites(const Points& points);

}  // namespace pcvt
