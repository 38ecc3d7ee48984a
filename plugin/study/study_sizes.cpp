#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/pictures/plot_svg.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/cvt/size_summary.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/mesh/cell_measures.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/space/cvt/volume_cvt.hpp"
#include "mesher/space/mesh/cell_measures.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

/// A law, as --areas and --volumes take it, with the title of its plot.
struct StudiedLaw {
    const char* word;
    const char* title;
};
constexpr std::array kPlaneLaws{StudiedLaw{"equal", "Equal areas"},
                                StudiedLaw{"lognormal:0.42", "Lognormal, spread 0.42"},
                                StudiedLaw{"gamma:0.3", "Gamma, spread 0.3"}};
constexpr std::array kSpaceLaws{
    StudiedLaw{"equal", "Equal volumes"}, StudiedLaw{"lognormal:0.35", "Lognormal, spread 0.35"},
    StudiedLaw{"gamma:0.42", "Gamma, spread 0.42"},
    StudiedLaw{"0.7*lognormal:0.3@1+0.3*lognormal:0.2@3", "Mixture of two lognormal laws"}};

/// Round grains, as --max-iterations 5 gives them.
constexpr int kCentroidalSteps = 5;
/// Diameters over their mean: bin k holds those nearest to k kBinWidth, the last one all above too.
constexpr double kBinWidth = 0.1;
constexpr int kBins = 31;

/// The cells of one run, and their target sizes.
struct Grains {
    Eigen::VectorXd targets;
    CellTable cells;
};

Grains plane_grains(const AreaLaw& law, int n, std::uint64_t seed) {
    const plane::Lattice unit = unit_square();
    Eigen::VectorXd areas = scaled_areas(draw_areas(law, n, seed), n, unit.area());
    const plane::AreaCvtResult result =
        compute_area_cvt(unit, uniform_points(unit, n, seed),
                         {.areas = areas, .run = {.max_iterations = kCentroidalSteps}});
    return {std::move(areas), cell_table(cell_mesh(result.delaunay))};
}

Grains space_grains(const AreaLaw& law, int n, std::uint64_t seed) {
    const space::Lattice cube = space::Lattice::box(1, 1, 1);
    const Eigen::VectorXd volumes = scaled_volumes(draw_volumes(law, n, seed), n, cube.volume());
    const space::VolumeCvtResult result =
        compute_volume_cvt(cube, uniform_points(cube, n, seed),
                           {.volumes = volumes,
                            .by_rank = true,
                            .run = {.max_iterations = kCentroidalSteps, .n_threads = 1}});
    const space::PeriodicDelaunay& regular = result.delaunay;
    return {result.targets, space::cell_table(space::cell_complex(regular.sites, regular.tetrahedra,
                                                                  regular.weights))};
}

/// The study in the plane or in space.
struct SizeStudy {
    std::span<const StudiedLaw> laws;
    Grains (*run)(const AreaLaw& law, int n, std::uint64_t seed);
    /// Columns after those that both studies have: mean and standard deviation of the roundness.
    std::vector<std::string> shape_columns;
    /// Of the note on the tables.
    std::string spread_note;
    std::string error_note;
    std::string title;
};

const SizeStudy& plane_study() {
    static const SizeStudy study{kPlaneLaws,
                                 plane_grains,
                                 {},
                                 "2 sqrt(area / pi)",
                                 "largest_error: of an area, over the wanted area",
                                 "Sizes of cells, wanted and reached"};
    return study;
}

const SizeStudy& space_study() {
    static const SizeStudy study{
        kSpaceLaws,
        space_grains,
        {"sphericity", "sphericity_std"},
        "(6 volume / pi)^(1/3)",
        "largest_error: of a volume, over the mean volume; sphericity, sphericity_std: mean and "
        "standard deviation over the cells of pi^(1/3) (6 volume)^(2/3) / surface, means of the "
        "runs",
        "Sizes of grains in space, wanted and reached"};
    return study;
}

std::vector<int> histogram_of_diameters(std::vector<double> diameters) {
    const double mean = std::accumulate(diameters.begin(), diameters.end(), 0.0) /
                        static_cast<double>(diameters.size());
    std::vector<int> counts(kBins);
    for (const double diameter : diameters) {
        ++counts[std::min(std::lround(diameter / mean / kBinWidth), long{kBins - 1})];
    }
    return counts;
}

std::vector<StudyRow> rows_of_law(const SizeStudy& study, const StudiedLaw& law, int n,
                                  std::uint64_t seed) {
    const auto [targets, cells] = study.run(parse_area_law(law.word), n, seed);
    CellTable aims{.dimension = cells.dimension,
                   .measure = {targets.begin(), targets.end()},
                   .surface = {},
                   .sides = {},
                   .neighbours = {}};
    std::vector<double> wanted;
    std::vector<double> reached;
    double error = 0;
    for (SiteId s = 0; s < n; ++s) {
        wanted.push_back(aims.equivalent_diameter(s));
        reached.push_back(cells.equivalent_diameter(s));
        const double whole = cells.dimension == 3 ? targets.mean() : targets[s];
        error = std::max(error, std::abs(cells.measure[s] - targets[s]) / whole);
    }
    StudyRow figures{rounded(error, 3)};
    if (!study.shape_columns.empty()) {
        const SizeSummary summary = size_summary({}, cells, {}, targets.sum());
        figures.push_back(rounded(summary.roundness_mean, 4));
        figures.push_back(rounded(summary.roundness_std, 3));
    }
    const std::vector<int> n_wanted = histogram_of_diameters(wanted);
    const std::vector<int> n_reached = histogram_of_diameters(reached);
    std::vector<StudyRow> rows;
    for (int k = 0; k < kBins; ++k) {
        StudyRow row{law.word, rounded(k * kBinWidth, 3), std::to_string(n_wanted[k]),
                     std::to_string(n_reached[k])};
        row.insert(row.end(), figures.begin(), figures.end());
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<StudyRow> run_sizes(const SizeStudy& study, int n, std::uint64_t seed) {
    std::vector<StudyRow> rows;
    for (const StudiedLaw& law : study.laws) {
        for (StudyRow& row : rows_of_law(study, law, n, seed)) rows.push_back(std::move(row));
    }
    return rows;
}

/// The sums of all runs of one law and one n, by bin.
struct Sizes {
    std::array<double, kBins> wanted{};
    std::array<double, kBins> reached{};
    double largest_error = 0;
    /// Means of SizeStudy::shape_columns.
    std::vector<double> shapes;

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
Sizes sizes_of(const SizeStudy& study, const StudyTable& runs, const StudiedLaw& law, int n,
               int n_runs) {
    Sizes sizes{.shapes = std::vector<double>(study.shape_columns.size())};
    for (const StudyRow& row : rows_of(runs, n)) {
        if (row[runs.column("law")] != law.word) continue;
        const auto bin = static_cast<std::size_t>(
            std::clamp(runs.number(row, "diameter") / kBinWidth + 0.5, 0.0, kBins - 0.5));
        sizes.wanted[bin] += runs.number(row, "wanted");
        sizes.reached[bin] += runs.number(row, "reached");
        sizes.largest_error = std::max(sizes.largest_error, runs.number(row, "largest_error"));
        for (std::size_t k = 0; k < sizes.shapes.size(); ++k) {
            sizes.shapes[k] += runs.number(row, study.shape_columns[k]) / (n_runs * kBins);
        }
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

StudyResult conclude_sizes(const SizeStudy& of, const Study& study, const StudyTable& runs) {
    constexpr std::array kColours{kPlotBlue, kPlotOrange, kPlotGreen, kPlotGrey};
    StudyTable table;
    table.notes = {
        "spread: standard deviation over mean of the diameters " + of.spread_note +
            ", from bins of 0.1 mean diameters",
        of.error_note +
            "; largest_difference: between the distribution functions wanted and reached, percent "
            "of the cells"};
    table.columns = {"law",
                     "n",
                     "runs",
                     "spread_wanted",
                     "spread_reached",
                     "largest_error",
                     "largest_difference"};
    table.columns.insert(table.columns.end(), of.shape_columns.begin(), of.shape_columns.end());
    std::vector<Plot> plots;
    for (const StudiedLaw& law : of.laws) {
        Plot plot{.title = law.title,
                  .x = {"diameter over the mean", false},
                  .y = {"percent of the cells; lines: wanted, dots: reached", false},
                  .series = {}};
        for (std::size_t k = 0; k < study.sites.size(); ++k) {
            const int n = study.sites[k];
            const Sizes sizes = sizes_of(of, runs, law, n, study.runs);
            StudyRow row({law.word, std::to_string(n), std::to_string(study.runs),
                          rounded(spread_of(sizes.wanted), 4), rounded(spread_of(sizes.reached), 4),
                          rounded(sizes.largest_error, 3), rounded(sizes.largest_difference(), 3)});
            for (const double mean : sizes.shapes) row.push_back(rounded(mean, 4));
            table.rows.push_back(std::move(row));
            add_series(sizes, n, kColours[k % kColours.size()], plot);
        }
        plots.push_back(plot);
    }
    StudyResult result;
    result.tables.push_back(std::move(table));
    result.pictures.push_back(plot_picture(of.title, plots));
    return result;
}

}  // namespace

StudyRecipe sizes_recipe() {
    return {.name = "sizes",
            .description = "diameters of cells of prescribed areas, wanted and reached",
            .standard = Study{"sizes", {100, 1000, 10000}, 1, 0},
            .most_sites = 1'000'000,
            .options = " --areas LAW --max-iterations 5",
            .timed = false,
            .columns = {"law", "diameter", "wanted", "reached", "largest_error"},
            .notes = {"law: as --areas takes it; diameter: the middle of a bin, over the mean; "
                      "wanted, reached: cells in the bin, after 5 centroidal steps",
                      "largest_error: the largest error of an area over the wanted one"},
            .tables = {""},
            .pictures = {""},
            .printed_columns = 7,
            .run = [](int n, int /*run*/,
                      std::uint64_t seed) { return run_sizes(plane_study(), n, seed); },
            .conclude =
                [](const Study& study, const StudyTable& runs) {
                    return conclude_sizes(plane_study(), study, runs);
                }};
}

StudyRecipe sizes3d_recipe() {
    return {.name = "sizes3d",
            .description = "diameters and shapes of cells of prescribed volumes in the cube",
            .standard = Study{"sizes3d", {100, 1000, 4000}, 1, 0},
            .most_sites = 1'000'000,
            .domain = "in the unit cube",
            .options = " --period 1,1,1 --volumes LAW --max-iterations 5",
            .timed = false,
            .columns = {"law", "diameter", "wanted", "reached", "largest_error", "sphericity",
                        "sphericity_std"},
            .notes = {"law: as --volumes takes it; diameter: the middle of a bin, over the mean; "
                      "wanted, reached: cells in the bin, after 5 centroidal steps",
                      "largest_error: the largest error of a volume over the mean volume; "
                      "sphericity, sphericity_std: of the cells of the law"},
            .tables = {""},
            .pictures = {""},
            .printed_columns = 9,
            .run = [](int n, int /*run*/,
                      std::uint64_t seed) { return run_sizes(space_study(), n, seed); },
            .conclude =
                [](const Study& study, const StudyTable& runs) {
                    return conclude_sizes(space_study(), study, runs);
                }};
}

}  // namespace pcvt
