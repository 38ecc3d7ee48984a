#include "mesher/plane/search/lattice_pattern.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesher/base/error.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using testing::kSquare;

CvtResult pattern_tessellation(const LatticePattern& pattern) {
    CvtOptions as_given;
    as_given.run.max_iterations = 0;
    return compute_cvt(pattern.period, pattern_points(pattern), as_given);
}

/// The lowest energy on the unit square and a lattice that attains it, computed independently of
/// this program to 15 digits.
struct KnownMinimum {
    int n;
    double energy;
    HermiteForm form;
};
constexpr KnownMinimum kKnown[] = {
    {1, 0.166666666666667, {1, 0, 1}},          {2, 0.0833333333333333, {2, 1, 1}},
    {3, 0.0596707818930041, {3, 1, 1}},         {4, 0.0403645833333333, {2, 1, 2}},
    {5, 0.0333333333333333, {5, 2, 1}},         {6, 0.0277777777777778, {3, 1, 2}},
    {7, 0.025059003193114, {7, 2, 1}},          {8, 0.0201822916666667, {8, 3, 1}},
    {10, 0.0166666666666667, {10, 7, 1}},       {12, 0.0134387860082305, {4, 2, 3}},
    {13, 0.0128205128205128, {13, 5, 1}},       {17, 0.00980392156862745, {17, 4, 1}},
    {20, 0.00807291666666667, {20, 12, 1}},     {31, 0.00534349877624151, {31, 19, 1}},
    {56, 0.00286393256282105, {14, 7, 4}},      {97, 0.0016641292576031, {97, 29, 1}},
    {168, 0.000954643769158898, {24, 12, 7}},   {200, 0.000802677291666666, {100, 15, 2}},
    {256, 0.000627779712279638, {256, 226, 1}}, {300, 0.000534814814814815, {50, 32, 6}},
    {397, 0.000405607289347109, {397, 272, 1}}, {400, 0.000401338645833333, {400, 211, 1}},
};

TEST(BestLattice, HasTheKnownEnergyOnTheUnitSquare) {
    for (const KnownMinimum& known : kKnown) {
        const double digits = 4e-15 / known.energy * 0.125 + 1e-13;
        EXPECT_NEAR(best_lattice(kSquare, known.n).energy / known.energy, 1, digits) << known.n;
        EXPECT_NEAR(lattice_pattern(kSquare, known.form).energy / known.energy, 1, digits)
            << known.n;
    }
}

/// F_PCVT of the paper's Table I.
TEST(BestLattice, HasTheEnergiesThatThePaperPrints) {
    const std::pair<int, double> table[] = {{3, 5.9671e-2},   {30, 5.3482e-3},  {56, 2.8639e-3},
                                            {150, 1.0696e-3}, {168, 9.5464e-4}, {224, 7.1598e-4},
                                            {300, 5.3481e-4}};
    for (const auto& [n, printed] : table) {
        const double last_digit = std::pow(10, std::floor(std::log10(printed)) - 4);
        EXPECT_NEAR(best_lattice(kSquare, n).energy, printed, 0.55 * last_digit) << n;
    }
}

TEST(BestLattice, IsHexagonalWhereThePeriodsAreHexagonal) {
    const Lattice hexagonal({2, 0}, {1, std::sqrt(3)});
    for (const int n : {1, 3, 4, 7, 9, 12, 13, 25, 49}) {
        const LatticePattern pattern = best_lattice(hexagonal, n);
        EXPECT_NEAR(pattern.energy / pattern.energy_bound, 1, 1e-14) << n;
    }
}

/// Law (1).
TEST(LatticePattern, BasisIsReducedAndSpansThePeriodVectors) {
    for (const auto& [name, period] : testing::lattices()) {
        for (int n = 1; n <= 40; ++n) {
            const Lattice basis = best_lattice(period, n).basis;
            EXPECT_NEAR(basis.area() * n / period.area(), 1, 1e-12) << name << n;
            EXPECT_LE(basis.a().norm(), basis.b().norm() * (1 + 1e-11)) << name << n;
            EXPECT_LE(std::abs(basis.a().dot(basis.b())), basis.a().squaredNorm() * (0.5 + 1e-11));
            for (const Vec2& v : {period.a(), period.b()}) {
                const Vec2 steps = basis.to_lattice(v);
                EXPECT_LT((steps - steps.array().round().matrix()).norm(), 1e-9) << name << n;
            }
        }
    }
}

/// Law (2).
void expect_energy_of_the_cvt(const LatticePattern& pattern, const std::string& name) {
    const CvtResult result = pattern_tessellation(pattern);
    EXPECT_NEAR(result.run.energy / pattern.energy, 1, 1e-12) << name << pattern.n_sites();
    EXPECT_LT(result.run.residual, 1e-12) << name << pattern.n_sites();
}

TEST(LatticePattern, FindsItsSitesByTheirSteps) {
    for (const HermiteForm& form : {HermiteForm{6, 4, 3}, {12, 5, 1}, {1, 0, 7}, {4, 0, 4}}) {
        const LatticePattern pattern = lattice_pattern(kSquare, form);
        const Points points = pattern_points(pattern);
        for (int k = -9; k <= 9; ++k) {
            for (int m = -9; m <= 9; ++m) {
                const auto [s, t] = pattern.steps;
                const int site = pattern_site(form, k * s.i + m * t.i, k * s.j + m * t.j);
                const Vec2 off = k * pattern.basis.a() + m * pattern.basis.b() - points.col(site);
                EXPECT_LT((off - off.array().round().matrix()).norm(), 1e-13) << k << " " << m;
            }
        }
    }
}

TEST(LatticePattern, IsACvtOfItsEnergy) {
    for (const auto& [name, period] : testing::lattices()) {
        for (const int n : {1, 2, 3, 5, 16, 36, 100, 257}) {
            expect_energy_of_the_cvt(best_lattice(period, n), name);
        }
    }
}

TEST(LatticePattern, IsACvtOfItsEnergyEvenWhereItsCellsAreElongated) {
    for (const HermiteForm& form : {HermiteForm{1, 0, 12}, {12, 0, 1}, {12, 1, 1}, {3, 2, 9}}) {
        expect_energy_of_the_cvt(lattice_pattern(Lattice({1, 0}, {0.37, 0.81}), form), "");
    }
}

TEST(LatticePattern, DoesNotDependOnTheBasisOfThePeriods) {
    const Lattice skewed({1, 0}, {7, 1});
    for (int n = 1; n <= 30; ++n) {
        EXPECT_NEAR(best_lattice(skewed, n).energy / best_lattice(kSquare, n).energy, 1, 1e-13);
    }
}

TEST(BestLattices, RiseInEnergyAndStartFromTheBest) {
    const std::vector<LatticePattern> patterns = best_lattices(kSquare, 60, 8);
    ASSERT_EQ(patterns.size(), 8);
    EXPECT_EQ(patterns.front().form, best_lattice(kSquare, 60).form);
    for (std::size_t k = 1; k < patterns.size(); ++k) {
        EXPECT_GT(patterns[k].energy, patterns[k - 1].energy * (1 + 1e-12));
    }
}

TEST(BestLattices, AreFewerThanRequestedWhereFewerEnergiesOccur) {
    // Index 2 has two energies: the square lattice turned by 45 degrees, and stripes along x or y.
    EXPECT_EQ(best_lattices(kSquare, 2, 9).size(), 2);
}

TEST(BestLattices, BreakTiesByTheSmallestAThenB) {
    // (3, 1) and (3, 2) are mirror images and have equal energies.
    EXPECT_EQ(best_lattice(kSquare, 3).form, (HermiteForm{3, 1, 1}));
    const double energy = best_lattice(kSquare, 100).energy;
    for (int b = 0; b < best_lattice(kSquare, 100).form.b; ++b) {
        const int a = best_lattice(kSquare, 100).form.a;
        EXPECT_GT(lattice_pattern(kSquare, {a, b, 100 / a}).energy, energy * (1 + 1e-12));
    }
}

TEST(LatticePattern, RefusesFormsThatNameNoLattice) {
    EXPECT_THROW(best_lattice(kSquare, 0), InvalidInput);
    for (const HermiteForm& form : {HermiteForm{0, 0, 1}, {1, 0, 0}, {2, 2, 1}, {2, -1, 1}}) {
        EXPECT_THROW(lattice_pattern(kSquare, form), InvalidInput);
    }
}

}  // namespace
}  // namespace pcvt::plane
