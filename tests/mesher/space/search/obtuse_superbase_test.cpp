#include "mesher/space/search/obtuse_superbase.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "mesher/base/error.hpp"

namespace pcvt::space {
namespace {

const std::array<LatticeVector, 3> kUnits{LatticeVector::UnitX(), LatticeVector::UnitY(),
                                          LatticeVector::UnitZ()};

Eigen::Matrix3d random_basis(std::mt19937& random) {
    std::uniform_real_distribution<double> entry(-1, 1);
    for (;;) {
        const Eigen::Matrix3d basis = Eigen::Matrix3d::NullaryExpr([&] { return entry(random); });
        if (std::abs(basis.determinant()) > 1e-3) return basis;
    }
}

Eigen::Matrix3d of_volume_1(const Eigen::Matrix3d& basis) {
    return basis / std::cbrt(std::abs(basis.determinant()));
}

double moment_of(const Eigen::Matrix3d& basis) {
    const Eigen::Matrix3d metric = of_volume_1(basis).transpose() * of_volume_1(basis);
    return second_moment(obtuse_superbase(kUnits, metric), metric);
}

/// The mean of |x|^2 / 3 over the Voronoi cell, by the midpoint rule over one period.
double sampled_moment(const Eigen::Matrix3d& basis, int steps) {
    double sum = 0;
    for (int k = 0; k < steps * steps * steps; ++k) {
        const Eigen::Vector3d u((k % steps + 0.5) / steps, (k / steps % steps + 0.5) / steps,
                                (k / steps / steps + 0.5) / steps);
        double nearest = 1e300;
        for (int o = 0; o < 216; ++o) {
            const Eigen::Vector3d offset(o % 6 - 2, o / 6 % 6 - 2, o / 36 - 2);
            nearest = std::min(nearest, (basis * (u - offset)).squaredNorm());
        }
        sum += nearest;
    }
    return sum / 3 / steps / steps / steps;
}

/// Law (1).
TEST(ObtuseSuperbase, HasNoAcuteAngleAndSpansTheLattice) {
    std::mt19937 random(1);
    for (int k = 0; k < 2000; ++k) {
        Eigen::Matrix3d basis = random_basis(random);
        // Long and oblique ones too.
        if (k % 2 == 1) basis.col(2) += (k * 37.0) * basis.col(0) - (k * 11.0) * basis.col(1);
        const Eigen::Matrix3d metric = basis.transpose() * basis;
        const auto v = obtuse_superbase(kUnits, metric);
        EXPECT_EQ(v[0] + v[1] + v[2] + v[3], LatticeVector(0, 0, 0));
        Eigen::Matrix3d columns;
        double longest = 0;
        for (int i = 0; i < 4; ++i) {
            if (i < 3) columns.col(i) = v[i].cast<double>();
            longest = std::max(longest, v[i].cast<double>().dot(metric * v[i].cast<double>()));
        }
        EXPECT_NEAR(std::abs(columns.determinant()), 1, 1e-6);
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < i; ++j) {
                const Eigen::Vector3d p = v[i].cast<double>();
                const Eigen::Vector3d q = v[j].cast<double>();
                const double rounding = 1e-15 * p.cwiseAbs().dot(metric.cwiseAbs() * q.cwiseAbs());
                EXPECT_LE(p.dot(metric * q), 1e-12 * longest + rounding);
            }
        }
    }
}

TEST(ObtuseSuperbase, RefusesMetricsOfDependentVectors) {
    // Rounding can make the square of a long thin combination negative.
    Eigen::Matrix3d metric;
    metric << 1, 1.2, 0, 1.2, 1, 0, 0, 0, 1;
    EXPECT_THROW(obtuse_superbase(kUnits, metric), InvalidInput);
}

TEST(SecondMoment, IsThatOfTheKnownLattices) {
    Eigen::Matrix3d fcc;
    fcc << 0, 1, 1, 1, 0, 1, 1, 1, 0;
    Eigen::Matrix3d bcc;
    bcc << -1, 1, 1, 1, -1, 1, 1, 1, -1;
    EXPECT_NEAR(moment_of(Eigen::Matrix3d::Identity()), 1.0 / 12, 1e-15);
    EXPECT_NEAR(moment_of(fcc), std::pow(2, -11.0 / 3), 1e-15);
    EXPECT_NEAR(moment_of(bcc), 19 / (192 * std::cbrt(2)), 1e-15);
    // A brick: the mean of the moments along its axes.
    const Eigen::Vector3d sides(1, 2, 5);
    EXPECT_NEAR(moment_of(sides.asDiagonal()),
                sides.squaredNorm() / 36 / std::pow(sides.prod(), 2.0 / 3), 1e-14);
}

TEST(SecondMoment, IsTheMeanSquareOverTheVoronoiCell) {
    std::mt19937 random(2);
    for (int k = 0; k < 12; ++k) {
        const Eigen::Matrix3d basis = of_volume_1(random_basis(random));
        const Eigen::Matrix3d metric = basis.transpose() * basis;
        const auto v = obtuse_superbase(kUnits, metric);
        Eigen::Matrix3d reduced;
        for (int i = 0; i < 3; ++i) reduced.col(i) = basis * v[i].cast<double>();
        const double moment = second_moment(v, metric);
        EXPECT_NEAR(sampled_moment(reduced, 24) / moment, 1, 0.01) << k;
    }
}

}  // namespace
}  // namespace pcvt::space
