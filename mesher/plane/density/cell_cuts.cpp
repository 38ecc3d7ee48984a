#include "mesher/plane/density/cell_cuts.hpp"

namespace pcvt::plane {

void cut(CellView polygon, int axis, double at, CellPolygon& below, CellPolygon& above) {
    below.clear();
    above.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const CellCorner& from = polygon[k];
        const CellCorner& to = polygon[k + 1 == polygon.size() ? 0 : k + 1];
        const double before = from.lattice[axis] - at;
        const double after = to.lattice[axis] - at;
        if (before <= 0) below.push_back(from);
        if (before >= 0) above.push_back(from);
        if (!((before < 0 && after > 0) || (before > 0 && after < 0))) continue;
        const double part = before / (before - after);
        CellCorner corner{from.plane + part * (to.plane - from.plane),
                          from.lattice + part * (to.lattice - from.lattice)};
        corner.lattice[axis] = at;
        below.push_back(corner);
        above.push_back(corner);
    }
}

}  // namespace pcvt::plane
