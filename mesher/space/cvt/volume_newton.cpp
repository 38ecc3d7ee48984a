#include "mesher/space/cvt/volume_newton.hpp"

#include "mesher/cvt/size_newton_definitions.hpp"

namespace pcvt {

template class SizeNewton<space::PowerDiagram>;

}  // namespace pcvt
