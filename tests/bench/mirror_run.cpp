#include "tests/bench/mirror_run.hpp"

#include <cmath>

#include "mesher/optimize/lbfgs.hpp"
#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "mesher/plane/delaunay/predicates.hpp"
#include "mesher/plane/energy/triangle_terms.hpp"

namespace pcvt::bench {
namespace {

/// The energy from the mirror diagram; the point is a vector of positions in the plane. The reduced
/// basis must be a rectangle along x and y, so that the frame equals the plane.
class MirrorObjective final : public Objective {
   public:
    MirrorObjective(const plane::Lattice& lattice, const plane::Points& points)
        : lattice_(lattice), here_(points), there_(points) {}

    Eigen::Index n_variables() const override { return here_.size(); }

    bool evaluate(const Eigen::VectorXf& direction, double t, Evaluation& evaluation) override {
        there_ = here_;
        if (t != 0) there_.reshaped() += t * direction.cast<double>();
        const plane::Sites sites(lattice_, there_);
        const auto n = static_cast<Eigen::Index>(sites.n_sites());
        mass_.setZero(n);
        evaluation.gradient.setZero(2 * n);
        evaluation.value = 0;
        for (const plane::Triangle& triangle : mirror_diagram(sites).triangles) {
            add(sites, triangle, evaluation);
        }
        const plane::Points residuals =
            evaluation.gradient.reshaped(2, n).array().rowwise() / (2 * mass_.transpose().array());
        evaluation.residual = residuals.colwise().norm().maxCoeff() / sites.spacing();
        evaluation.rms_residual = residuals.norm() / std::sqrt(double(n)) / sites.spacing();
        return true;
    }
    void accept() override { here_ = there_; }
    void lloyd_step(const Evaluation& evaluation, Eigen::VectorXf& direction) const override {
        direction = (evaluation.gradient.reshaped(2, mass_.size()).array().rowwise() /
                     (-2 * mass_.transpose().array()))
                        .reshaped()
                        .cast<float>();
    }

   private:
    void add(const plane::Sites& sites, const plane::Triangle& triangle, Evaluation& evaluation) {
        const auto corner = [&](int k) {
            return image(sites, triangle[k].site, triangle[k].offset);
        };
        const plane::ReducedFrame frame{sites.reduction().reduced.a().x(), 0,
                                        sites.reduction().reduced.b().y()};
        const plane::TriangleTerms terms = triangle_terms(difference(corner(0), corner(1)),
                                                          difference(corner(0), corner(2)), frame);
        evaluation.value += terms.value;
        for (int k = 0; k < 3; ++k) {
            evaluation.gradient.segment<2>(2 * Eigen::Index{triangle[k].site}) += terms.gradient[k];
            mass_[triangle[k].site] += terms.mass[k];
        }
    }

    plane::Lattice lattice_;
    plane::Points here_;
    plane::Points there_;
    Eigen::VectorXd mass_;
};

}  // namespace

OptimizerResult mirror_run(const plane::Lattice& lattice, const plane::Points& points, double rms) {
    constexpr double kLargestMove = 0.5;
    const double h = std::sqrt(lattice.area() / double(points.cols()));
    MirrorObjective objective(lattice, points);
    Workers workers(1);
    OptimizerOptions options;
    options.tolerance = 0;
    options.max_move = kLargestMove * h;
    options.progress = [&](const Progress& progress) { return progress.rms_residual > rms; };
    return minimize_lbfgs(objective, options, workers);
}

}  // namespace pcvt::bench
