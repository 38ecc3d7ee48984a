#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace pcvt::testing {

/// Computes the Hessian of a function of points column by column, from central differences of its
/// gradient.
/// @param points    d x n.
/// @param gradient  returns the d n numbers of the gradient at given points.
template <class Points, class Gradient>
Eigen::MatrixXd hessian_by_differences(Points points, double step, const Gradient& gradient) {
    Eigen::MatrixXd hessian(points.size(), points.size());
    for (Eigen::Index k = 0; k < points.size(); ++k) {
        const double there = points.reshaped()[k];
        points.reshaped()[k] = there + step;
        const Eigen::VectorXd after = gradient(points);
        points.reshaped()[k] = there - step;
        const Eigen::VectorXd before = gradient(points);
        points.reshaped()[k] = there;
        hessian.col(k) = (after - before) / (2 * step);
    }
    return (hessian + hessian.transpose()) / 2;
}

/// Returns the smallest eigenvalue over the largest, without those nearest to zero, as many as
/// there are translations.
inline double smallest_eigenvalue(const Eigen::MatrixXd& hessian, int n_translations) {
    Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues();
    const double largest = values[values.size() - 1];
    std::sort(values.begin(), values.end(),
              [](double x, double y) { return std::abs(x) < std::abs(y); });
    return values.tail(values.size() - n_translations).minCoeff() / largest;
}

}  // namespace pcvt::testing
