#include "mesher/cells/cell_table.hpp"

#include <cmath>
#include <numbers>

namespace pcvt {

double CellTable::equivalent_diameter(SiteId s) const {
    return 2 * std::sqrt(measure[s] / std::numbers::pi);
}

double CellTable::circularity(SiteId s) const {
    return 2 * std::sqrt(std::numbers::pi * measure[s]) / surface[s];
}

}  // namespace pcvt
