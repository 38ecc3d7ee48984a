#pragma once

#include "mesher/density/cell_sums.hpp"
#include "mesher/energy/density_hessian.hpp"
#include "mesher/energy/energy.hpp"

namespace pcvt {

/// How well the rules of a DensityPass resolve the density.
struct RuleCheck {
    /// Largest estimated error of a centroid, in units of sqrt(area) of its cell.
    double largest_error = 0;
    /// Cells in which no rule reaches the accuracy: the density is not smooth there.
    int n_rough = 0;
    /// Cells whose rule is a larger one than before.
    int n_raised = 0;
};

/// The periodic CVT energy and its gradient (paper, Eqs. 2 and 3) for a density.
///
///   F(x)    = sum_i  integral over cell i of  rho(p) |p - x_i|^2
///   dF/dx_i = 2 m_i (x_i - g_i)
///
/// The first pass is that of EnergyPass, which repairs and certifies the triangulation; a second
/// one integrates over the fan of each cell between its site and the circumcentres round it. Both F
/// and 2 m_i (x_i - g_i) are integrals that the rule gives to within the accuracy asked for, so the
/// one is the gradient of the other to that accuracy. A low order would break this: 2 m_i (x_i -
/// g_i) by quadrature is not the gradient of F by quadrature.
///
/// Each cell has its own order q, chosen by choose_orders from the difference between the rules q
/// and q + 1 and kept until it is called again: so F stays a smooth function between two calls.
/// Units are those of EnergyPass times density_unit. Laws, tested by number:
///   (1) For rho = c everything is c times that of EnergyPass.
///   (2) The masses sum to the integral of rho over the domain.
///   (3) The gradient is that of F, by central differences.
///   (4) Every bit is the same for any number of workers.
class DensityPass {
   public:
    /// All must outlive this object.
    DensityPass(MovingDelaunay& delaunay, Workers& workers, const Lattice& lattice,
                const Density& density, double density_unit);
    ~DensityPass();

    /// Restores the triangulation after a step, and evaluates.
    /// @returns false where two sites coincide.
    /// @throws BadDensity of the first such cell.
    bool evaluate(Energy& energy);
    /// Restores the triangulation alone.
    bool restore() { return pass_.evaluate(uniform_); }
    /// The second derivatives at the place evaluated last, see weighted_hessian.hpp.
    /// @param mass  of that evaluation.
    void hessian(const Eigen::VectorXd& mass, BlockMatrix& hessian);
    /// Areas of the cells at the last look, unit^2.
    const Eigen::VectorXd& areas() const { return uniform_.mass; }

    /// Chooses the order of each cell as it stands.
    /// @param accuracy  of a centroid, in units of sqrt(area) of its cell; the same of m and F.
    /// @param lower     whether orders may become lower than they are.
    RuleCheck choose_orders(double accuracy, bool lower);
    /// Density evaluations in one evaluation, over the number of sites, at the last one.
    double evaluations_per_site() const { return evaluations_per_site_; }
    /// What was asked of the density since the beginning.
    const DensityRange& range() const { return probes_.range(); }

   private:
    struct Task;
    void choose_orders(std::vector<OrderedCell> cells, double accuracy, CellSums& sums, Task& task);
    void run_tasks(const std::function<void(SiteId, SiteId, DensityProbe&, Task&)>& look);

    MovingDelaunay& delaunay_;
    Workers& workers_;
    EnergyPass pass_;
    UnwrappedCells cells_;
    Energy uniform_;
    CellQuadrature quadrature_;
    DensityProbes probes_;
    double per_unit_;
    std::vector<std::uint8_t> order_;
    std::vector<Task> tasks_;
    double evaluations_per_site_ = 0;
};

}  // namespace pcvt
