#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/cells/cell_graph.hpp"
#include "mesher/cvt/energy.hpp"
#include "mesher/space/delaunay/frame.hpp"
#include "mesher/space/delaunay/tetrahedra_flips.hpp"
#include "mesher/space/energy/facet_heights.hpp"

namespace pcvt::space {

/// A triangulation and the data that its power cells depend on.
struct WeightedTetrahedra {
    const TorusTetrahedra& tetrahedra;
    /// 3 x n, reduced basis.
    const Points& coordinates;
    /// The frame, in any unit of length.
    Frame frame;
    /// unit^2
    const Eigen::VectorXd& weights;
};

/// Computes the volumes of the cells of sites with weights w_i, the sets where |p - x_i|^2 - w_i is
/// least, and finds the facets that may not be locally regular, in the same pass.
///
/// As in EnergySums, a cell consists of signed orthoschemes, from x_i to the foot m of the edge i j
/// of the triangulation on the plane between the two cells, to the foot Phi of a facet, to the
/// orthocentre C of a tetrahedron, of equal power distance to its corners p. For a facet i j k with
/// the normal N towards its tetrahedron, twice its area long, and an edge i j of it,
///
///   symbol  | code
///   q       | (C - p_i).N / |N|^2            Phi = C - q N
///   l^2     | |p_j - p_i|^2, squared
///   alpha_i | l^2 + w_i - w_j                m = p_i + alpha_i (p_j - p_i) / (2 l^2)
///   D_k     | (p_i - p_k).(p_j - p_k), and D_i and D_j alike
///   B       | l^2 D_k + D_j (w_i - w_k) + D_i (w_j - w_k)
///   c       | B q / (8 l^2), the part of the conductance c_ij = -dV_i / dw_j
///
///   V_i            +=  c alpha_i / 3
///   F              +=  2 c alpha_i (6 alpha_i^2 / 4 l^2 + 3 B^2 / 4 |N|^2 l^2 + q^2 |N|^2) / 60
///   V_i (g_i - x_i) += 2 c alpha_i (m + Phi + C - 3 p_i) / 24
///
/// Without weights these are the sums of EnergySums. Sites that are images of each other add to
/// volumes, not to conductances. The volumes are those of the cells only where the triangulation is
/// regular. A facet is locally regular iff the heights q |N| of its two orthocentres have a sum
/// >= 0.
///
/// Example usage:
///
///     VolumeSums sums;
///     Eigen::VectorXd volumes;
///     const std::vector<int> suspects = sums.run(weighted, workers, volumes);
///     Energy cells;
///     measure_cells(weighted, workers, cells);
///     const Vec3 to_centroid = -cells.gradient.segment<3>(4 * i) / (2 * cells.mass[i]);
///
/// Laws, tested by number, for regular triangulations:
///   (1) Volumes, gradient and energy are those of the polyhedra.
///   (2) The volumes sum to the volume of the domain.
///   (3) The derivative of the volumes by the weights is minus the Laplacian of the graph.
///   (4) Every bit is the same for any number of workers.
///   (5) A facet that is not among the suspects is locally regular.
///
/// The object keeps its memory from call to call.
class VolumeSums {
   public:
    VolumeSums();
    ~VolumeSums();
    VolumeSums(VolumeSums&&) noexcept;
    VolumeSums& operator=(VolumeSums&&) noexcept;

    /// @param volumes  resized to n, unit^3.
    /// @returns the facets that are not certainly locally regular, at least one side of each.
    std::vector<int> run(const WeightedTetrahedra& weighted, Workers& workers,
                         Eigen::VectorXd& volumes);

   private:
    struct Slab;
    std::vector<Slab> slabs_;
    FacetHeights heights_;
};

/// Corrects volumes for tetrahedra that were exchanged, at a cost in proportion to their number.
/// @returns false, with volumes that must not be used, if the contribution of a tetrahedron is so
///          large that its rounding would show.
bool correct_volumes(ExchangedTetrahedra exchanged, const WeightedTetrahedra& weighted,
                     Eigen::VectorXd& volumes);

/// Computes energy, gradient and volumes of the power cells for rho = 1.
void measure_cells(const WeightedTetrahedra& regular, Workers& workers, Energy& cells);

/// Computes the adjacency of the cells; each neighbour of a cell occurs once.
CellGraph cell_graph(const WeightedTetrahedra& regular);

}  // namespace pcvt::space
