#include <algorithm>
#include <cmath>
#include <utility>

#include "io/pictures/plot_svg.hpp"
#include "mesher/plane/delaunay/mirror_diagram.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

/// The fewest sites that the fit takes: at n = 1 all eight neighbours are mirrors.
constexpr int kFewestFitted = 100;

std::vector<StudyRow> run_fig10(int n, int /*run*/, std::uint64_t seed) {
    const plane::MirrorDiagram diagram =
        mirror_diagram(plane::Sites(unit_square(), uniform_points(unit_square(), n, seed)));
    return {{std::to_string(diagram.n_mirrors), std::to_string(diagram.n_boundary_sites),
             std::to_string(diagram.n_shrunk_inner_sites)}};
}

/// Mean, extremes and spread of one column.
struct Spread {
    double mean = 0;
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
};

Spread spread(const StudyTable& runs, int n, const std::string& column) {
    const std::vector<StudyRow> rows = rows_of(runs, n);
    Spread spread;
    for (const StudyRow& row : rows) {
        const double value = runs.number(row, column);
        spread.mean += value / static_cast<double>(rows.size());
        spread.least = std::min(spread.least, value);
        spread.most = std::max(spread.most, value);
    }
    return spread;
}

/// c of mirrors = c sqrt(n) by the mean of the logarithms; 0 where no n is large enough.
double fit(const Study& study, const StudyTable& runs) {
    double sum = 0;
    int count = 0;
    for (const int n : study.sites) {
        if (n < kFewestFitted) continue;
        sum += std::log(spread(runs, n, "mirrors").mean / std::sqrt(n));
        ++count;
    }
    return count == 0 ? 0 : std::exp(sum / count);
}

StudyRow fig10_row(const StudyTable& runs, int n) {
    const Spread mirrors = spread(runs, n, "mirrors");
    return {std::to_string(n),
            rounded(mirrors.mean, 6),
            rounded(mirrors.least, 8),
            rounded(mirrors.most, 8),
            rounded(100 * mirrors.mean / n, 4),
            rounded(mirrors.mean / std::sqrt(n), 4),
            rounded(spread(runs, n, "boundary_sites").mean, 6),
            rounded(spread(runs, n, "shrunk_inner_sites").mean, 6)};
}

StudyResult conclude_fig10(const Study& study, const StudyTable& runs) {
    StudyTable table;
    table.notes = {
        "means over " + std::to_string(study.runs) +
            " runs; percent: mirrors of n; full copies "
            "would be 8 n mirrors",
        "shrunk_inner: sites that the paper calls inner, whose cell a mirror cuts all the same"};
    table.columns = {"n",       "mirrors",         "least",          "most",
                     "percent", "mirrors/sqrt(n)", "boundary_sites", "shrunk_inner"};
    PlotSeries counts{
        .mark = PlotSeries::Mark::kDots, .label = "mirrors", .colour = kPlotBlue, .points = {}};
    PlotSeries shares{
        .mark = PlotSeries::Mark::kDots, .label = "mirrors / n", .colour = kPlotBlue, .points = {}};
    std::vector<int> sites = study.sites;
    std::sort(sites.begin(), sites.end());
    for (const int n : study.sites) table.rows.push_back(fig10_row(runs, n));
    for (const int n : sites) {
        const double mirrors = spread(runs, n, "mirrors").mean;
        if (!(mirrors > 0)) {
            throw InvalidInput("the runs of n = " + std::to_string(n) +
                               " have no mirrors; the table is damaged, make it again");
        }
        counts.points.emplace_back(n, mirrors);
        shares.points.emplace_back(n, 100 * mirrors / n);
    }
    Plot mirrors_plot{
        "Mirrors against the number of sites", {"number of sites n", true}, {"mirrors", true}, {}};
    Plot share_plot{"Their share", {"number of sites n", true}, {"percent of the sites", true}, {}};
    std::vector<Plot> plots;
    plots.push_back(std::move(mirrors_plot));
    plots.push_back(std::move(share_plot));
    if (const double c = fit(study, runs); c > 0) {
        PlotSeries root{.mark = PlotSeries::Mark::kDashes,
                        .label = rounded(c, 3) + " √n",
                        .colour = kPlotGrey,
                        .points = {}};
        PlotSeries share{.mark = PlotSeries::Mark::kDashes,
                         .label = rounded(100 * c, 3) + " / √n",
                         .colour = kPlotGrey,
                         .points = {}};
        for (const int n : {sites.front(), sites.back()}) {
            root.points.emplace_back(n, c * std::sqrt(n));
            share.points.emplace_back(n, 100 * c / std::sqrt(n));
        }
        plots[0].series.push_back(root);
        plots[1].series.push_back(share);
        table.remarks = {"mirrors = " + rounded(c, 4) +
                         " sqrt(n), fitted from n = " + std::to_string(kFewestFitted) + " on"};
    }
    plots[0].series.push_back(counts);
    plots[1].series.push_back(shares);
    StudyResult result;
    result.tables.push_back(std::move(table));
    result.pictures.push_back(plot_picture("Mirrors against n", plots));
    return result;
}

}  // namespace

StudyRecipe fig10_recipe() {
    return {.name = "fig10",
            .description = "mirrors of the paper's method against n",
            .standard = Study{"fig10", {10, 32, 100, 316, 1000, 3162, 10000, 31623, 100000}, 10, 0},
            .most_sites = 10'000'000,
            .timed = false,
            .columns = {"mirrors", "boundary_sites", "shrunk_inner_sites"},
            .notes = {},
            .tables = {""},
            .pictures = {""},
            .printed_columns = 8,
            .run = run_fig10,
            .conclude = conclude_fig10};
}

}  // namespace pcvt
