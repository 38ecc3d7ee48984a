#pragma once

#include "mesher/plane/density/quadrature_batch.hpp"

namespace pcvt::plane {

/// Cuts a convex polygon along one line; `below` receives the part with smaller coordinates.
///
///     cut(cell, 0, 0.5, left, right);  // along u = 1/2
///
/// @param axis  0: the line u = at; 1: the line v = at.
void cut(CellView polygon, int axis, double at, CellPolygon& below, CellPolygon& above);

}  // namespace pcvt::plane
