#include <algorithm>

#include "io/pictures/plot_svg.hpp"
#include "mesher/optimize/run_statistics.hpp"
#include "mesher/space/cvt/cvt.hpp"
#include "mesher/space/search/lattice_pattern.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

constexpr double kGersho3dTolerance = 1e-8;

/// The second moment per dimension of the face-centred cubic lattice, and the mean of that of the
/// A15 structure, for cells of the volume 1.
constexpr double kFaceCentredMoment = 0.078745065618429588;
constexpr double kA15Moment = 0.0787354;

space::Lattice unit_cube() { return space::Lattice::box(1, 1, 1); }

/// The energy over that of as many cells of the body-centred cubic lattice.
double over_bound(double energy, int n) { return energy / space::body_centred_energy(1, n); }

std::vector<StudyRow> run_gersho3d(int n, int /*run*/, std::uint64_t seed) {
    const space::Lattice cube = unit_cube();
    const space::CvtResult result = space::compute_cvt(cube, uniform_points(cube, n, seed),
                                                       {{.tolerance = kGersho3dTolerance}});
    StudyRow row{stop_name(result.run.stop)};
    for (std::string& cell : run_cells(result.run)) row.push_back(std::move(cell));
    return {row};
}

/// The runs of one n, and the best lattice of as many sites. Ratios are over_bound().
struct EnergyTally {
    int n;
    int runs = 0;
    double best = 0;
    std::string best_seed;
    int n_best = 0;
    double mean = 0;
    double lattice;

    const char* winner() const {
        if (lattice < best * (1 - kSameEnergy)) return "lattice";
        return best < lattice * (1 - kSameEnergy) ? "random" : "equal";
    }
};

EnergyTally tally_energies(const StudyTable& runs, int n) {
    EnergyTally tally{
        .n = n,
        .best_seed = {},
        .lattice = over_bound(space::best_lattice(Eigen::Matrix3d::Identity(), n).energy, n)};
    for (const StudyRow& row : rows_of(runs, n)) {
        const double energy = over_bound(runs.number(row, "energy"), n);
        ++tally.runs;
        tally.mean += energy;
        if (tally.best_seed.empty() || energy < tally.best * (1 - kSameEnergy)) {
            tally.best = energy;
            tally.best_seed = row[runs.column("seed")];
            tally.n_best = 0;
        }
        if (energy < tally.best * (1 + kSameEnergy)) ++tally.n_best;
    }
    tally.mean /= tally.runs;
    return tally;
}

StudyTable energy_table(const std::vector<EnergyTally>& tallies) {
    StudyTable table;
    table.notes = {
        "F of periodic tessellations of the unit cube over F of as many truncated octahedra, the "
        "cells of the body-centred cubic lattice (19 / (192 2^(1/3)) per dimension)",
        "best, best_seed, times: the lowest energy of random starts, the first seed and the number "
        "of runs that end there; mean: of all runs; lattice: the best of all exact lattices",
        "winner: which of best and lattice is lower; equal: within 1e-9",
        "the face-centred cubic lattice (n = 4 k^3) has " +
            rounded(kFaceCentredMoment / space::kBodyCentredMoment, 7) +
            ", the A15 structure (8 k^3) " + rounded(kA15Moment / space::kBodyCentredMoment, 7)};
    table.columns = {"n", "runs", "best", "best_seed", "times", "mean", "lattice", "winner"};
    int n_below = 0;
    for (const EnergyTally& tally : tallies) {
        const bool is_below = std::min(tally.best, tally.lattice) < 1 - kSameEnergy;
        n_below += is_below ? 1 : 0;
        table.rows.push_back({std::to_string(tally.n), std::to_string(tally.runs),
                              rounded(tally.best, 9), tally.best_seed, std::to_string(tally.n_best),
                              rounded(tally.mean, 7), rounded(tally.lattice, 9), tally.winner()});
        if (is_below) {
            table.remarks.push_back("n = " + std::to_string(tally.n) +
                                    ": below the body-centred cubic lattice");
        }
    }
    if (n_below == 0) {
        table.remarks = {
            "No result lies below the body-centred cubic lattice (Gersho's "
            "conjecture in three dimensions)."};
    }
    return table;
}

StudyPicture energy_plot(std::vector<EnergyTally> tallies) {
    std::sort(tallies.begin(), tallies.end(),
              [](const EnergyTally& s, const EnergyTally& t) { return s.n < t.n; });
    PlotSeries best{.mark = PlotSeries::Mark::kDots,
                    .label = "random starts",
                    .colour = kPlotBlue,
                    .points = {}};
    PlotSeries lattice{.mark = PlotSeries::Mark::kDots,
                       .label = "best lattice",
                       .colour = kPlotOrange,
                       .points = {}};
    for (const EnergyTally& tally : tallies) {
        best.points.emplace_back(tally.n, 100 * (tally.best - 1));
        lattice.points.emplace_back(tally.n, 100 * (tally.lattice - 1));
    }
    Plot plot{.title = "Energy of periodic tessellations of the cube",
              .x = {"number of sites n", false},
              .y = {"percent above truncated octahedra", false},
              .series = {}};
    const auto add_level = [&](const char* name, const char* colour, double moment) {
        const double percent = 100 * (moment / space::kBodyCentredMoment - 1);
        plot.series.push_back(
            {.mark = PlotSeries::Mark::kLine,
             .label = name,
             .colour = colour,
             .points = {{tallies.front().n, percent}, {tallies.back().n, percent}}});
    };
    add_level("BCC", kPlotGrey, space::kBodyCentredMoment);
    add_level("FCC, A15", kPlotGreen, kFaceCentredMoment);
    plot.series.push_back(std::move(lattice));
    plot.series.push_back(std::move(best));
    std::vector<Plot> plots;
    plots.push_back(std::move(plot));
    return plot_picture("Periodic tessellations of the cube with the least energy", plots);
}

StudyResult conclude_gersho3d(const Study& study, const StudyTable& runs) {
    std::vector<EnergyTally> tallies;
    for (const int n : study.sites) tallies.push_back(tally_energies(runs, n));
    StudyResult result;
    result.tables.push_back(energy_table(tallies));
    result.pictures.push_back(energy_plot(tallies));
    return result;
}

std::vector<int> first_numbers(int last) {
    std::vector<int> numbers;
    for (int n = 1; n <= last; ++n) numbers.push_back(n);
    return numbers;
}

}  // namespace

StudyRecipe gersho3d_recipe() {
    return {.name = "gersho3d",
            .description = "lowest energies in the cube beside those of lattices",
            .standard = Study{"gersho3d", first_numbers(64), 100, 0},
            .most_sites = 1000,
            .domain = "in the unit cube",
            .options = " --period 1,1,1 --tolerance 1e-8",
            .timed = false,
            .columns = {"stop", "iterations", "evaluations", "energy", "residual"},
            .notes = {"L-BFGS in the unit cube to a residual of 1e-8"},
            .tables = {""},
            .pictures = {""},
            .printed_columns = 8,
            .run = run_gersho3d,
            .conclude = conclude_gersho3d};
}

}  // namespace pcvt
