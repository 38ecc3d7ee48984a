#pragma once

#include <string>

#include "io/solvers/inp_form.hpp"

namespace pcvt {

/// Returns the text of an Abaqus or CalculiX input. Node v + 1 and element e + 1 are those of the
/// form; the control nodes follow the nodes. Empty sets are left out.
///
/// Two equations in the plane, and three in space, tie a node to its representative r, with the
/// translation T and the mean strain e, a tensor:
///
///     u_i(node) - u_i(r) - sum_j T_j e_ij = 0
///
/// The displacement of control node 1 holds e_xx, e_xy, e_xz, that of node 2 e_yy, e_yz in its
/// components 2 and 3, and that of node 3 e_zz in its component 3.
///
/// @param path  for messages.
/// @throws InvalidInput  where 20 characters cannot hold the numbers in this unit of length.
std::string inp_text(const InpForm& form, const std::string& path);

}  // namespace pcvt
