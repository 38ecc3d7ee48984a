#include "mesher/space/cvt/hessian.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesher/space/delaunay/periodic_delaunay.hpp"
#include "mesher/space/energy/energy.hpp"
#include "tests/support/space_families.hpp"

namespace pcvt::space {
namespace {

Frame frame_of(const Sites& sites) { return {sites.reduction().reduced, 1}; }

/// The matrix with x, y and z of each site as rows; the entries that are not used are checked.
Eigen::MatrixXd dense_hessian(const Sites& sites) {
    BlockMatrix hessian;
    assemble_hessian(periodic_delaunay(sites).tetrahedra, sites.coordinates(), frame_of(sites),
                     hessian);
    Workers workers(1);
    const Eigen::Index n = sites.n_sites();
    EXPECT_EQ(hessian.n_rows(), 2 * n);
    Eigen::MatrixXd all(4 * n, 4 * n);
    for (Eigen::Index k = 0; k < 4 * n; ++k) {
        Eigen::VectorXd column(4 * n);
        hessian.multiply(Eigen::VectorXd::Unit(4 * n, k), column, workers);
        all.col(k) = column;
    }
    Eigen::MatrixXd dense(3 * n, 3 * n);
    const double unused = 2 * frame_of(sites).volume() / double(n);
    for (Eigen::Index s = 0; s < n; ++s) {
        EXPECT_EQ(all.row(4 * s + 3), unused * Eigen::RowVectorXd::Unit(4 * n, 4 * s + 3));
        EXPECT_EQ(all.col(4 * s + 3), unused * Eigen::VectorXd::Unit(4 * n, 4 * s + 3));
        for (Eigen::Index t = 0; t < n; ++t) {
            dense.block<3, 3>(3 * s, 3 * t) = all.block<3, 3>(4 * s, 4 * t);
        }
    }
    return dense;
}

Eigen::VectorXd gradient_at(const Sites& sites, const Points& coordinates) {
    const Sites moved(sites.lattice(), sites.reduction(), coordinates);
    Workers workers(1);
    Energy energy;
    EnergySums().run(periodic_delaunay(moved).tetrahedra, moved.coordinates(), frame_of(sites),
                     workers, energy);
    return energy.gradient.reshaped(MovingTetrahedra::kNumbersPerSite, sites.n_sites())
        .topRows(3)
        .reshaped();
}

/// Law (1).
TEST(SpaceHessian, IsTheDerivativeOfTheGradient) {
    std::mt19937_64 random(4);
    for (int job = 0; job < 30; ++job) {
        const Lattice lattice = testing::random_space_lattice(random);
        const int n = 2 + int(random() % 10);
        const Sites sites(lattice, uniform_points(lattice, n, random()));
        const Eigen::MatrixXd hessian = dense_hessian(sites);
        const Frame frame = frame_of(sites);
        const double step = 1e-6 * sites.spacing();
        Points coordinates = sites.coordinates();
        for (Eigen::Index k = 0; k < coordinates.size(); k += 2) {
            const Eigen::Index site = k / 3;
            const Vec3 there = coordinates.col(site);
            const auto gradient = [&](double t) {
                const Vec3 move = frame.to_lattice(t * Vec3::Unit(k % 3));
                coordinates.col(site) = there + snapped_displacement(move);
                return gradient_at(sites, coordinates);
            };
            const Eigen::VectorXd difference = (gradient(step) - gradient(-step)) / (2 * step);
            coordinates.col(site) = there;
            EXPECT_LT((difference - hessian.col(k)).norm(), 2e-5 * hessian.norm()) << job;
        }
    }
}

/// Laws (2) and (3), ties included.
TEST(SpaceHessian, IsSymmetricAndIgnoresTranslations) {
    for (const auto& [name, sites] : testing::space_site_families(5)) {
        if (sites.n_sites() > 8) continue;
        SCOPED_TRACE(name);
        const Eigen::MatrixXd hessian = dense_hessian(sites);
        EXPECT_EQ(hessian, hessian.transpose());
        const Eigen::Index n = sites.n_sites();
        for (int axis = 0; axis < 3; ++axis) {
            Eigen::VectorXd translation = Eigen::VectorXd::Zero(3 * n);
            for (Eigen::Index s = 0; s < n; ++s) translation[3 * s + axis] = 1;
            EXPECT_LE((hessian * translation).norm(), 1e-6 * hessian.norm());
        }
    }
}

}  // namespace
}  // namespace pcvt::space
