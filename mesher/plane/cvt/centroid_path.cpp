#include "mesher/plane/cvt/centroid_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mesher/optimize/conjugate_gradients.hpp"

namespace pcvt::plane {
namespace {

/// c at first, the factor from one c to the next, and its least value, where the last steps were
/// full ones.
constexpr double kFirstPull = 1;
constexpr double kLessPull = 0.5;
constexpr double kLeastFactor = 1e-3;
/// The minimum of P_c is found once the RMS slope is below this multiple of c h.
constexpr double kSolved = 0.05;
constexpr int kMostSteps = 20;
constexpr int kFewSteps = 2;
/// The centroids come nearer if the typical distance falls below this part of that of the last c.
constexpr double kNearer = 0.8;
constexpr int kMostWithoutGain = 2;
/// No edge between two sites loses more than this part of its length in a step.
constexpr double kMostLost = 0.8;
/// The linear equations of a step are solved to the RMS residual, within these limits.
constexpr double kExactStep = 1e-4;
constexpr double kLooseStep = 1e-2;
constexpr int kMostProducts = 2000;

/// Adds a block of the second derivatives by x_at - x_other to the rows of x_at.
void add_to_row(SiteId at, SiteId other, const Eigen::Matrix2d& part, BlockMatrix& matrix) {
    const auto row = matrix.column.begin() + matrix.row_begin[2 * at];
    const auto end = matrix.column.begin() + matrix.row_begin[2 * at + 1];
    const auto place = std::find(row, end, 2 * other);
    // Cells without a common side have no block; twice the diagonal bounds it.
    const double times = place == end ? 2 : 1;
    for (int k = 0; k < 4; ++k) {
        const double entry = part(k % 2, k / 2);
        matrix.diagonal[2 * at][k] += times * entry;
        if (place == end) continue;
        matrix.block[place - matrix.column.begin()][k] -= static_cast<float>(entry);
    }
}

/// Adds c times the second derivatives of the other terms of P_c.
void add_pull(const CentroidPathObjective& objective, BlockMatrix& matrix) {
    const double pull = objective.pull();
    for (SiteId s = 0; s < objective.moving().n_sites(); ++s) {
        matrix.diagonal[2 * s][0] += pull * objective.sizes()[s];
        matrix.diagonal[2 * s][3] += pull * objective.sizes()[s];
    }
    for (const SitePair<2>& pair : objective.pairs()) {
        const double weight = pull * objective.repulsion(pair);
        if (weight == 0) continue;
        const double r2 = pair.apart.squaredNorm();
        const Eigen::Matrix2d part = weight * (1 / objective.reach_squared() + 1 / r2) / r2 *
                                     pair.apart * pair.apart.transpose();
        add_to_row(pair.from, pair.to, part, matrix);
        add_to_row(pair.to, pair.from, part, matrix);
    }
}

class CentroidPath {
   public:
    CentroidPath(CentroidPathObjective& objective, const OptimizerOptions& options)
        : objective_(objective),
          run_(objective, options),
          direction_(Eigen::VectorXf::Zero(objective.n_variables())) {}

    RunStatistics follow() {
        double pull = kFirstPull;
        double last = std::numeric_limits<double>::infinity();
        for (int without_gain = 0; without_gain < kMostWithoutGain;) {
            objective_.set_pull(pull);
            if (!run_.evaluate(direction_, 0, here_)) break;
            if (const auto stop = solve()) return run_.finish(*stop, here_).run;
            // Some small cells come near last.
            const double misfit = objective_.typical_misfit();
            without_gain = misfit > kNearer * last ? without_gain + 1 : 0;
            last = misfit;
            factor_ = is_easy_ ? std::max(factor_ * factor_, kLeastFactor) : kLessPull;
            pull *= factor_;
        }
        return run_.finish(Stop::kStalled, here_).run;
    }

   private:
    /// Goes to the minimum for the present c.
    std::optional<Stop> solve() {
        is_easy_ = true;
        for (int k = 0; k < kMostSteps; ++k) {
            if (const auto stop = run_.before_iteration(here_)) return stop;
            const bool is_solved = objective_.rms_slope() <= kSolved * objective_.pull();
            if (k > 0 && is_solved) break;
            if (k == kFewSteps) is_easy_ = false;
            if (!find_step()) return Stop::kStalled;
            const auto t = search_slopes(run_, direction_, longest_step(), here_);
            if (!t) {
                run_.evaluate(direction_, 0, here_);
                return Stop::kStalled;
            }
            if (*t < 1) is_easy_ = false;
            run_.accept();
        }
        return std::nullopt;
    }

    /// Computes Newton's step: to first order the areas stay and the slope vanishes.
    bool find_step() {
        if (!objective_.return_to_point()) return false;
        const PowerDiagram& diagram = objective_.newton().diagram();
        BlockMatrix matrix;
        assemble_moment_derivatives(diagram.regular(), diagram.heights(),
                                    objective_.moving().spacing(), matrix);
        add_pull(objective_, matrix);
        // Each site has two numbers, then two for its weight.
        const int n = objective_.moving().n_sites();
        Eigen::VectorXd slope = Eigen::VectorXd::Zero(4 * Eigen::Index{n});
        for (SiteId s = 0; s < n; ++s) {
            slope.segment<2>(4 * s) = here_.gradient.segment<2>(2 * s) / 2;
        }
        ConjugateGradients solver(slope.size(), objective_.workers());
        solver.solve(matrix, slope,
                     {.relative_residual = std::clamp(here_.rms_residual, kExactStep, kLooseStep),
                      .radius = std::numeric_limits<double>::max(),
                      .products = kMostProducts});
        for (SiteId s = 0; s < n; ++s) {
            direction_.segment<2>(2 * s) = solver.solution().segment<2>(4 * s).cast<float>();
        }
        return direction_.allFinite();
    }

    /// The step at which the first edge has lost the part kMostLost of its length.
    double longest_step() const {
        double fastest = 0;
        for (const SitePair<2>& pair : objective_.pairs()) {
            const Vec2 change =
                (direction_.segment<2>(2 * pair.to) - direction_.segment<2>(2 * pair.from))
                    .cast<double>();
            fastest = std::max(fastest, -pair.apart.dot(change) / pair.apart.squaredNorm());
        }
        return kMostLost / fastest;
    }

    CentroidPathObjective& objective_;
    OptimizerRun run_;
    Evaluation here_;
    Eigen::VectorXf direction_;
    double factor_ = kLessPull;
    /// Whether few full steps led to the last minimum.
    bool is_easy_ = true;
};

}  // namespace

RunStatistics follow_centroid_path(CentroidPathObjective& objective, const RunOptions& run) {
    const OptimizerOptions options = centroid_options(objective.moving(), run);
    return CentroidPath(objective, options).follow();
}

}  // namespace pcvt::plane
