#include "mesher/lloyd.hpp"

#include <algorithm>

#include "mesher/optimizer_run.hpp"

namespace pcvt {

OptimizerResult minimize_lloyd(const Objective& objective, const Eigen::VectorXd& start,
                               const OptimizerOptions& options) {
    OptimizerRun run(objective, options);
    Eigen::VectorXd x = start;
    Evaluation here;
    Evaluation there;
    if (!run.evaluate(x, here)) return run.finish(Stop::kStalled, x, here);
    for (;;) {
        if (const auto stop = run.before_iteration(here)) return run.finish(*stop, x, here);
        const double step = std::min(1.0, options.max_move / largest_move(here.lloyd_step));
        const Eigen::VectorXd trial = x + step * here.lloyd_step;
        if (!run.evaluate(trial, there)) return run.finish(Stop::kStalled, x, here);
        x = trial;
        std::swap(here, there);
    }
}

}  // namespace pcvt
