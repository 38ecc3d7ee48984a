#pragma once

#include <optional>

#include "mesher/cells/cell_table.hpp"
#include "mesher/cvt/size_newton.hpp"

namespace pcvt {

/// The figures of a run with prescribed areas or volumes.
struct SizeSummary {
    SizeFigures newton;
    /// The factor that took given sizes to the size of the domain; `nullopt` for those of a law.
    std::optional<double> scale = {};
    /// Standard deviation over mean of the equivalent diameters.
    double std_over_mean = 0;
    /// Mean and standard deviation over the cells of CellTable::roundness().
    double roundness_mean = 0;
    double roundness_std = 0;
};

/// Example usage:
///   const SizeSummary summary = size_summary(figures, cells.table(), given, lattice.volume());
///
/// @param given  the sizes that scaled_areas() or scaled_volumes() took; empty for those of a law.
/// @param total  the size of the domain.
SizeSummary size_summary(const SizeFigures& newton, const CellTable& cells,
                         const Eigen::VectorXd& given, double total);

}  // namespace pcvt
