#pragma once

namespace pcvt {

/// Why a run ended.
enum class Stop { kConverged, kIterationLimit, kStalled, kCancelled };

/// Its word in reports and messages: "converged", "iteration-limit", "stalled", "cancelled".
constexpr const char* stop_name(Stop stop) {
    switch (stop) {
        case Stop::kConverged:
            return "converged";
        case Stop::kIterationLimit:
            return "iteration-limit";
        case Stop::kStalled:
            return "stalled";
        case Stop::kCancelled:
            return "cancelled";
    }
    return "";
}

/// The figures of an optimisation. The optimisers fill them in, and every result that reports a run
/// holds them as its member `run`.
///
///   const CvtResult result = compute_cvt(lattice, points, {});
///   std::printf("%d iterations, energy %g\n", result.run.iterations, result.run.energy);
struct RunStatistics {
    Stop stop = Stop::kStalled;
    int iterations = 0;
    int evaluations = 0;
    /// Hessians and products with them. Only Newton's method needs them; evaluations do not include
    /// them.
    int hessians = 0;
    int cg_products = 0;
    /// The value of the objective at the end: of a CVT the energy F, density x length^4.
    double energy = 0;
    /// Maximum and RMS of the residuals: for a CVT, of |x_i - g_i| / h. The run converges when
    /// `residual` <= tolerance.
    double residual = 0;
    double rms_residual = 0;

    /// Adds the counts of a run that came before this one.
    void add_counts(const RunStatistics& before) {
        iterations += before.iterations;
        evaluations += before.evaluations;
        hessians += before.hessians;
        cg_products += before.cg_products;
    }
};

}  // namespace pcvt
