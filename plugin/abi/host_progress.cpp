#include "plugin/abi/host_progress.hpp"

#include "plugin/abi/guard.hpp"
#include "plugin/abi/progress_sites.hpp"

namespace pcvt::abi {
namespace {

/// The numbers of the published interface never change.
static_assert(static_cast<int>(Phase::kStarting) == PCVT_PHASE_START);
static_assert(static_cast<int>(Phase::kOptimising) == PCVT_PHASE_OPTIMISE);
static_assert(static_cast<int>(Phase::kBuilding) == PCVT_PHASE_BUILD);
static_assert(static_cast<int>(Phase::kProving) == PCVT_PHASE_PROVE);
static_assert(static_cast<int>(Phase::kWriting) == PCVT_PHASE_WRITE);

/// Whether the host wants the run to continue.
bool report_progress(const HostProgress& to, double energy_bound, const JobProgress& progress,
                     const std::fenv_t& host) {
    const pcvt_progress view{.struct_size = sizeof view,
                             .iteration = progress.run.iteration,
                             .evaluations = progress.run.evaluations,
                             .energy = progress.run.value,
                             .energy_bound = energy_bound,
                             .residual = progress.run.residual,
                             .rms_residual = progress.run.rms_residual,
                             .phase = static_cast<std::int32_t>(progress.phase),
                             .reserved = 0,
                             .fraction = progress.fraction,
                             .phase_text = progress.text.c_str()};
    const ProgressSites sites(to.job, progress.run);
    return call_host("progress", host, [&] { return to.call(&view, to.data); }) == 0;
}

}  // namespace

JobCallback job_callback(const HostProgress& to, double energy_bound, const std::fenv_t& host) {
    if (to.call == nullptr) return {};
    return [=, &host](const JobProgress& progress) {
        return report_progress(to, energy_bound, progress, host);
    };
}

}  // namespace pcvt::abi
