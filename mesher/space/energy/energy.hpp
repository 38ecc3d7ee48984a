#pragma once

#include "mesher/base/workers.hpp"
#include "mesher/cvt/energy.hpp"
#include "mesher/space/delaunay/moving_tetrahedra.hpp"
#include "mesher/space/energy/facet_heights.hpp"
#include "mesher/space/energy/tetrahedron_terms.hpp"

namespace pcvt::space {

/// The CVT energy in space and its gradient.
///
///   F(x)    = sum_i  integral over cell i of  |p - x_i|^2
///   dF/dx_i = 2 V_i (x_i - g_i)
///
/// One pass over the Delaunay tetrahedra computes all of this without cells. A cell consists of
/// signed orthoschemes, tetrahedra with three successive edges a, b, h at right angles: from x_i to
/// the middle m of an edge, to the circumcentre Phi of a facet, to the circumcentre C of a
/// tetrahedron. Such a piece has the volume a b h / 6, the second moment
/// a b h (6 a^2 + 3 b^2 + h^2) / 60 about x_i, and its centroid is the mean of its corners. For a
/// facet with the normal N towards its tetrahedron, twice its area long, and an edge i j of it with
/// the opposite corner k,
///
///   a^2 = l^2 / 4,  b^2 = l^2 D^2 / (4 |N|^2),  h^2 = q^2 |N|^2,  a b h = w = l^2 D q / 4
///   l^2 = |p_j - p_i|^2,  D = (p_i - p_k).(p_j - p_k),  q = (C - p_i).N / |N|^2
///
/// A facet is locally Delaunay iff the heights q |N| of its two tetrahedra have a sum >= 0, so that
/// the pass certifies the triangulation too. The object keeps its memory from call to call.
///
/// Example usage:
///
///     EnergySums sums;
///     Energy energy;
///     const Suspects suspects = sums.run(tetrahedra, coordinates, frame, workers, energy);
///
/// Laws, tested by number:
///   (1) F is unchanged when any site moves by a lattice translation.
///   (2) The gradient sums to zero over the sites.
///   (3) The masses, which are volumes, sum to the volume of the domain.
///   (4) F / n is at least that of a ball of the volume V / n.
///   (5) Every bit is the same for any number of workers.
class EnergySums {
   public:
    EnergySums();
    ~EnergySums();
    EnergySums(const EnergySums&);
    EnergySums& operator=(const EnergySums&);

    /// @param coordinates  3 x n, reduced basis.
    Suspects run(const TorusTetrahedra& tetrahedra, const Points& coordinates, const Frame& frame,
                 Workers& workers, Energy& energy);

   private:
    struct Slab;
    void add_up(int n_sites, Workers& workers, Energy& energy) const;

    std::vector<Slab> slabs_;
    /// TetrahedronBlock::height of all tetrahedra.
    FacetHeights heights_;
};

/// Corrects an energy for exchanged tetrahedra, at a cost in proportion to their number.
///
/// Law, tested: the energy equals that of a pass over all tetrahedra to 1e-13.
///
/// @param exchanged  tetrahedra that were added and removed again may be in both lists.
/// @returns false, with an energy that must not be used, if the contribution of a tetrahedron is so
///          large that its rounding would show.
bool correct_for_exchange(ExchangedTetrahedra exchanged, const Points& coordinates,
                          const Frame& frame, Energy& energy);

}  // namespace pcvt::space
