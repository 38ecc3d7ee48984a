#include <algorithm>
#include <ctime>
#include <utility>

#include "io/pictures/plot_svg.hpp"
#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

/// Shorter builds are repeated until their sum is at least this.
constexpr double kLeastSeconds = 0.01;

struct Method {
    const char* column;
    const char* label;
    const char* colour;
    void (*build)(const plane::Sites& sites);
};
const Method kMethods[] = {{"full_copies_s", "3 × 3 copies", kPlotOrange,
                            [](const plane::Sites& sites) { full_copies_diagram(sites); }},
                           {"mirrors_s", "mirrors (paper)", kPlotBlue,
                            [](const plane::Sites& sites) { mirror_diagram(sites); }},
                           {"delaunay_s", "Delaunay alone", kPlotGrey,
                            [](const plane::Sites& sites) { euclidean_delaunay(sites); }},
                           {"strips_s", "strips", kPlotGreen, [](const plane::Sites& sites) {
                                plane::MovingDelaunay delaunay(sites);
                            }}};

/// Processor seconds of one build: other processes on the machine have little influence on them.
double seconds_of(const Method& method, const plane::Sites& sites) {
    const auto used = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
    const double start = used();
    double seconds = 0;
    int builds = 0;
    while (seconds < kLeastSeconds) {
        method.build(sites);
        ++builds;
        seconds = used() - start;
    }
    return seconds / builds;
}

std::vector<StudyRow> run_fig7(int n, int /*run*/, std::uint64_t seed) {
    const plane::Sites sites(unit_square(), uniform_points(unit_square(), n, seed));
    StudyRow row;
    for (const Method& method : kMethods) row.push_back(in_full(seconds_of(method, sites)));
    return {row};
}

double median(const StudyTable& runs, int n, const std::string& column) {
    std::vector<double> values;
    for (const StudyRow& row : rows_of(runs, n)) values.push_back(runs.number(row, column));
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

StudyResult conclude_fig7(const Study& study, const StudyTable& runs) {
    StudyTable table;
    table.notes = {
        "seconds of one processor, median of " + std::to_string(study.runs) +
            " runs; times differ from run to run and from machine to machine",
        "full_copies_s: Delaunay triangulation of 3 x 3 copies; mirrors_s: the paper's method; "
        "delaunay_s: Euclidean Delaunay triangulation of the n sites; strips_s: what pcvt mesh "
        "does",
        "all but strips_s run CGAL on exact predicates for periodic images"};
    table.columns = {"n"};
    Plot plot{"Periodic Voronoi diagram: time against the number of sites",
              {"number of sites n", true},
              {"seconds of one processor", true},
              {}};
    for (const Method& method : kMethods) {
        table.columns.emplace_back(method.column);
        plot.series.push_back({.mark = PlotSeries::Mark::kLineAndDots,
                               .label = method.label,
                               .colour = method.colour,
                               .points = {}});
    }
    table.columns.emplace_back("full_copies/mirrors");
    for (const int n : study.sites) {
        StudyRow row{std::to_string(n)};
        for (std::size_t k = 0; k < std::size(kMethods); ++k) {
            const double seconds = median(runs, n, kMethods[k].column);
            row.push_back(rounded(seconds, 4));
            plot.series[k].points.emplace_back(n, seconds);
        }
        row.push_back(rounded(median(runs, n, "full_copies_s") / median(runs, n, "mirrors_s"), 3));
        table.rows.push_back(row);
    }
    StudyResult result;
    result.tables.push_back(std::move(table));
    std::vector<Plot> plots;
    plots.push_back(std::move(plot));
    result.pictures.push_back(plot_picture("PVD time against n", plots));
    return result;
}

}  // namespace

StudyRecipe fig7_recipe() {
    StudyRecipe recipe{
        .name = "fig7",
        .description = "time of the periodic Voronoi diagram against n",
        .standard = Study{"fig7", {100, 316, 1000, 3162, 10000, 31623, 100000}, 3, 0},
        .most_sites = 10'000'000,
        .timed = true,
        .columns = {},
        .notes = {"seconds of one processor for each method; they differ from run to run"},
        .tables = {""},
        .pictures = {""},
        .printed_columns = 6,
        .run = run_fig7,
        .conclude = conclude_fig7};
    for (const Method& method : kMethods) recipe.columns.emplace_back(method.column);
    return recipe;
}

}  // namespace pcvt
