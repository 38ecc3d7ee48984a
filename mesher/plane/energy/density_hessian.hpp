#pragma once

#include "mesher/base/block_matrix.hpp"
#include "mesher/plane/density/cell_quadrature.hpp"
#include "mesher/plane/density/unwrapped_cells.hpp"

namespace pcvt::plane {

/// The Hessian of the periodic CVT energy for a density, in the frame, the unit and the numbering
/// of the triangulation: density x unit^2.
///
/// As for rho = 1 (hessian.hpp, with the table of symbols), with rho under the integrals over the
/// edges of a cell,
///
///   H_ij  =  2 / |x_j - x_i| integral over the edge of rho (p - x_i) (p - x_j)^T
///   H_ii  =  2 m_i 1 - sum 2 / |x_j - x_i| integral over the edge of rho (p - x_i) (p - x_i)^T
///
/// Break lines cut an edge into parts. On each part the integral uses a Gauss rule with as many
/// points as the finer rule of the two adjacent cells has along a direction, so that the accuracy
/// is about the same. For an edge between images of one site both terms belong to H_ii.
/// Translations change F, so rows do not sum to zero. Laws, tested by number:
///   (1) It is the derivative of the gradient (density_energy.hpp), to the accuracy of the rule.
///   (2) For rho = c it is c times the Hessian of hessian.hpp.
///   (3) It is symmetric, except for the rounding of off-diagonal blocks to single precision.
class DensityHessian {
   public:
    /// All arguments must outlive this object.
    /// @param cells  updated by locate().
    /// @param order  of the cells' rules.
    /// @param mass   of the cells, density x unit^2.
    DensityHessian(const MovingDelaunay& delaunay, const UnwrappedCells& cells,
                   const CellQuadrature& quadrature, std::span<const std::uint8_t> order,
                   const Eigen::VectorXd& mass)
        : delaunay_(delaunay), cells_(cells), quadrature_(quadrature), order_(order), mass_(mass) {}

    /// Allocates all rows.
    void resize(BlockMatrix& hessian) const;
    /// Computes the rows of the sites first ... end - 1.
    /// @param per_unit  1 over the unit of the density.
    /// @throws BadDensity as the probe does.
    void fill_rows(SiteId first, SiteId end, double per_unit, DensityProbe& probe,
                   BlockMatrix& hessian) const;

   private:
    /// The cells of a range of sites and the parts of their sides, in order.
    struct Rows {
        CellList cells;
        std::vector<CellCorner> corners;
        /// The number of parts of each side.
        std::vector<int> n_parts;
        /// For each part its end, as a fraction of the side.
        std::vector<double> part_end;
        std::vector<double> shares;
        /// The next unused part, and the next unused value of rho.
        std::size_t next_part = 0;
        const double* next_rho = nullptr;

        CellView cell(std::size_t k) const {
            return {corners.data() + cells.begin[k],
                    std::size_t(cells.begin[k + 1] - cells.begin[k])};
        }
    };

    /// The rule for the side of a cell towards a neighbour.
    const GaussRule& side_rule(SiteId site, SiteId neighbour) const;
    void place_side(const GaussRule& rule, const CellCorner& from, const CellCorner& to, Rows& rows,
                    DensityProbe& probe) const;
    void fill_row(SiteId site, std::size_t k, Rows& rows, BlockMatrix& hessian) const;

    const MovingDelaunay& delaunay_;
    const UnwrappedCells& cells_;
    const CellQuadrature& quadrature_;
    std::span<const std::uint8_t> order_;
    const Eigen::VectorXd& mass_;
};

}  // namespace pcvt::plane
