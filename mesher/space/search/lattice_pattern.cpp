#include "mesher/space/search/lattice_pattern.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/search/obtuse_superbase.hpp"

namespace pcvt::space {
namespace {

/// Energies whose relative difference is less than this count as equal; their rounding error is
/// near 1e-15.
constexpr double kEqualEnergies = 1e-12;
/// Evaluations take about a microsecond each.
constexpr double kMostForms = 1e9;

std::int64_t remainder_of(std::int64_t value, std::int64_t n) { return (value % n + n) % n; }

void require_form(const HermiteForm& form) {
    const auto& [a, d, f, b, c, e] = form;
    if (std::min({a, d, f}) < 1 || std::min({b, c, e}) < 0 || b >= d || std::max(c, e) >= f) {
        throw InvalidInput(
            "a Hermite normal form must have a, d, f >= 1, 0 <= b < d and 0 <= c, e < f");
    }
}

/// The basis of a form, in n-ths of the reduced period vectors.
std::array<LatticeVector, 3> form_basis(const HermiteForm& form) {
    const std::int64_t a = form.a;
    const std::int64_t d = form.d;
    const std::int64_t f = form.f;
    return {LatticeVector(d * f, 0, 0), LatticeVector(-form.b * f, a * f, 0),
            LatticeVector(std::int64_t{form.b} * form.e - form.c * d, -a * form.e, a * d)};
}

Eigen::Matrix3d columns_of(const std::array<LatticeVector, 4>& superbase) {
    Eigen::Matrix3d columns;
    for (int k = 0; k < 3; ++k) columns.col(k) = superbase[k].cast<double>();
    return columns;
}

/// Returns vectors of an obtuse superbase of the period lattice.
Eigen::Matrix3d reduced_periods(const Eigen::Matrix3d& period) {
    const double volume = period.determinant();
    if (!std::isfinite(volume) || volume == 0) {
        throw InvalidInput("the period vectors are dependent; give three independent ones");
    }
    const std::array<LatticeVector, 3> units{LatticeVector::UnitX(), LatticeVector::UnitY(),
                                             LatticeVector::UnitZ()};
    return period * columns_of(obtuse_superbase(units, period.transpose() * period));
}

/// Returns the metric of n-ths of period vectors, for which a cell has the volume 1.
Eigen::Matrix3d metric_of(const Eigen::Matrix3d& reduced, int n) {
    const Eigen::Matrix3d scaled = reduced / portable_cbrt(std::abs(reduced.determinant()));
    return portable_cbrt(double(n)) * portable_cbrt(double(n)) / (double(n) * n) *
           (scaled.transpose() * scaled);
}

/// The sum of d f^2, which is the number of forms of index n.
double count_forms(int n) {
    double count = 0;
    for (int a = 1; a <= n; ++a) {
        if (n % a != 0) continue;
        for (int d = 1; d <= n / a; ++d) {
            if (n / a % d != 0) continue;
            const double f = double(n) / a / d;
            count += d * f * f;
        }
    }
    return count;
}

/// The lowest moment so far and the first form that has it.
class Best {
   public:
    explicit Best(const Eigen::Matrix3d& metric) : metric_(metric) {}

    void try_form(const HermiteForm& form) {
        const double moment = second_moment(obtuse_superbase(form_basis(form), metric_), metric_);
        if (moment >= moment_ * (1 - kEqualEnergies)) return;
        moment_ = moment;
        form_ = form;
    }
    const HermiteForm& form() const { return form_; }

   private:
    const Eigen::Matrix3d& metric_;
    double moment_ = std::numeric_limits<double>::max();
    HermiteForm form_;
};

/// Tries all forms with the diagonal of `form`.
void try_diagonal(HermiteForm form, Best& best) {
    for (form.b = 0; form.b < form.d; ++form.b) {
        for (form.c = 0; form.c < form.f; ++form.c) {
            checkpoint();
            for (form.e = 0; form.e < form.f; ++form.e) {
                checkpoint_each(form.e);
                best.try_form(form);
            }
        }
    }
}

}  // namespace

double energy_of_moment(double moment, double volume, int n) {
    const double cell = std::abs(volume) / n;
    const double width = portable_cbrt(cell);
    return 3 * n * moment * cell * width * width;
}

LatticePattern lattice_pattern(const Eigen::Matrix3d& period, const HermiteForm& form) {
    require_form(form);
    const int n = form.index();
    LatticePattern pattern{.period = period,
                           .reduced = reduced_periods(period),
                           .form = form,
                           .basis = Eigen::Matrix3d::Zero(),
                           .steps = {},
                           .moment = 0,
                           .energy = 0};
    const Eigen::Matrix3d metric = metric_of(pattern.reduced, n);
    const std::array<LatticeVector, 4> superbase = obtuse_superbase(form_basis(form), metric);
    std::copy_n(superbase.begin(), 3, pattern.steps.begin());
    pattern.basis = pattern.reduced * columns_of(superbase) / n;
    if (pattern.basis.determinant() < 0) {
        pattern.basis = -pattern.basis;
        for (LatticeVector& step : pattern.steps) step = -step;
    }
    pattern.moment = second_moment(superbase, metric);
    pattern.energy = energy_of_moment(pattern.moment, pattern.reduced.determinant(), n);
    return pattern;
}

LatticePattern best_lattice(const Eigen::Matrix3d& period, int n) {
    if (n < 1) throw InvalidInput("the number of sites must be at least 1");
    const Eigen::Matrix3d metric = metric_of(reduced_periods(period), n);
    if (count_forms(n) > kMostForms) {
        throw LimitExceeded("the lattices of " + std::to_string(n) +
                            " cells are more than 10^9; take fewer sites");
    }
    Best best(metric);
    for (int a = 1; a <= n; ++a) {
        if (n % a != 0) continue;
        for (int d = 1; d <= n / a; ++d) {
            if (n / a % d != 0) continue;
            try_diagonal({.a = a, .d = d, .f = n / a / d}, best);
        }
    }
    return lattice_pattern(period, best.form());
}

Eigen::Matrix3Xd pattern_points(const LatticePattern& pattern) {
    const std::array<LatticeVector, 3> basis = form_basis(pattern.form);
    const std::int64_t n = pattern.n_sites();
    Eigen::Matrix3Xd points(3, n);
    Eigen::Index column = 0;
    for (int i = 0; i < pattern.form.a; ++i) {
        for (int j = 0; j < pattern.form.d; ++j) {
            checkpoint();
            for (int k = 0; k < pattern.form.f; ++k) {
                // Coordinates are wrapped while they are still integer numbers of n-ths.
                const LatticeVector site = i * basis[0] + j * basis[1] + k * basis[2];
                Eigen::Vector3d u;
                for (int x = 0; x < 3; ++x) {
                    u[x] = static_cast<double>(remainder_of(site[x], n)) / static_cast<double>(n);
                }
                points.col(column++) = pattern.reduced * u;
            }
        }
    }
    return points;
}

}  // namespace pcvt::space
