#include "mesher/space/geometry/lattice.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mesher/base/error.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt::space {
namespace {

/// F has the unit length^5; it would leave the range of a double beyond these lengths.
constexpr double kShortestPeriod = 1e-40;
constexpr double kLongestPeriod = 1e40;
constexpr double kLargestCoefficient = 1e6;
constexpr double kThinnestBasis = 1e6;
/// Relative to |a| |b| |c|; the sign of a smaller determinant is rounding.
constexpr double kDependent = 1e-14;
/// A vector replaces another only if it is shorter by this factor; otherwise rounding could make
/// the reduction alternate between equally short ones.
constexpr double kShorter = 1 - 1e-12;

/// x . y, as if each product and sum had twice the digits (T. Ogita, S. Rump, S. Oishi 2005).
double accurate_dot(const Vec3& x, const Vec3& y) {
    double sum = 0;
    double error = 0;
    for (int k = 0; k < 3; ++k) {
        const double product = x[k] * y[k];
        const double next = sum + product;
        const double tail = next - sum;
        error += (sum - (next - tail)) + (product - tail) + std::fma(x[k], y[k], -product);
        sum = next;
    }
    return sum + error;
}

/// The combination u_0 a + u_1 b + u_2 c.
Vec3 combination(const Vec3& u, const std::array<Vec3, 3>& periods) {
    Vec3 sum;
    for (int k = 0; k < 3; ++k) {
        sum[k] = accurate_dot(u, {periods[0][k], periods[1][k], periods[2][k]});
    }
    return sum;
}

double determinant(const std::array<Vec3, 3>& p) { return accurate_dot(p[0], p[1].cross(p[2])); }

void require_period(const Vec3& period) {
    if (!period.allFinite()) {
        throw InvalidInput("a period vector is not finite; give finite numbers");
    }
    const double length = period.stableNorm();
    if (!(length >= kShortestPeriod && length <= kLongestPeriod)) {
        throw InvalidInput(
            "a period vector is shorter than 1e-40 or longer than 1e40; choose another unit of "
            "length");
    }
}

/// A basis of the lattice whose vectors are integer combinations of its periods.
class Basis {
   public:
    explicit Basis(const Lattice& lattice) : lattice_(lattice) {
        for (int r = 0; r < 3; ++r) rows_[r] = Vec3::Unit(r);
        update();
    }

    const std::array<Vec3, 3>& vectors() const { return vectors_; }
    const Vec3& row(int r) const { return rows_[r]; }

    void sort_by_length() {
        std::array<int, 3> order{0, 1, 2};
        std::stable_sort(order.begin(), order.end(), [this](int r, int s) {
            return vectors_[r].squaredNorm() < kShorter * vectors_[s].squaredNorm();
        });
        rows_ = {rows_[order[0]], rows_[order[1]], rows_[order[2]]};
        update();
    }

    /// Subtracts the integer multiples x and y of the first two vectors from vector r where that
    /// makes it shorter.
    bool shorten(int r, double x, double y) {
        const Vec3 row = rows_[r] - x * rows_[0] - y * rows_[1];
        const Vec3 vector = combination(row, lattice_.periods());
        if (!(vector.squaredNorm() < kShorter * vectors_[r].squaredNorm())) return false;
        if (row.cwiseAbs().maxCoeff() > kLargestCoefficient) {
            throw InvalidInput(
                "the period vectors are too close to linearly dependent: their reduction needs "
                "integers above 10^6; give a less skewed basis of the same lattice");
        }
        rows_[r] = row;
        vectors_[r] = vector;
        return true;
    }

    void invert_last() {
        rows_[2] = -rows_[2];
        update();
    }

   private:
    void update() {
        for (int r = 0; r < 3; ++r) vectors_[r] = combination(rows_[r], lattice_.periods());
    }

    const Lattice& lattice_;
    std::array<Vec3, 3> rows_;
    std::array<Vec3, 3> vectors_;
};

/// Shortens the second vector by multiples of the first.
bool shorten_second(Basis& basis) {
    const auto& v = basis.vectors();
    return basis.shorten(1, std::round(v[0].dot(v[1]) / v[0].squaredNorm()), 0);
}

/// Shortens the third vector by the combination of the first two that is nearest to it: one of
/// those round the projection, because the first two are reduced.
bool shorten_third(Basis& basis) {
    const auto& v = basis.vectors();
    const double aa = v[0].squaredNorm();
    const double ab = v[0].dot(v[1]);
    const double bb = v[1].squaredNorm();
    const double det = aa * bb - ab * ab;
    const double ca = v[2].dot(v[0]);
    const double cb = v[2].dot(v[1]);
    const double x = std::round((bb * ca - ab * cb) / det);
    const double y = std::round((aa * cb - ab * ca) / det);
    bool shorter = basis.shorten(2, x, y);
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) shorter = basis.shorten(2, i, j) || shorter;
    }
    return shorter;
}

}  // namespace

Lattice::Lattice(const Vec3& a, const Vec3& b, const Vec3& c) : periods_{a, b, c} {
    for (const Vec3& period : periods_) require_period(period);
    const double det = determinant(periods_);
    if (!(std::abs(det) > kDependent * a.norm() * b.norm() * c.norm())) {
        throw InvalidInput(
            "the period vectors are linearly dependent; give three independent ones");
    }
    volume_ = std::abs(det);
    right_handed_ = det > 0;
    inverse_.row(0) = b.cross(c) / det;
    inverse_.row(1) = c.cross(a) / det;
    inverse_.row(2) = a.cross(b) / det;
}

Lattice Lattice::box(double x, double y, double z) {
    return {Vec3(x, 0, 0), Vec3(0, y, 0), Vec3(0, 0, z)};
}

Vec3 Lattice::heights() const { return inverse_.rowwise().norm().cwiseInverse(); }

Vec3 Lattice::to_position(const Vec3& u) const { return combination(u, periods_); }

double Lattice::spacing(int n) const { return portable_cbrt(volume_ / n); }

Vec3 Lattice::wrapped(const Vec3& u) { return wrap(u).fraction; }

Reduction reduce(const Lattice& lattice) {
    // The greedy algorithm (I. Semaev 2001): sort, and shorten the later vectors by the earlier.
    Basis basis(lattice);
    do {
        do {
            basis.sort_by_length();
        } while (shorten_second(basis));
    } while (shorten_third(basis));
    if (determinant(basis.vectors()) < 0) basis.invert_last();
    const auto& v = basis.vectors();
    Reduction reduction{Lattice(v[0], v[1], v[2]), {}};
    if (v[2].norm() > kThinnestBasis * v[0].norm()) {
        throw InvalidInput("the lattice is thinner than 1 : 10^6; give a less extreme one");
    }
    for (int r = 0; r < 3; ++r) {
        for (int k = 0; k < 3; ++k) reduction.m[3 * r + k] = static_cast<int>(basis.row(r)[k]);
    }
    return reduction;
}

WrappedPoint wrap(const Vec3& u) {
    Vec3 whole = u.array().floor();
    Vec3 fraction;
    for (int k = 0; k < 3; ++k) {
        fraction[k] = std::nearbyint((u[k] - whole[k]) * kGrid) / kGrid;
        if (fraction[k] >= 1) {
            fraction[k] -= 1;
            whole[k] += 1;
        }
    }
    return {fraction, {int(whole[0]), int(whole[1]), int(whole[2])}};
}

}  // namespace pcvt::space
