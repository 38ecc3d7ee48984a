#include "plugin/abi/density.hpp"

#include <limits>

#include "mesher/density_breaks.hpp"
#include "plugin/job_density.hpp"

namespace pcvt::abi {
namespace {

double ask_host(const pcvt_options& options, const std::fenv_t& host, const DensityPoint& point) {
    const double position[2] = {point.x, point.y};
    double value = std::numeric_limits<double>::quiet_NaN();
    const int refusal = call_host("density", host, [&] {
        return options.density(position, 1, &value, options.density_data);
    });
    if (refusal != 0) {
        throw CallbackFault("the density callback returned " + std::to_string(refusal));
    }
    return value;
}

std::optional<GreyRange> range_of(const pcvt_options& options) {
    const double* range = options.density_range;
    if (range[0] == 0 && range[1] == 0) return std::nullopt;
    return GreyRange{range[0], range[1]};
}

}  // namespace

void set_density(const pcvt_options& options, const std::fenv_t& host, Job& job) {
    const std::optional<GreyRange> range = range_of(options);
    if (options.density == nullptr && options.density_source == nullptr) {
        if (range) throw InvalidInput("density_range without density_source; leave one out");
        return;
    }
    if (options.density == nullptr) {
        job.density_name = options.density_source;
        job.density = source_density(job.density_name, range, job.lattice);
        return;
    }
    if (options.density_source != nullptr || range) {
        throw InvalidInput("density excludes density_source and density_range; leave one out");
    }
    job.n_threads = 1;
    job.density_name = "callback";
    const Density density{[&options, &host] {
        return
            [&options, &host](const DensityPoint& point) { return ask_host(options, host, point); };
    }};
    job.density = with_axis_breaks(job.lattice, density);
}

}  // namespace pcvt::abi
