#include "mesher/cells/cell_table.hpp"

#include <cmath>
#include <numbers>

#include "mesher/portable/portable_functions.hpp"

namespace pcvt {

double CellTable::equivalent_diameter(SiteId s) const {
    if (dimension == 3) return portable_cbrt(6 * measure[s] / std::numbers::pi);
    return 2 * std::sqrt(measure[s] / std::numbers::pi);
}

double CellTable::roundness(SiteId s) const {
    if (dimension == 3) {
        const double diameter = equivalent_diameter(s);
        return std::numbers::pi * diameter * diameter / surface[s];
    }
    return 2 * std::sqrt(std::numbers::pi * measure[s]) / surface[s];
}

}  // namespace pcvt
