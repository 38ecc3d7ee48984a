#include "mesher/space/search/lattice_stability.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt::space {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A vector that crosses a facet, in n-ths of the reduced period vectors, and its matrix K_v, with
/// lengths in units of the width of a cell.
struct Bond {
    LatticeVector steps;
    Matrix3d stiffness;
};

/// An obtuse superbase, whose last vector is minus the sum of the others, in both coordinates.
struct Superbase {
    std::array<LatticeVector, 4> steps;
    Eigen::Matrix<double, 3, 4> vectors;
    /// Column i has the product 1 with vector i and 0 with the other two of the first three.
    Matrix3d dual;

    explicit Superbase(const LatticePattern& pattern) {
        const Matrix3d basis = pattern.basis / portable_cbrt(pattern.basis.determinant());
        std::copy(pattern.steps.begin(), pattern.steps.end(), steps.begin());
        steps[3] = -(steps[0] + steps[1] + steps[2]);
        vectors << basis, -basis.rowwise().sum();
        dual = basis.inverse().transpose();
    }

    /// The vector p_ij z_ij of a segment.
    Vector3d segment(int i, int j) const {
        const double parameter = -vectors.col(i).dot(vectors.col(j));
        const Vector3d zero = Vector3d::Zero();
        return parameter *
               ((i < 3 ? dual.col(i).eval() : zero) - (j < 3 ? dual.col(j).eval() : zero));
    }
};

/// The area of a sum of three segments in one plane, and the integral of q q^T over it.
struct Facet {
    double area = 0;
    Matrix3d moment = Matrix3d::Zero();
};

/// The sum consists of a parallelogram for each pair of segments, whose centre lies half of the
/// third segment from the centre of the facet.
Facet facet_of(const std::array<Vector3d, 3>& segments) {
    Facet facet;
    for (int k = 0; k < 3; ++k) {
        const Vector3d& a = segments[k];
        const Vector3d& b = segments[(k + 1) % 3];
        const Vector3d& shift = segments[(k + 2) % 3];
        const double area = a.cross(b).norm();
        facet.area += area;
        facet.moment += area * (a * a.transpose() / 12 + b * b.transpose() / 12 +
                                shift * shift.transpose() / 4);
    }
    return facet;
}

Matrix3d stiffness(const Vector3d& v, const Facet& facet) {
    return 4 / v.norm() * (facet.area / 4 * v * v.transpose() - facet.moment);
}

std::array<Bond, 7> bonds(const LatticePattern& pattern) {
    const Superbase b(pattern);
    std::array<Bond, 7> around;
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        const int k = (i + 2) % 4;
        const int l = (i + 3) % 4;
        const Facet facet = facet_of({b.segment(j, k), b.segment(k, l), b.segment(l, j)});
        around[i] = {b.steps[i], stiffness(b.vectors.col(i), facet)};
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        const Facet facet = facet_of({b.segment(i, 3), b.segment(j, k), Vector3d::Zero()});
        around[4 + i] = {b.steps[i] + b.steps[3],
                         stiffness(b.vectors.col(i) + b.vectors.col(3), facet)};
    }
    return around;
}

/// The smallest and the largest eigenvalue of H(k), k in n-ths of the dual of the reduced periods.
std::pair<double, double> extremes(const std::array<Bond, 7>& around, const LatticeVector& wave,
                                   int n) {
    Matrix3d hessian = Matrix3d::Zero();
    for (const Bond& bond : around) {
        hessian += one_minus_cosine(wave.dot(bond.steps), n) * bond.stiffness;
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(hessian, Eigen::EigenvaluesOnly);
    return {solver.eigenvalues()[0], solver.eigenvalues()[2]};
}

}  // namespace

LatticeStability lattice_stability(const LatticePattern& pattern) {
    const int n = pattern.n_sites();
    if (n == 1) return {Minimum::kYes, std::nullopt};
    const std::array<Bond, 7> around = bonds(pattern);
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0;
    // Compute the extreme eigenvalues over all wave vectors but zero.
    for (int i = 0; i < pattern.form.a; ++i) {
        for (int j = 0; j < pattern.form.d; ++j) {
            for (int k = 0; k < pattern.form.f; ++k) {
                if (i == 0 && j == 0 && k == 0) continue;
                checkpoint_each(k);
                const auto [low, high] = extremes(around, {i, j, k}, n);
                smallest = std::min(smallest, low);
                largest = std::max(largest, high);
            }
        }
    }
    return decided_stability(smallest, largest);
}

}  // namespace pcvt::space
