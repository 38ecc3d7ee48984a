#include "mesher/plane/density/quadrature.hpp"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <cmath>

namespace pcvt::plane {
namespace {

TriangleRule conical_product(int q) {
    const GaussRule radial = gauss_rule(q, 1);
    const GaussRule across = gauss_rule(q, 0);
    TriangleRule rule;
    rule.outwards = radial.nodes;
    rule.across = across.nodes;
    rule.weights.resize(6, q * q);
    for (int i = 0; i < q; ++i) {
        for (int j = 0; j < q; ++j) {
            const double a = radial.nodes[i] * (1 - across.nodes[j]);
            const double b = radial.nodes[i] * across.nodes[j];
            const double w = radial.weights[i] * across.weights[j];
            rule.along_p.push_back(a);
            rule.along_r.push_back(b);
            rule.weights.col(i * q + j) << w, w * a, w * b, w * a * a, w * a * b, w * b * b;
        }
    }
    return rule;
}

std::vector<TriangleRule> all_triangle_rules() {
    std::vector<TriangleRule> rules;
    for (int q = kLeastOrder; q <= kGreatestOrder; ++q) rules.push_back(conical_product(q));
    return rules;
}

std::vector<GaussRule> all_line_rules() {
    std::vector<GaussRule> rules;
    for (int q = kLeastOrder; q <= kGreatestOrder; ++q) rules.push_back(gauss_rule(q, 0));
    return rules;
}

}  // namespace

GaussRule gauss_rule(int q, int power) {
    // The Jacobi polynomials of the weight (1 + t)^power on (-1, 1).
    const double b = power;
    Eigen::VectorXd diagonal(q);
    Eigen::VectorXd beside(q - 1);
    for (int k = 0; k < q; ++k) {
        const double s = 2 * k + b;
        diagonal[k] = k == 0 ? b / (b + 2) : b * b / (s * (s + 2));
        if (k == 0) continue;
        beside[k - 1] = 2 * k * (k + b) / (s * std::sqrt((s + 1) * (s - 1)));
    }
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, beside);
    GaussRule rule;
    for (int k = 0; k < q; ++k) {
        const double first = solver.eigenvectors()(0, k);
        rule.nodes.push_back((1 + solver.eigenvalues()[k]) / 2);
        rule.weights.push_back(first * first / (b + 1));
    }
    return rule;
}

const GaussRule& line_rule(int q) {
    assert(kLeastOrder <= q && q <= kGreatestOrder);
    static const std::vector<GaussRule> rules = all_line_rules();
    return rules[static_cast<std::size_t>(q - kLeastOrder)];
}

const TriangleRule& triangle_rule(int q) {
    assert(kLeastOrder <= q && q <= kGreatestOrder);
    static const std::vector<TriangleRule> rules = all_triangle_rules();
    return rules[static_cast<std::size_t>(q - kLeastOrder)];
}

}  // namespace pcvt::plane
