#include "mesher/cvt/size_summary.hpp"

#include <cmath>
#include <numeric>
#include <span>

#include "mesher/cells/target_areas.hpp"

namespace pcvt {
namespace {

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

}  // namespace

SizeSummary size_summary(const SizeFigures& newton, const CellTable& cells,
                         const Eigen::VectorXd& given, double total) {
    std::vector<double> roundness;
    for (SiteId s = 0; s < cells.n_cells(); ++s) roundness.push_back(cells.roundness(s));
    SizeSummary summary{.newton = newton};
    summary.roundness_mean = mean(roundness);
    for (double& r : roundness) r = (r - summary.roundness_mean) * (r - summary.roundness_mean);
    summary.roundness_std = std::sqrt(mean(roundness));
    summary.std_over_mean =
        diameter_spread(Eigen::Map<const Eigen::VectorXd>(
                            cells.measure.data(), static_cast<Eigen::Index>(cells.measure.size())),
                        cells.dimension);
    if (given.size() > 0) summary.scale = area_scale(given, total);
    return summary;
}

}  // namespace pcvt
