#include "mesher/optimize/lloyd.hpp"

#include <algorithm>

#include "mesher/optimize/optimizer_run.hpp"

namespace pcvt {

OptimizerResult minimize_lloyd(Objective& objective, const OptimizerOptions& options) {
    OptimizerRun run(objective, options);
    Eigen::VectorXf step;
    Evaluation here;
    Evaluation there;
    if (!run.evaluate(step, 0, here)) return run.finish(Stop::kStalled, here);
    for (;;) {
        if (const auto stop = run.before_iteration(here)) return run.finish(*stop, here);
        objective.lloyd_step(here, step);
        const double t = std::min(1.0, options.max_move / largest_move(step));
        if (!run.evaluate(step, t, there)) {
            run.reject();
            return run.finish(Stop::kStalled, here);
        }
        run.accept();
        std::swap(here, there);
    }
}

}  // namespace pcvt
