#include "plugin/abi/density.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "mesher/plane/density/density_breaks.hpp"
#include "plugin/job/job_density.hpp"

namespace pcvt::abi {
namespace {

/// The density of a host's callback.
class HostDensity {
   public:
    HostDensity(const pcvt_options& options, const std::fenv_t& host)
        : options_(options), host_(host) {}

    void operator()(std::span<const plane::DensityPoint> points, std::span<double> rho) {
        positions_.clear();
        for (const plane::DensityPoint& point : points) {
            positions_.push_back(point.x);
            positions_.push_back(point.y);
        }
        std::fill(rho.begin(), rho.end(), std::numeric_limits<double>::quiet_NaN());
        const int refusal = call_host("density", host_, [&] {
            return options_.density(positions_.data(), points.size(), rho.data(),
                                    options_.density_data);
        });
        if (refusal == 0) return;
        throw CallbackFault("the density callback returned " + std::to_string(refusal));
    }

   private:
    const pcvt_options& options_;
    const std::fenv_t& host_;
    std::vector<double> positions_;
};

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
    job.run.n_threads = 1;
    job.density_name = "callback";
    const plane::Density density{[&options, &host] { return HostDensity(options, host); }};
    job.density = with_axis_breaks(job.lattice, density);
}

}  // namespace pcvt::abi
