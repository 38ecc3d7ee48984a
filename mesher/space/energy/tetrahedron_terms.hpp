#pragma once

#include <array>

#include "mesher/space/delaunay/frame.hpp"
#include "mesher/space/energy/tetrahedron_corners.hpp"

namespace pcvt::space {

/// The contributions of many tetrahedra to the energy, its gradient and the volumes of the cells
/// (energy.hpp), without branches.
struct TetrahedronBlock {
    static constexpr int kSize = kTetrahedraPerBlock;
    using Row = BlockRow;

    /// Input: corners 1, 2 and 3 relative to corner 0, coordinates of the reduced basis.
    CornerRows corner;
    /// Output: x, y and z of the gradient at a corner, and the volume there; for each corner.
    std::array<std::array<Row, 4>, 4> terms;
    Row value;
    /// Lower bounds of the heights of the circumcentre above the facets, each times twice the area
    /// of its facet; minus infinity if the tetrahedron is not thick.
    std::array<Row, 4> height;
    /// Positive where the tetrahedron is certainly positively oriented and not thin.
    Row thick;
    /// Positive where the heights and `thick` are, which they are for most tetrahedra.
    Row certain;

    void compute(const Frame& frame);
    /// Replaces the contributions of tetrahedron k by those for its exact circumcentre: that of a
    /// flat tetrahedron, which doubles do not give, made those of compute() arbitrary.
    void correct(int k, const Frame& frame);
};

}  // namespace pcvt::space
