#pragma once

#include <array>

#include "mesher/space/delaunay/frame.hpp"

namespace pcvt::space {

/// The contributions of one tetrahedron to the cells of a power diagram, the quantities of
/// PowerBlock, computed with the digits of WideDouble from its exact orthocentre.
///
/// Corners that are much closer to each other than the cells are long give planes between cells
/// whose directions and places doubles lose. Each product below stays as small as its factors
/// allow: where the edge i j is the shortest of its triangle, B is computed from differences of
/// weights that are small with it,
///
///   B  =  l^2 (D_k + w_j - w_k) + D_j (w_i - w_j).
struct ThinTerms {
    /// The volume at each corner.
    std::array<double, 4> volume{};
    /// In the order of PowerBlock::kEdges.
    std::array<double, 6> conductance{};
    /// The gradient at each corner, and the energy.
    std::array<Vec3, 4> gradient{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    double value = 0;
};

/// @param corner  corners 1, 2 and 3 relative to corner 0, coordinates of the reduced basis.
/// @param weight  of the four corners, in the unit of `frame`.
ThinTerms thin_terms(const std::array<Vec3, 3>& corner, const std::array<double, 4>& weight,
                     const Frame& frame);

}  // namespace pcvt::space
