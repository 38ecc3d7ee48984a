#pragma once

#include "mesher/space/delaunay/frame.hpp"
#include "mesher/space/energy/tetrahedron_corners.hpp"

namespace pcvt::space {

/// The contributions of many tetrahedra to the cells of a power diagram (power_cells.hpp), without
/// branches.
struct PowerBlock {
    static constexpr int kSize = kTetrahedraPerBlock;
    using Row = BlockRow;
    /// The edges in the order of `conductance`.
    static constexpr std::array<std::array<int, 2>, 6> kEdges{
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

    /// Input: corners 1, 2 and 3, and the weights of all four.
    CornerRows corner;
    std::array<Row, 4> weight;
    /// Output: the volume at each corner, and the conductance of each edge.
    std::array<Row, 4> volume;
    std::array<Row, 6> conductance;
    /// As in TetrahedronBlock, for the orthocentre.
    std::array<Row, 4> height;
    Row thick;
    Row certain;
    /// Output of compute_moments(): x, y and z of the gradient at each corner, and the energy.
    std::array<std::array<Row, 3>, 4> gradient;
    Row value;

    /// Computes all outputs but those of compute_moments().
    void compute(const Frame& frame);
    /// Computes all outputs.
    void compute_moments(const Frame& frame);
    /// Replaces the contributions of tetrahedron k by those for its exact orthocentre, all outputs
    /// but `thick`.
    void correct(int k, const Frame& frame);
};

}  // namespace pcvt::space
