#pragma once

#include <array>
#include <vector>

#include "mesher/space/delaunay/torus_tetrahedra.hpp"

namespace pcvt::space {

/// Tetrahedra are computed in blocks of this size, side by side.
inline constexpr int kTetrahedraPerBlock = 32;
using BlockRow = std::array<double, kTetrahedraPerBlock>;

/// Lower bounds of the heights of the centres of tetrahedra above their facets, each times twice
/// the area of its facet, in single precision. A facet is locally Delaunay, with orthocentres
/// locally regular, if its two heights have a sum >= 0.
///
/// Example usage:
///
///     FacetHeights heights;
///     heights.resize(n_tetrahedra);
///     heights.keep(0, block.height);  // of each block; any thread
///     heights.remove_certain(tetrahedra, facets);
class FacetHeights {
   public:
    void resize(int n_tetrahedra) {
        heights_.resize(4 * std::size_t(n_tetrahedra + kTetrahedraPerBlock));
    }
    /// Keeps the heights of a block.
    /// @param first  its first tetrahedron, a multiple of kTetrahedraPerBlock.
    void keep(int first, const std::array<BlockRow, 4>& height);
    /// Removes the facets whose two heights have a sum that is certainly positive.
    void remove_certain(const TorusTetrahedra& tetrahedra, std::vector<int>& facets) const;

   private:
    /// Where the height above facet f is kept: the rows of each block of tetrahedra follow each
    /// other.
    static std::size_t place(int f) {
        const int t = f / 4;
        return 4 * std::size_t(t - t % kTetrahedraPerBlock) + (f % 4) * kTetrahedraPerBlock +
               t % kTetrahedraPerBlock;
    }

    std::vector<float> heights_;
};

}  // namespace pcvt::space
