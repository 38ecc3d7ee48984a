// Words of options in the order of their numbers in pcvt.h. Written by plugin/words.
#pragma once

#include <array>

namespace pcvt::meshlab {

inline constexpr std::array kStartWords{"default", "random", "coarse", "lattice", "best"};
inline constexpr std::array kMeshWords{"voronoi", "delaunay", "grains"};
inline constexpr std::array kOutlineWords{"whole", "box"};

}  // namespace pcvt::meshlab
