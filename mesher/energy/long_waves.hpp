#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "mesher/delaunay/moving_delaunay.hpp"

namespace pcvt {

/// With fewer sites no wave is long.
inline constexpr int kFewestForLongWaves = 500;

/// An approximate inverse of the Hessian of F for rho = 1, as a preconditioner for large n.
///
/// What makes an optimiser need the more iterations the more sites there are is long waves: along a
/// wave of displacements of wave vector k the Hessian is only C |k|^2. Near a hexagonal arrangement
/// C is 0.417 h^4 along k and 0.0963 h^4 across it (measured), whereas a site that moves alone
/// feels 2 h^2. So the inverse is 1 / (2 h^2) and, for what sites do together,
///
///   M^-1 r = r / (2 h^2) + w P F^-1 [ kk^T / (C_L k^4) + (1 - kk^T / k^2) / (C_T k^2) ] F P^T r
///
/// with the Fourier transform F on a grid that is a little coarser than the sites, and bilinear
/// interpolation P between it and the sites where they were when this object was made: symmetric,
/// positive definite and linear, as the optimiser wants it.
class LongWaves {
   public:
    LongWaves(const MovingDelaunay& delaunay, Workers& workers);
    ~LongWaves();
    LongWaves(const LongWaves&) = delete;
    LongWaves& operator=(const LongWaves&) = delete;

    /// p = M^-1 r; both 2 n numbers (x, y, x, y, ...), in the frame and the unit of the
    /// triangulation and the order of its sites. The same bits for any number of workers.
    void apply(const Eigen::VectorXd& r, Eigen::VectorXf& p);

   private:
    class Grid;
    /// Sites first_site ... end_site - 1 reach the nodes of rows first_row ... end_row - 1.
    struct Stretch {
        int first_site;
        int end_site;
        int first_row;
        int end_row;
    };

    void place_sites(const MovingDelaunay& delaunay);
    bool neighbours_only() const;
    void collect(const Eigen::VectorXd& r);
    void solve();
    void distribute(const Eigen::VectorXd& r, Eigen::VectorXf& p);

    Workers& workers_;
    ReducedFrame frame_;
    double area_per_site_;
    int n_sites_;
    /// Per site its place on the grid: row and column with fractions.
    Eigen::Matrix2Xf place_;
    /// In the order of the sites.
    std::vector<Stretch> stretches_;
    /// The x and the y components.
    std::unique_ptr<Grid> x_;
    std::unique_ptr<Grid> y_;
};

}  // namespace pcvt
