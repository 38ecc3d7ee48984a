#pragma once

#include <Eigen/Core>
#include <vector>

namespace pcvt::plane {

/// Limits of the order of a rule, which is its number of points along each direction.
inline constexpr int kLeastOrder = 2;
inline constexpr int kGreatestOrder = 12;

/// Nodes in (0, 1), ascending, and weights for the integral of s^power f(s) over (0, 1), power 0 or
/// 1: Gauss-Legendre or Gauss-Jacobi, exact for polynomials f of degree 2 q - 1. Computed from the
/// recurrence of the orthogonal polynomials (G. H. Golub, J. H. Welsch 1969).
struct GaussRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};
GaussRule gauss_rule(int q, int power);
/// The Gauss-Legendre rule on (0, 1), computed once.
/// @param q  kLeastOrder ... kGreatestOrder.
const GaussRule& line_rule(int q);

/// A rule of q x q points for triangles (0, p, r): the conical product of Gauss rules (A. H. Stroud
/// 1971, section 2.4; also known as Duffy's transformation, M. G. Duffy 1982).
///
///   integral of f = cross(p, r) sum_k weight_k f(along_p[k] p + along_r[k] r)
///
/// Exact for polynomials of degree 2 q - 1. All weights are positive and sum to 1/2. The points lie
/// on q rays from 0: point i q + j is outwards[i] ((1 - across[j]) p + across[j] r).
struct TriangleRule {
    std::vector<double> outwards;
    std::vector<double> across;
    std::vector<double> along_p;
    std::vector<double> along_r;
    /// Column k holds the weight times 1, a, b, a^2, a b, b^2, with a = along_p[k] and b =
    /// along_r[k]: the factors for the moments of rho up to second degree.
    Eigen::Matrix<double, 6, Eigen::Dynamic> weights;

    int n_points() const { return static_cast<int>(weights.cols()); }
};

/// @param q  kLeastOrder ... kGreatestOrder.
const TriangleRule& triangle_rule(int q);

}  // namespace pcvt::plane
