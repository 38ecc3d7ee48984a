#include "mesher/cells/phase_assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using Fractions = std::vector<double>;

/// The cells of a CVT ("equal") or of power cells with a law of areas.
CellTable cells_of(const std::string& law, const Lattice& lattice, int n, std::uint64_t seed) {
    const Points points = uniform_points(lattice, n, seed);
    if (law == "cvt") {
        CvtOptions options;
        options.run.max_iterations = 30;
        return cell_table(cell_mesh(compute_cvt(lattice, points, options).delaunay));
    }
    const Eigen::VectorXd areas =
        scaled_areas(draw_areas(parse_area_law(law), n, seed), n, lattice.area());
    const AreaCvtOptions options{.areas = areas, .run = {.max_iterations = 5}};
    return cell_table(cell_mesh(compute_area_cvt(lattice, points, options).delaunay));
}

/// The largest difference of a phase's area from its target.
double error_of(const CellTable& cells, const std::vector<int>& phase, const Fractions& fractions) {
    const double total = std::accumulate(cells.measure.begin(), cells.measure.end(), 0.0);
    const std::vector<double> shares = phase_shares(cells, phase, fractions.size());
    double largest = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        largest = std::max(largest, total * std::abs(shares[k] - fractions[k]));
    }
    return largest;
}

double bound_of_law_1(const CellTable& cells, const Fractions& fractions) {
    const double smallest = *std::min_element(cells.measure.begin(), cells.measure.end());
    return (1 - 1 / double(fractions.size())) * smallest;
}

/// The share of the sides between cells of equal phase.
double equal_share(const CellTable& cells, const std::vector<int>& phase) {
    double equal = 0;
    for (SiteId s = 0; s < cells.n_cells(); ++s) {
        for (int k = cells.neighbour_begin[s]; k < cells.neighbour_begin[s + 1]; ++k) {
            equal += phase[s] == phase[cells.neighbours[k]] ? 1 : 0;
        }
    }
    return equal / double(cells.neighbours.size());
}

/// The share of law 2.
double random_share(const CellTable& cells, const std::vector<int>& phase, std::size_t n_phases) {
    std::vector<double> sides(n_phases, 0);
    for (SiteId s = 0; s < cells.n_cells(); ++s) sides[phase[s]] += cells.sides[s];
    double share = 0;
    for (const double n : sides) share += std::pow(n / double(cells.neighbours.size()), 2);
    return share;
}

void expect_laws(const CellTable& cells, const Fractions& fractions, std::uint64_t seed) {
    const std::vector<int> phase = assign_phases(cells, fractions, seed);
    ASSERT_EQ(static_cast<int>(phase.size()), cells.n_cells());
    // Sums of other order differ by rounding.
    EXPECT_LE(error_of(cells, phase, fractions), bound_of_law_1(cells, fractions) * (1 + 1e-9));
    EXPECT_LE(equal_share(cells, phase), random_share(cells, phase, fractions.size()) + 1e-12);
}

const std::vector<Fractions> kFractions{{1},          {0.3, 0.7},      {0.5, 0.5},
                                        {0.02, 0.98}, {0.2, 0.3, 0.5}, {0.1, 0.2, 0.3, 0.4}};

TEST(PhaseAssignment, Laws1And2OnEveryLattice) {
    for (const auto& [name, lattice] : testing::lattices()) {
        const CellTable cells = cells_of("cvt", lattice, 150, 2);
        for (const Fractions& fractions : kFractions) {
            SCOPED_TRACE(name + " " + std::to_string(fractions[0]));
            expect_laws(cells, fractions, 7);
        }
    }
}

TEST(PhaseAssignment, Laws1And2WithFiveHundredGrains) {
    for (const char* law : {"cvt", "equal", "lognormal:0.42", "gamma:0.4"}) {
        const CellTable cells = cells_of(law, Lattice::rectangle(2, 1), 500, 3);
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            for (const Fractions& fractions : kFractions) {
                SCOPED_TRACE(law + std::to_string(fractions[0]));
                expect_laws(cells, fractions, seed);
            }
        }
    }
}

TEST(PhaseAssignment, Law3NoPhasePrefersCellsWithFewSidesOrSmallOnes) {
    const CellTable cells = cells_of("lognormal:0.42", Lattice::rectangle(1, 1), 500, 3);
    const Fractions fractions{0.05, 0.95};
    double sides = 0;
    double area = 0;
    double n = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const std::vector<int> phase = assign_phases(cells, fractions, seed);
        for (SiteId s = 0; s < cells.n_cells(); ++s) {
            if (phase[s] != 0) continue;
            sides += cells.sides[s];
            area += cells.measure[s];
            n += 1;
        }
    }
    // The spreads are 1.2 sides and 0.9 of an area; four deviations of the mean of n cells.
    EXPECT_GT(n, 900);
    EXPECT_NEAR(sides / n, 6, 4 * 1.2 / std::sqrt(n));
    EXPECT_NEAR(500 * area / n, 1, 4 * 0.9 / std::sqrt(n));
}

/// The variance of the number of cells of phase 0 among a cell and its neighbours, over the mean.
double clustering(const CellTable& cells, const std::vector<int>& phase) {
    double sum = 0;
    double squares = 0;
    for (SiteId s = 0; s < cells.n_cells(); ++s) {
        double count = phase[s] == 0 ? 1 : 0;
        for (int k = cells.neighbour_begin[s]; k < cells.neighbour_begin[s + 1]; ++k) {
            count += phase[cells.neighbours[k]] == 0 ? 1 : 0;
        }
        sum += count;
        squares += count * count;
    }
    const double mean = sum / cells.n_cells();
    return (squares / cells.n_cells() - mean * mean) / mean;
}

TEST(PhaseAssignment, AMinorityIsSpreadFarMoreEvenlyThanAtRandom) {
    for (const char* law : {"cvt", "lognormal:0.42"}) {
        const CellTable cells = cells_of(law, Lattice::rectangle(1, 1), 500, 3);
        std::vector<int> phase = assign_phases(cells, Fractions{0.3, 0.7}, 1);
        const double spread = clustering(cells, phase);
        std::mt19937_64 random(1);
        std::shuffle(phase.begin(), phase.end(), random);
        EXPECT_LT(spread, 0.35 * clustering(cells, phase)) << law;
    }
}

/// The least error of all assignments.
double least_error(const CellTable& cells, const Fractions& fractions) {
    const int n = cells.n_cells();
    const int n_phases = static_cast<int>(fractions.size());
    double least = std::numeric_limits<double>::infinity();
    std::vector<int> phase(static_cast<std::size_t>(n), 0);
    for (;;) {
        least = std::min(least, error_of(cells, phase, fractions));
        int s = 0;
        while (s < n && ++phase[s] == n_phases) phase[s++] = 0;
        if (s == n) return least;
    }
}

TEST(PhaseAssignment, Law1HoldsWhereverItCanForFewCells) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    for (const int n : {1, 2, 3, 4, 5, 6, 7, 8}) {
        for (const char* law : {"equal", "lognormal:0.42", "gamma:0.6"}) {
            const CellTable cells = cells_of(law, lattice, n, 3);
            for (const Fractions& fractions : kFractions) {
                if (fractions.size() > 3) continue;
                SCOPED_TRACE(law + std::to_string(n) + " " + std::to_string(fractions[0]));
                const std::vector<int> phase = assign_phases(cells, fractions, 1);
                const double bound =
                    std::max(bound_of_law_1(cells, fractions), least_error(cells, fractions));
                EXPECT_LE(error_of(cells, phase, fractions), bound * (1 + 1e-9));
            }
        }
    }
}

TEST(PhaseAssignment, Law4TheSeedAloneDecides) {
    const CellTable cells = cells_of("cvt", Lattice::rectangle(1, 1), 60, 3);
    const Fractions fractions{0.3, 0.7};
    const std::vector<int> phase = assign_phases(cells, fractions, 1);
    EXPECT_EQ(assign_phases(cells, fractions, 1), phase);
    EXPECT_NE(assign_phases(cells, fractions, 2), phase);
}

TEST(PhaseAssignment, SharesSumToOne) {
    const CellTable cells = cells_of("gamma:0.4", Lattice::rectangle(3, 1), 50, 3);
    const std::vector<double> shares =
        phase_shares(cells, assign_phases(cells, Fractions{0.25, 0.75}, 1), 2);
    EXPECT_NEAR(shares[0] + shares[1], 1, 1e-15);
    EXPECT_NEAR(shares[0], 0.25, 0.02);
}

}  // namespace
}  // namespace pcvt::plane
