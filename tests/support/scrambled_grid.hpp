#pragma once

#include <random>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::testing {

/// Rectangular, thin, oblique, left-handed, skewed, tiny and huge lattices.
std::vector<plane::Lattice> many_lattices();

/// A grid of up to 5 x 5 parallelograms or twice as many triangles with jittered vertices; vertex
/// numbers, first corners of faces and the directions of stored pairs are random.
plane::Tile scrambled_grid(const plane::Lattice& lattice, std::mt19937& random);

}  // namespace pcvt::testing
