#include "mesher/plane/density/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pcvt::plane {
namespace {

/// The rule's integral of a^m b^n over the triangle (0, p, r), divided by cross(p, r).
double monomial(const TriangleRule& rule, int m, int n) {
    double sum = 0;
    for (int k = 0; k < rule.n_points(); ++k) {
        sum += rule.weights(0, k) * std::pow(rule.along_p[k], m) * std::pow(rule.along_r[k], n);
    }
    return sum;
}

double exact_monomial(int m, int n) {
    return std::tgamma(m + 1) * std::tgamma(n + 1) / std::tgamma(m + n + 3);
}

TEST(Quadrature, GaussRulesAreExactToTheirDegreeAndNoFurther) {
    for (int power = 0; power <= 1; ++power) {
        for (int q = kLeastOrder; q <= kGreatestOrder; ++q) {
            const GaussRule rule = gauss_rule(q, power);
            for (int degree = 0; degree <= 2 * q; ++degree) {
                double sum = 0;
                for (int k = 0; k < q; ++k) {
                    sum += rule.weights[k] * std::pow(rule.nodes[k], degree);
                }
                const double error = std::abs(sum * (degree + power + 1) - 1);
                if (degree < 2 * q) {
                    EXPECT_LT(error, 4e-14) << q << " " << degree;
                } else if (q < 8) {
                    EXPECT_GT(error, 1e-10) << q;
                }
            }
        }
    }
}

TEST(Quadrature, TriangleRulesAreExactToDegreeTwoQMinusOne) {
    for (int q = kLeastOrder; q <= kGreatestOrder; ++q) {
        const TriangleRule& rule = triangle_rule(q);
        ASSERT_EQ(rule.n_points(), q * q);
        for (int m = 0; m < 2 * q; ++m) {
            for (int n = 0; m + n < 2 * q; ++n) {
                EXPECT_NEAR(monomial(rule, m, n) / exact_monomial(m, n), 1, 1e-13)
                    << "q = " << q << ", " << m << ", " << n;
            }
        }
    }
}

TEST(Quadrature, PointsLieInsideAndWeightsArePositive) {
    for (int q = kLeastOrder; q <= kGreatestOrder; ++q) {
        const TriangleRule& rule = triangle_rule(q);
        for (int k = 0; k < rule.n_points(); ++k) {
            EXPECT_GT(rule.along_p[k], 0);
            EXPECT_GT(rule.along_r[k], 0);
            EXPECT_LT(rule.along_p[k] + rule.along_r[k], 1);
            EXPECT_GT(rule.weights(0, k), 0);
        }
    }
}

TEST(Quadrature, PointsLieOnRaysFromTheFirstCorner) {
    for (int q = kLeastOrder; q <= kGreatestOrder; ++q) {
        const TriangleRule& rule = triangle_rule(q);
        for (int k = 0; k < rule.n_points(); ++k) {
            const double outwards = rule.outwards[k / q];
            const double across = rule.across[k % q];
            EXPECT_DOUBLE_EQ(rule.along_p[k], outwards * (1 - across));
            EXPECT_DOUBLE_EQ(rule.along_r[k], outwards * across);
        }
    }
}

TEST(Quadrature, WeightsOfTheSecondDegreeMatchThePoints) {
    const TriangleRule& rule = triangle_rule(5);
    for (int k = 0; k < rule.n_points(); ++k) {
        const double a = rule.along_p[k];
        const double b = rule.along_r[k];
        Eigen::Matrix<double, 6, 1> powers;
        powers << 1, a, b, a * a, a * b, b * b;
        EXPECT_LT((rule.weights.col(k) - rule.weights(0, k) * powers).norm(), 1e-17);
    }
}

}  // namespace
}  // namespace pcvt::plane
