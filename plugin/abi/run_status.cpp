#include "plugin/abi/run_status.hpp"

#include "plugin/abi/guard.hpp"

namespace pcvt::abi {

std::int32_t stop_number(Stop stop) {
    if (stop == Stop::kConverged) return PCVT_STOP_CONVERGED;
    return stop == Stop::kIterationLimit ? PCVT_STOP_ITERATION_LIMIT : PCVT_STOP_STALLED;
}

std::int32_t minimum_number(const std::optional<Minimum>& minimum) {
    if (minimum == Minimum::kYes) return PCVT_MINIMUM_YES;
    return minimum == Minimum::kNo ? PCVT_MINIMUM_NO : PCVT_MINIMUM_UNKNOWN;
}

pcvt_status status_of(int max_iterations, const RunStatistics& run) {
    if (run.stop == Stop::kConverged || max_iterations == 0) return PCVT_OK;
    set_last_error(run.stop == Stop::kStalled
                       ? "not converged: double precision gives no more; take a larger tolerance"
                       : "not converged: the iteration limit came first");
    return PCVT_NOT_CONVERGED;
}

const std::int32_t* dropped_pairs(const DroppedSites& dropped) {
    static_assert(sizeof(CoincidentSite) == 2 * sizeof(std::int32_t));
    return dropped.sites.empty() ? nullptr : &dropped.sites.front().site;
}

pcvt_status cancelled_status() {
    set_last_error("cancelled by the progress callback");
    return PCVT_CANCELLED;
}

}  // namespace pcvt::abi
