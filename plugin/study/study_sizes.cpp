#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "io/bytes/text.hpp"
#include "io/pictures/plot_svg.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

/// The laws, as --areas takes them, with the titles of their plots.
struct StudiedLaw {
    const char* word;
    const char* title;
};
constexpr std::array kLaws{StudiedLaw{"equal", "Equal areas"},
                           StudiedLaw{"lognormal:0.42", "Lognormal, spread 0.42"},
                           StudiedLaw{"gamma:0.3", "Gamma, spread 0.3"}};

/// Round grains, as --max-iterations 5 gives them.
constexpr int kCentroidalSteps = 5;
/// Diameters over their mean: bin k holds those nearest to k kBinWidth, the last one all above too.
constexpr double kBinWidth = 0.1;
constexpr int kBins = 31;

std::vector<int> histogram_of_diameters(std::vector<double> diameters) {
    const double mean = std::accumulate(diameters.begin(), diameters.end(), 0.0) /
                        static_cast<double>(diameters.size());
    std::vector<int> counts(kBins);
    for (const double diameter : diameters) {
        ++counts[std::min(std::lround(diameter / mean / kBinWidth), long{kBins - 1})];
    }
    return counts;
}

std::vector<StudyRow> rows_of_law(const StudiedLaw& law, int n, std::uint64_t seed) {
    const plane::Lattice unit = unit_square();
    const Eigen::VectorXd areas =
        scaled_areas(draw_areas(parse_area_law(law.word), n, seed), n, unit.area());
    const plane::AreaCvtResult result =
        compute_area_cvt(unit, uniform_points(unit, n, seed),
                         {.areas = areas, .run = {.max_iterations = kCentroidalSteps}});
    const CellTable cells = cell_table(cell_mesh(result.delaunay));
    std::vector<double> wanted;
    std::vector<double> reached;
    double error = 0;
    for (SiteId s = 0; s < n; ++s) {
        wanted.push_back(2 * std::sqrt(areas[s] / std::numbers::pi));
        reached.push_back(cells.equivalent_diameter(s));
        error = std::max(error, std::abs(cells.measure[s] - areas[s]) / areas[s]);
    }
    const std::vector<int> n_wanted = histogram_of_diameters(wanted);
    const std::vector<int> n_reached = histogram_of_diameters(reached);
    std::vector<StudyRow> rows;
    for (int k = 0; k < kBins; ++k) {
        rows.push_back({law.word, rounded(k * kBinWidth, 3), std::to_string(n_wanted[k]),
                        std::to_string(n_reached[k]), rounded(error, 3)});
    }
    return rows;
}

std::vector<StudyRow> run_sizes(int n, int /*run*/, std::uint64_t seed) {
    std::vector<StudyRow> rows;
    for (const StudiedLaw& law : kLaws) {
        for (StudyRow& row : rows_of_law(law, n, seed)) rows.push_back(std::move(row));
    }
    return rows;
}

/// The sums of all runs of one law and one n, by bin.
struct Sizes {
    std::array<double, kBins> wanted{};
    std::array<double, kBins> reached{};
    double largest_error = 0;

    double n_cells() const { return std::accumulate(wanted.begin(), wanted.end(), 0.0); }
    double percent(const std::array<double, kBins>& counts, int bin) const {
        return 100 * counts[static_cast<std::size_t>(bin)] / n_cells();
    }
    /// The largest difference between the two distribution functions, in percent.
    double largest_difference() const {
        double sum = 0;
        double largest = 0;
        for (int k = 0; k < kBins; ++k) {
            sum += percent(reached, k) - percent(wanted, k);
            largest = std::max(largest, std::abs(sum));
        }
        return largest;
    }
};

/// @throws InvalidInput if the bins of a damaged table do not hold the cells of all runs.
Sizes sizes_of(const StudyTable& runs, const StudiedLaw& law, int n, int n_runs) {
    Sizes sizes;
    for (const StudyRow& row : rows_of(runs, n)) {
        if (row[runs.column("law")] != law.word) continue;
        const auto bin = static_cast<std::size_t>(
            std::clamp(runs.number(row, "diameter") / kBinWidth + 0.5, 0.0, kBins - 0.5));
        sizes.wanted[bin] += runs.number(row, "wanted");
        sizes.reached[bin] += runs.number(row, "reached");
        sizes.largest_error = std::max(sizes.largest_error, runs.number(row, "largest_error"));
    }
    for (const auto* counts : {&sizes.wanted, &sizes.reached}) {
        const double sum = std::accumulate(counts->begin(), counts->end(), 0.0);
        const bool is_whole = sum == double(n) * n_runs && (*counts)[0] != sum &&
                              *std::min_element(counts->begin(), counts->end()) >= 0;
        if (is_whole) continue;
        throw InvalidInput(std::string("the bins of ") + law.word + " do not hold " +
                           std::to_string(n) + " cells a run; the table is damaged, make it again");
    }
    return sizes;
}

/// Mean and standard deviation over mean of the diameters, by the middles of the bins.
double spread_of(const std::array<double, kBins>& counts) {
    double sum = 0;
    double mean = 0;
    double squares = 0;
    for (int k = 0; k < kBins; ++k) {
        const double count = counts[static_cast<std::size_t>(k)];
        sum += count;
        mean += count * k * kBinWidth;
        squares += count * k * kBinWidth * k * kBinWidth;
    }
    mean /= sum;
    return std::sqrt(std::max(0.0, squares / sum - mean * mean)) / mean;
}

/// Wanted as a line, reached as dots on it.
void add_series(const Sizes& sizes, int n, const char* colour, Plot& plot) {
    PlotSeries wanted{.mark = PlotSeries::Mark::kLine, .label = "", .colour = colour, .points = {}};
    PlotSeries reached{.mark = PlotSeries::Mark::kDots,
                       .label = "n = " + std::to_string(n),
                       .colour = colour,
                       .points = {}};
    for (int k = 0; k < kBins; ++k) {
        const double diameter = k * kBinWidth;
        wanted.points.emplace_back(diameter, sizes.percent(sizes.wanted, k));
        if (sizes.reached[static_cast<std::size_t>(k)] == 0) continue;
        reached.points.emplace_back(diameter, sizes.percent(sizes.reached, k));
    }
    plot.series.push_back(wanted);
    plot.series.push_back(reached);
}

StudyResult conclude_sizes(const Study& study, const StudyTable& runs) {
    constexpr std::array kColours{kPlotBlue, kPlotOrange, kPlotGreen, kPlotGrey};
    StudyTable table;
    table.notes = {
        "spread: standard deviation over mean of the diameters 2 sqrt(area / pi), from bins of "
        "0.1 mean diameters",
        "largest_error: of an area, over the wanted area; largest_difference: between the "
        "distribution functions wanted and reached, percent of the cells"};
    table.columns = {"law",
                     "n",
                     "runs",
                     "spread_wanted",
                     "spread_reached",
                     "largest_error",
                     "largest_difference"};
    std::vector<Plot> plots;
    for (const StudiedLaw& law : kLaws) {
        Plot plot{.title = law.title,
                  .x = {"diameter over the mean", false},
                  .y = {"percent of the cells; lines: wanted, dots: reached", false},
                  .series = {}};
        for (std::size_t k = 0; k < study.sites.size(); ++k) {
            const int n = study.sites[k];
            const Sizes sizes = sizes_of(runs, law, n, study.runs);
            table.rows.push_back(
                {law.word, std::to_string(n), std::to_string(study.runs),
                 rounded(spread_of(sizes.wanted), 4), rounded(spread_of(sizes.reached), 4),
                 rounded(sizes.largest_error, 3), rounded(sizes.largest_difference(), 3)});
            add_series(sizes, n, kColours[k % kColours.size()], plot);
        }
        plots.push_back(plot);
    }
    StudyResult result;
    result.tables.push_back(std::move(table));
    result.pictures.push_back(plot_picture("Sizes of cells, wanted and reached", plots));
    return result;
}

}  // namespace

StudyRecipe sizes_recipe() {
    return {.name = "sizes",
            .description = "diameters of cells of prescribed areas, wanted and reached",
            .standard = Study{"sizes", {100, 1000, 10000}, 1, 0},
            .most_sites = 1'000'000,
            .timed = false,
            .columns = {"law", "diameter", "wanted", "reached", "largest_error"},
            .notes = {"law: as --areas takes it; diameter: the middle of a bin, over the mean; "
                      "wanted, reached: cells in the bin, after 5 centroidal steps",
                      "largest_error: the largest error of an area over the wanted one"},
            .tables = {""},
            .pictures = {""},
            .printed_columns = 7,
            .run = run_sizes,
            .conclude = conclude_sizes};
}

}  // namespace pcvt
