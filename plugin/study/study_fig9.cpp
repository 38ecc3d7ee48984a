#include <utility>

#include "io/pictures/plot_svg.hpp"
#include "mesher/plane/cvt/clipped_cvt.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

constexpr double kFig9Tolerance = 1e-6;
constexpr int kMostIterations = 200;

std::vector<StudyRow> run_fig9(int n, int /*run*/, std::uint64_t seed) {
    const plane::Lattice unit = unit_square();
    const plane::Points start = uniform_points(unit, n, seed);
    std::vector<StudyRow> rows;
    const auto note = [&rows](const char* method) {
        return [&rows, method](const Progress& progress) {
            rows.push_back({method, std::to_string(progress.iteration),
                            std::to_string(progress.evaluations), in_full(progress.value),
                            in_full(progress.residual)});
            return true;
        };
    };
    plane::CvtOptions options = plain_lbfgs(kFig9Tolerance, kMostIterations);
    options.run.progress = note("periodic");
    compute_cvt(unit, start, options);
    compute_clipped_cvt(unit, start, {kFig9Tolerance, kMostIterations, note("standard")});
    return rows;
}

PlotSeries series_of(const StudyTable& runs, const std::vector<StudyRow>& rows,
                     const std::string& method, const char* colour) {
    PlotSeries series{
        .mark = PlotSeries::Mark::kLine, .label = method + " CVT", .colour = colour, .points = {}};
    for (const StudyRow& row : rows) {
        if (row[runs.column("method")] != method) continue;
        series.points.emplace_back(runs.number(row, "iteration"), runs.number(row, "energy"));
    }
    return series;
}

/// The plot with F / F_hex - 1 in place of F.
/// @throws InvalidInput if an energy of a damaged table is not above F_hex.
Plot excess_plot(int n, const Plot& energies) {
    Plot plot{std::to_string(n) + " sites, above the hexagonal bound",
              {"iteration", false},
              {"F / F_hex - 1", true},
              {}};
    for (const PlotSeries& series : energies.series) {
        plot.series.push_back(series);
        for (plane::Vec2& point : plot.series.back().points) {
            point.y() = point.y() / f_hex(n) - 1;
            if (point.y() > 0) continue;
            throw InvalidInput("an energy of " + std::to_string(n) +
                               " sites is not above the hexagonal bound; the table is damaged, "
                               "make it again");
        }
    }
    return plot;
}

/// The rows of run 0 of one n.
std::vector<StudyRow> first_run(const StudyTable& runs, int n) {
    std::vector<StudyRow> rows = rows_of(runs, n);
    std::erase_if(rows, [&](const StudyRow& row) { return row[runs.column("run")] != "0"; });
    return rows;
}

/// The row at which a method ended.
const StudyRow& last_row(const StudyTable& runs, const std::vector<StudyRow>& rows, int n,
                         const char* method) {
    const auto last = std::find_if(rows.rbegin(), rows.rend(), [&](const StudyRow& row) {
        return row[runs.column("method")] == method;
    });
    if (last != rows.rend()) return *last;
    throw InvalidInput("run 0 of " + std::to_string(n) + " sites has no row of the method " +
                       method + "; the table is damaged, make it again");
}

/// A remark: at how many of the common iterations the periodic energy is the smaller one.
std::string comparison(int n, const PlotSeries& standard, const PlotSeries& periodic) {
    std::size_t below = 0;
    const std::size_t common = std::min(standard.points.size(), periodic.points.size());
    for (std::size_t k = 0; k < common; ++k) {
        below += periodic.points[k].y() < standard.points[k].y() ? 1 : 0;
    }
    return "n = " + std::to_string(n) + ": the periodic energy is the smaller one at " +
           std::to_string(below) + " of " + std::to_string(common) + " common iterations";
}

StudyResult conclude_fig9(const Study& study, const StudyTable& runs) {
    StudyTable table;
    table.notes = {"the ends of run 0 of each n; energies by iteration stand in the -runs table"};
    table.columns = {"n",      "method",       "iterations", "evaluations",
                     "energy", "energy/F_hex", "residual"};
    std::vector<Plot> plots;
    std::vector<Plot> excess;
    for (const int n : study.sites) {
        const std::vector<StudyRow> rows = first_run(runs, n);
        Plot plot{std::to_string(n) + " sites, energy by iteration",
                  {"iteration", false},
                  {"energy F", false},
                  {}};
        plot.series = {series_of(runs, rows, "standard", kPlotOrange),
                       series_of(runs, rows, "periodic", kPlotBlue)};
        for (const char* method : {"standard", "periodic"}) {
            const StudyRow& last = last_row(runs, rows, n, method);
            const double energy = runs.number(last, "energy");
            table.rows.push_back({std::to_string(n), method, last[runs.column("iteration")],
                                  last[runs.column("evaluations")], rounded(energy, 8),
                                  rounded(energy / f_hex(n), 8),
                                  rounded(runs.number(last, "residual"), 3)});
        }
        table.remarks.push_back(comparison(n, plot.series[0], plot.series[1]));
        excess.push_back(excess_plot(n, plot));
        const double longest =
            std::max(plot.series[0].points.back().x(), plot.series[1].points.back().x());
        plot.series.push_back(
            {.mark = PlotSeries::Mark::kDashes,
             .label = "hexagonal bound",
             .colour = kPlotGrey,
             .points = {plane::Vec2(0, f_hex(n)), plane::Vec2(longest, f_hex(n))}});
        plots.push_back(std::move(plot));
    }
    StudyResult result;
    result.tables.push_back(std::move(table));
    result.pictures.push_back(plot_picture("CVT energy by iteration", plots));
    result.pictures.push_back(plot_picture("CVT energy above the hexagonal bound", excess));
    return result;
}

}  // namespace

StudyRecipe fig9_recipe() {
    return {.name = "fig9",
            .description = "energy by iteration, standard against periodic CVT",
            .standard = Study{"fig9", {30, 150}, 1, 0},
            .most_sites = 3000,
            .timed = false,
            .columns = {"method", "iteration", "evaluations", "energy", "residual"},
            .notes = {"plain L-BFGS from the same start, to a residual of 1e-6 or 200 iterations"},
            .tables = {""},
            .pictures = {"", "-excess"},
            .printed_columns = 7,
            .run = run_fig9,
            .conclude = conclude_fig9};
}

}  // namespace pcvt
