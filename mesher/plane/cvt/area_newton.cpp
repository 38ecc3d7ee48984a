#include "mesher/plane/cvt/area_newton.hpp"

#include "mesher/cvt/size_newton_definitions.hpp"

namespace pcvt {

template class SizeNewton<plane::PowerDiagram>;

}  // namespace pcvt
