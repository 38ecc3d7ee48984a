#pragma once

#include <memory>
#include <mutex>

#include "mesher/plane/density/cell_sums.hpp"
#include "mesher/plane/energy/density_hessian.hpp"
#include "mesher/plane/energy/energy.hpp"

namespace pcvt::plane {

/// The accuracy of the rules of a DensityPass.
struct RuleCheck {
    /// Largest estimated error of a centroid, in units of sqrt(area) of its cell.
    double largest_error = 0;
    /// Number of cells in which no rule reaches the accuracy, because the density is not smooth
    /// there.
    int n_rough = 0;
    /// Number of cells whose order was raised.
    int n_raised = 0;
};

/// The periodic CVT energy and its gradient (paper, Eqs. 2 and 3) for a density.
///
///   F(x)    = sum_i  integral over cell i of  rho(p) |p - x_i|^2
///   dF/dx_i = 2 m_i (x_i - g_i)
///
///   paper | code
///   x_i   | MovingDelaunay::coordinates
///   rho   | Density, in units of density_unit
///   F     | Energy::value
///   m_i   | Energy::mass
///   g_i   | x_i - gradient_i / (2 m_i), the centroid
///
/// The first pass is EnergyPass, which repairs and certifies the triangulation. A second pass
/// integrates over the fan of each cell between its site and the circumcentres round it. Both F and
/// 2 m_i (x_i - g_i) are integrals that the rule computes to the given accuracy, so that one is the
/// gradient of the other to this accuracy. A low order would break this: 2 m_i (x_i - g_i) by
/// quadrature is not the gradient of F by quadrature.
///
/// Each cell has its own order q, which choose_orders selects from the difference between the rules
/// of order q and q + 1. Orders are constant between two calls of choose_orders, so that F is
/// smooth there. The units of EnergyPass are multiplied by density_unit.
///
/// Example usage:
///
///     DensityPass pass(delaunay, workers, lattice, density, 1);
///     pass.restore();
///     pass.choose_orders(1e-9, true);
///     pass.evaluate(energy);
///
/// Laws, tested by number:
///   (1) For rho = c everything is c times the result of EnergyPass.
///   (2) The masses sum to the integral of rho over the domain.
///   (3) The gradient is the gradient of F, by central differences.
///   (4) Every bit is the same for any number of workers.
class DensityPass {
   public:
    /// All arguments must outlive this object.
    DensityPass(MovingDelaunay& delaunay, Workers& workers, const Lattice& lattice,
                const Density& density, double density_unit);
    ~DensityPass();

    /// Restores the triangulation after a step, and evaluates.
    /// @returns false if two sites coincide.
    /// @throws BadDensity of the first cell with a bad value.
    bool evaluate(Energy& energy);
    /// Restores the triangulation only.
    bool restore() { return pass_.evaluate(uniform_); }
    /// The second derivatives at the positions evaluated last, see density_hessian.hpp.
    /// @param mass  of that evaluation.
    void hessian(const Eigen::VectorXd& mass, BlockMatrix& hessian);
    /// Areas of the cells at the last evaluation, unit^2.
    const Eigen::VectorXd& areas() const { return uniform_.mass; }

    /// Chooses the order of each cell at the current positions.
    /// @param accuracy  of a centroid, in units of sqrt(area) of its cell; m and F have the same
    ///                  relative accuracy.
    /// @param lower     whether orders may decrease.
    RuleCheck choose_orders(double accuracy, bool lower);
    /// Density evaluations per site in the last evaluation.
    double evaluations_per_site() const { return evaluations_per_site_; }
    /// Statistics of the density over all evaluations.
    const DensityRange& range() const { return probes_.range(); }

   private:
    struct Task;
    void choose_orders(std::vector<OrderedCell> cells, double accuracy, CellSums& sums, Task& task);
    void run_tasks(const std::function<void(SiteId, SiteId, DensityProbe&, Task&)>& work);
    void sum_tasks(const std::function<void(SiteId, SiteId, CellSums&, Task&)>& work);
    std::unique_ptr<CellSums> take_sums(DensityProbe& probe);

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
    /// Sums that no task uses, with their memory: at most one for each probe.
    std::mutex mutex_;
    std::vector<std::unique_ptr<CellSums>> idle_;
    double evaluations_per_site_ = 0;
};

}  // namespace pcvt::plane
