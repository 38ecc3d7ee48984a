#include "mesher/plane/search/lattice_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/search/lattice_steps.hpp"

namespace pcvt::plane {
namespace {

/// Energies whose relative difference is less than this count as equal; their rounding error is
/// near 1e-15.
constexpr double kEqualEnergies = 1e-12;
/// Vectors whose squared lengths differ by less than this factor count as equally long.
constexpr double kTie = 1 + 1e-12;

/// Scalar products of steps, in units of 1 / n^2. The period vectors are reduced, so squares do not
/// suffer from cancellation: |a.b| is at most half of the smaller of |a|^2 and |b|^2.
struct StepMetric {
    explicit StepMetric(const Lattice& reduced)
        : aa(reduced.a().squaredNorm()),
          ab(reduced.a().dot(reduced.b())),
          bb(reduced.b().squaredNorm()) {}

    double dot(const LatticeStep& s, const LatticeStep& t) const {
        const auto si = static_cast<double>(s.i);
        const auto sj = static_cast<double>(s.j);
        const auto ti = static_cast<double>(t.i);
        const auto tj = static_cast<double>(t.j);
        return si * ti * aa + (si * tj + sj * ti) * ab + sj * tj * bb;
    }

    double aa;
    double ab;
    double bb;
};

struct StepBasis {
    LatticeStep s;
    LatticeStep t;
};

/// Gauss's reduction: |s| <= |t| and |s.t| <= |s|^2 / 2, then turned so that s.t <= 0.
StepBasis obtuse_basis(const HermiteForm& form, const StepMetric& metric) {
    StepBasis basis{{0, form.a}, {form.d, -form.b}};
    auto& [s, t] = basis;
    for (;;) {
        const double ratio = metric.dot(s, t) / metric.dot(s, s);
        if (std::abs(ratio) > 0.5 * kTie) {
            const auto times = static_cast<std::int64_t>(std::round(ratio));
            t = {t.i - times * s.i, t.j - times * s.j};
        } else if (metric.dot(t, t) * kTie < metric.dot(s, s)) {
            std::swap(s, t);
        } else {
            break;
        }
    }
    if (metric.dot(s, t) > 0) t = {-t.i, -t.j};
    return basis;
}

/// Returns n times the energy of one cell, sqrt(D) / 12 (p + q + r + p q r / D), where p, q, r are
/// the Selling parameters of the obtuse superbase s, t, -s - t, and sqrt(D) is the area of the
/// cell.
double energy_of(const StepBasis& basis, const StepMetric& metric, double area, int n) {
    const double steps = 1.0 / (double(n) * double(n));
    const double st = metric.dot(basis.s, basis.t) * steps;
    const double p = -st;
    const double q = metric.dot(basis.t, basis.t) * steps + st;
    const double r = metric.dot(basis.s, basis.s) * steps + st;
    const double cell = area / n;
    return area / 12 * (p + q + r + p * (q / cell) * (r / cell));
}

void require_form(const HermiteForm& form) {
    if (form.a < 1 || form.d < 1 || form.b < 0 || form.b >= form.a) {
        throw InvalidInput("a Hermite normal form must have a, d >= 1 and 0 <= b < a");
    }
}

Offset to_offset(const LatticeStep& step) {
    return {static_cast<int>(step.i), static_cast<int>(step.j)};
}

/// Returns the canonical form of a reduced basis: it is right-handed, and its first vector points
/// to the right or along +y. If the vectors are equally long, the one nearer to the x axis comes
/// first.
std::array<Offset, 2> canonical(const StepBasis& basis, const StepMetric& metric,
                                const Lattice& reduced) {
    Offset s = to_offset(basis.s);
    Offset t = to_offset(basis.t);
    const bool tied = metric.dot(basis.t, basis.t) <= kTie * metric.dot(basis.s, basis.s);
    if (tied && std::abs(reduced.translation(s).x()) < std::abs(reduced.translation(t).x())) {
        std::swap(s, t);
    }
    const Vec2 v = reduced.translation(s);
    if (v.x() < 0 || (v.x() == 0 && v.y() < 0)) s = -s;
    if (std::int64_t{s.i} * t.j < std::int64_t{s.j} * t.i) t = -t;
    return {s, t};
}

struct Candidate {
    double energy;
    HermiteForm form;
};

/// The `count` lowest energies so far, each with the first lattice that has it.
class Ranking {
   public:
    explicit Ranking(int count) : count_(static_cast<std::size_t>(count)) {}

    void add(const Candidate& candidate) {
        const double energy = candidate.energy;
        if (kept_.size() == count_ && energy >= kept_.back().energy * (1 - kEqualEnergies)) return;
        for (const Candidate& other : kept_) {
            if (std::abs(energy - other.energy) <= kEqualEnergies * other.energy) return;
        }
        const auto place = std::find_if(kept_.begin(), kept_.end(), [&](const Candidate& other) {
            return energy < other.energy;
        });
        kept_.insert(place, candidate);
        if (kept_.size() > count_) kept_.pop_back();
    }
    const std::vector<Candidate>& kept() const { return kept_; }

   private:
    std::size_t count_;
    std::vector<Candidate> kept_;
};

}  // namespace

LatticePattern lattice_pattern(const Lattice& period, const HermiteForm& form) {
    require_form(form);
    const int n = form.index();
    const Lattice reduced = reduce(period).reduced;
    const StepMetric metric(reduced);
    const StepBasis basis = obtuse_basis(form, metric);
    const std::array<Offset, 2> steps = canonical(basis, metric, reduced);
    return {.period = period,
            .form = form,
            .basis = Lattice(reduced.translation(steps[0]) / n, reduced.translation(steps[1]) / n),
            .steps = steps,
            .energy = energy_of(basis, metric, period.area(), n),
            .energy_bound = hexagonal_bound(period.area(), n)};
}

std::vector<LatticePattern> best_lattices(const Lattice& period, int n, int count) {
    if (n < 1) throw InvalidInput("the number of sites must be at least 1");
    const StepMetric metric(reduce(period).reduced);
    Ranking ranking(count);
    for (int a = 1; a <= n; ++a) {
        checkpoint_each(a);
        if (n % a != 0) continue;
        for (int b = 0; b < a; ++b) {
            checkpoint_each(b);
            const HermiteForm form{a, b, n / a};
            ranking.add({energy_of(obtuse_basis(form, metric), metric, period.area(), n), form});
        }
    }
    std::vector<LatticePattern> patterns;
    for (const Candidate& kept : ranking.kept()) {
        patterns.push_back(lattice_pattern(period, kept.form));
    }
    return patterns;
}

LatticePattern best_lattice(const Lattice& period, int n) {
    return best_lattices(period, n, 1).front();
}

Points pattern_points(const LatticePattern& pattern) {
    const auto [a, b, d] = pattern.form;
    const std::int64_t n = pattern.n_sites();
    const Lattice reduced = reduce(pattern.period).reduced;
    Points points(2, pattern.n_sites());
    for (int i = 0; i < a; ++i) {
        checkpoint_each(i);
        for (int j = 0; j < d; ++j) {
            // The second coordinate is wrapped while it is still an integer number of n-ths.
            const std::int64_t v = remainder_of(std::int64_t{j} * a - std::int64_t{i} * b, n);
            points.col(i * d + j) = reduced.to_position(
                {double(i) / a, static_cast<double>(v) / static_cast<double>(n)});
        }
    }
    return points;
}

int pattern_site(const HermiteForm& form, std::int64_t i, std::int64_t j) {
    const auto [a, b, d] = form;
    const std::int64_t row = i / d;
    const std::int64_t column = (j + b * row) / a;
    // Wrapping by `a` rows shifts the column by b.
    const std::int64_t wrapped = remainder_of(row, a);
    return static_cast<int>(wrapped * d + remainder_of(column - (row - wrapped) / a * b, d));
}

void map_back(const Metric& metric, LatticePattern& pattern) {
    for (Lattice* lattice : {&pattern.period, &pattern.basis}) {
        *lattice = {metric.from_round(lattice->a()), metric.from_round(lattice->b())};
    }
}

}  // namespace pcvt::plane
