#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "mesher/plane/delaunay/moving_delaunay.hpp"

namespace pcvt::plane {

/// With fewer sites there are no long waves.
inline constexpr int kFewestForLongWaves = 500;

/// An approximate inverse of the Hessian of F for rho = 1, a preconditioner for large n.
///
/// Long waves are the reason why optimisers need more iterations for more sites: for a wave of
/// displacements with wave vector k the Hessian is only C |k|^2. Near a hexagonal arrangement C is
/// C_L = 0.417 h^4 along k and C_T = 0.0963 h^4 across k (measured), whereas one site that moves
/// among fixed ones has the stiffness 2 h^2. The inverse is therefore 1 / (2 h^2) plus a term for
/// collective motion,
///
///   M^-1 r = r / (2 h^2) + w P F^-1 [ kk^T / (C_L k^4) + (1 - kk^T / k^2) / (C_T k^2) ] F P^T r
///
/// with the Fourier transform F on a grid slightly coarser than the sites, and bilinear
/// interpolation P from the grid to the positions of the sites at construction. M^-1 is symmetric,
/// positive definite and linear, as the optimiser requires.
///
/// Example usage:
///
///     LongWaves preconditioner(delaunay, workers);
///     Eigen::VectorXf p;
///     preconditioner.apply(energy.gradient, p);
class LongWaves {
   public:
    LongWaves(const MovingDelaunay& delaunay, Workers& workers);
    ~LongWaves();
    LongWaves(const LongWaves&) = delete;
    LongWaves& operator=(const LongWaves&) = delete;

    /// Computes p = M^-1 r; both have 2 n numbers (x, y, x, y, ...), in the frame, the unit and the
    /// site order of the triangulation. The result is bit for bit the same for any number of
    /// workers.
    void apply(const Eigen::VectorXd& r, Eigen::VectorXf& p);

   private:
    class Grid;
    /// The sites first_site ... end_site - 1 use the nodes of rows first_row ... end_row - 1.
    struct Stretch {
        int first_site;
        int end_site;
        int first_row;
        int end_row;
    };

    void place_sites(const MovingDelaunay& delaunay);
    bool neighbours_only() const;
    Vec2 wave_vector(int i, int j) const;
    void collect(const Eigen::VectorXd& r);
    void solve();
    void distribute(const Eigen::VectorXd& r, Eigen::VectorXf& p);

    Workers& workers_;
    ReducedFrame frame_;
    /// The coordinate across the rows of the grid, which is that across the columns of sites.
    int across_;
    double area_per_site_;
    int n_sites_;
    /// The position of each site on the grid: fractional row and column.
    Eigen::Matrix2Xf place_;
    /// In the order of the sites.
    std::vector<Stretch> stretches_;
    std::unique_ptr<Grid> grid_;
};

}  // namespace pcvt::plane
