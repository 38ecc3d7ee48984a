#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "io/bytes/text.hpp"
#include "io/pictures/plot_svg.hpp"
#include "mesher/optimize/run_statistics.hpp"
#include "mesher/plane/search/lattice_certificate.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

constexpr double kFig11Tolerance = 1e-8;
/// Panels for each n; the table has all patterns.
constexpr std::size_t kMostPanels = 3;

std::vector<StudyRow> run_fig11(int n, int /*run*/, std::uint64_t seed) {
    const plane::Lattice unit = unit_square();
    const plane::CvtResult result =
        compute_cvt(unit, uniform_points(unit, n, seed), plain_lbfgs(kFig11Tolerance));
    const int hexagons = count_hexagons(result);
    StudyRow row{stop_name(result.run.stop)};
    for (std::string& cell : run_cells(result.run)) row.push_back(std::move(cell));
    row.push_back(std::to_string(hexagons));
    const auto lattice = hexagons == n ? as_lattice(result) : std::nullopt;
    if (lattice) {
        for (const int entry : {lattice->form.a, lattice->form.b, lattice->form.d}) {
            row.push_back(std::to_string(entry));
        }
    } else {
        row.insert(row.end(), 3, hexagons == n ? "none" : "");
    }
    return {row};
}

/// Equal for congruent lattices: the squared lengths and the scalar product of the reduced basis,
/// in n-ths of the square's side, hence integers.
using Shape = std::array<std::int64_t, 3>;

Shape shape_of(const plane::LatticePattern& pattern) {
    const auto dot = [](plane::Offset s, plane::Offset t) {
        return std::int64_t{s.i} * t.i + std::int64_t{s.j} * t.j;
    };
    const auto [a, b] = pattern.steps;
    return {dot(a, a), dot(b, b), std::abs(dot(a, b))};
}

/// All runs of one n that ended on congruent lattices.
struct Pattern {
    plane::LatticePattern lattice;
    int count = 0;
    std::string first_seed;
};

/// Statistics of the runs of one n.
struct PatternTally {
    int n = 0;
    int runs = 0;
    int all_hexagon = 0;
    /// All hexagons, but no lattice.
    std::vector<std::string> exceptions;
    double best_energy = 0;
    std::string best_seed;
    double mean_energy = 0;
    /// By falling count.
    std::vector<Pattern> patterns;

    double share() const { return static_cast<double>(all_hexagon) / runs; }
    double standard_error() const { return std::sqrt(share() * (1 - share()) / runs); }
};

int integer(const StudyTable& runs, const StudyRow& row, const char* column) {
    return parse_integer(row[runs.column(column)]);
}

void count_pattern(const StudyTable& runs, const StudyRow& row,
                   std::map<Shape, Pattern>& patterns) {
    const plane::LatticePattern lattice = lattice_pattern(
        unit_square(), {integer(runs, row, "a"), integer(runs, row, "b"), integer(runs, row, "d")});
    const auto [found, fresh] =
        patterns.try_emplace(shape_of(lattice), Pattern{lattice, 0, row[runs.column("seed")]});
    ++found->second.count;
}

PatternTally tally_patterns(const StudyTable& runs, int n) {
    PatternTally tally;
    tally.n = n;
    std::map<Shape, Pattern> patterns;
    for (const StudyRow& row : rows_of(runs, n)) {
        const double energy = runs.number(row, "energy");
        const std::string& seed = row[runs.column("seed")];
        ++tally.runs;
        tally.mean_energy += energy;
        if (tally.best_seed.empty() || energy < tally.best_energy * (1 - kSameEnergy)) {
            tally.best_energy = energy;
            tally.best_seed = seed;
        }
        if (integer(runs, row, "hexagons") != n) continue;
        ++tally.all_hexagon;
        if (row[runs.column("a")] == "none") {
            tally.exceptions.push_back(seed);
        } else {
            count_pattern(runs, row, patterns);
        }
    }
    tally.mean_energy /= tally.runs;
    for (const auto& [shape, pattern] : patterns) tally.patterns.push_back(pattern);
    std::stable_sort(tally.patterns.begin(), tally.patterns.end(),
                     [](const Pattern& p, const Pattern& q) { return p.count > q.count; });
    return tally;
}

StudyTable share_table(const std::vector<PatternTally>& tallies) {
    StudyTable table;
    table.notes = {
        "all_hexagon: runs whose cells all have six sides (edges under 1e-5 h not counted); "
        "percent of the runs and its standard error",
        "lattices: of these, the runs certified as a lattice; patterns: different ones up to "
        "congruence; F_lattice: energy of the best lattice of n sites"};
    table.columns = {"n",         "runs",      "all_hexagon", "percent",   "standard_error",
                     "lattices",  "patterns",  "best_energy", "best_seed", "mean_energy",
                     "F_lattice", "best/F_hex"};
    for (const PatternTally& tally : tallies) {
        const int exceptions = static_cast<int>(tally.exceptions.size());
        table.rows.push_back(
            {std::to_string(tally.n), std::to_string(tally.runs), std::to_string(tally.all_hexagon),
             rounded(100 * tally.share(), 4), rounded(100 * tally.standard_error(), 3),
             std::to_string(tally.all_hexagon - exceptions), std::to_string(tally.patterns.size()),
             rounded(tally.best_energy, 8), tally.best_seed, rounded(tally.mean_energy, 8),
             rounded(best_lattice(unit_square(), tally.n).energy, 8),
             rounded(tally.best_energy / f_hex(tally.n), 8)});
        for (const std::string& seed : tally.exceptions) {
            table.remarks.push_back("n = " + std::to_string(tally.n) + ", seed " + seed +
                                    ": all hexagons, but no lattice");
        }
    }
    if (table.remarks.empty()) {
        table.remarks = {
            "Every result with hexagons alone is a lattice; bases in the table -patterns."};
    }
    return table;
}

StudyTable pattern_table(const std::vector<PatternTally>& tallies) {
    StudyTable table;
    table.notes = {
        "the different lattices (up to congruence) that results with hexagons alone form",
        "a, b, d: the sites are those of the lattice spanned by (d, -b) / n and (0, a) / n; v, w: "
        "a "
        "reduced basis of it; first_seed: the first run that ended there"};
    table.columns = {"n",   "count",  "percent",      "a",         "b", "d", "v_x", "v_y", "w_x",
                     "w_y", "energy", "energy/F_hex", "first_seed"};
    for (const PatternTally& tally : tallies) {
        for (const Pattern& pattern : tally.patterns) {
            const plane::LatticePattern& lattice = pattern.lattice;
            StudyRow row{std::to_string(tally.n), std::to_string(pattern.count),
                         rounded(100.0 * pattern.count / tally.runs, 4)};
            for (const int entry : {lattice.form.a, lattice.form.b, lattice.form.d}) {
                row.push_back(std::to_string(entry));
            }
            for (const plane::Vec2& v : {lattice.basis.a(), lattice.basis.b()}) {
                row.push_back(in_full(v.x()));
                row.push_back(in_full(v.y()));
            }
            row.push_back(rounded(lattice.energy, 12));
            row.push_back(rounded(lattice.energy / f_hex(tally.n), 10));
            row.push_back(pattern.first_seed);
            table.rows.push_back(row);
        }
    }
    return table;
}

std::string percent(double share) { return rounded(100 * share, 3) + " %"; }

CellPanel pattern_panel(const PatternTally& tally, const Pattern& pattern) {
    const double share = static_cast<double>(pattern.count) / tally.runs;
    // A site in the middle shows the symmetry best.
    const plane::Points points = pattern_points(pattern.lattice).colwise() + plane::Vec2(0.5, 0.5);
    CellPanel panel = periodic_panel(compute_cvt(unit_square(), points, plain_lbfgs(0, 0)));
    panel.caption = {"n = " + std::to_string(tally.n) + ": " + percent(share),
                     "F / F_hex = " + rounded(pattern.lattice.energy / f_hex(tally.n), 6)};
    return panel;
}

/// The panel of the best result where none has only hexagons; repeats that run.
CellPanel best_panel(const PatternTally& tally) {
    const plane::Points start =
        uniform_points(unit_square(), tally.n, std::stoull(tally.best_seed));
    CellPanel panel =
        periodic_panel(compute_cvt(unit_square(), start, plain_lbfgs(kFig11Tolerance)));
    panel.caption = {"n = " + std::to_string(tally.n) + ": 0 %, the best",
                     "F / F_hex = " + rounded(tally.best_energy / f_hex(tally.n), 6)};
    return panel;
}

std::string gallery(const std::vector<PatternTally>& tallies) {
    std::vector<CellPanel> panels;
    for (const PatternTally& tally : tallies) {
        const std::size_t n_shown = std::min(tally.patterns.size(), kMostPanels);
        for (std::size_t k = 0; k < n_shown; ++k) {
            panels.push_back(pattern_panel(tally, tally.patterns[k]));
        }
        if (n_shown == 0) panels.push_back(best_panel(tally));
    }
    const Legend legend{"Periodic CVT with hexagons alone, and how often random starts end there",
                        panel_legend(panels)};
    return encode_cell_panels(legend, panels, {5, 190});
}

StudyPicture share_plot(std::vector<PatternTally> tallies) {
    std::sort(tallies.begin(), tallies.end(),
              [](const PatternTally& s, const PatternTally& t) { return s.n < t.n; });
    PlotSeries series{
        .mark = PlotSeries::Mark::kDots, .label = "", .colour = kPlotBlue, .points = {}};
    for (const PatternTally& tally : tallies) {
        series.points.emplace_back(tally.n, 100 * tally.share());
        series.errors.push_back(100 * tally.standard_error());
    }
    Plot plot{"Results with hexagons alone",
              {"number of sites n", true},
              {"percent of the runs, with the standard error", false},
              {}};
    plot.series.push_back(std::move(series));
    std::vector<Plot> plots;
    plots.push_back(std::move(plot));
    return plot_picture("Results with hexagons alone", plots);
}

StudyResult conclude_fig11(const Study& study, const StudyTable& runs) {
    std::vector<PatternTally> tallies;
    for (const int n : study.sites) tallies.push_back(tally_patterns(runs, n));
    StudyResult result;
    result.tables.push_back(share_table(tallies));
    result.tables.push_back(pattern_table(tallies));
    StudyPicture picture;
    picture.svg = gallery(tallies);
    result.pictures.push_back(std::move(picture));
    result.pictures.push_back(share_plot(tallies));
    return result;
}

}  // namespace

StudyRecipe fig11_recipe() {
    return {.name = "fig11",
            .description = "share of results with hexagons alone, and pictures of them",
            .standard = Study{"fig11", {4, 6, 11, 14, 16, 30, 56, 150}, 5000, 0},
            .most_sites = 3000,
            .timed = false,
            .columns = {"stop", "iterations", "evaluations", "energy", "residual", "hexagons", "a",
                        "b", "d"},
            .notes = {"plain L-BFGS to a residual of 1e-8; hexagons: cells with six edges longer "
                      "than 1e-5 h",
                      "a, b, d: where all cells are hexagons, the sites are those of the lattice "
                      "spanned by (d, -b) / n and (0, a) / n; none: they form no lattice"},
            .tables = {"", "-patterns"},
            .pictures = {"", "-shares"},
            .printed_columns = 12,
            .run = run_fig11,
            .conclude = conclude_fig11};
}

}  // namespace pcvt
