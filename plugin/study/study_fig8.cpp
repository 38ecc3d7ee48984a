#include <algorithm>
#include <utility>

#include "io/bytes/text.hpp"
#include "mesher/plane/cvt/clipped_cvt.hpp"
#include "mesher/plane/tessellation/tessellation.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

constexpr int kLloydIterations = 3000;
constexpr int kLbfgsIterations = 80;
constexpr double kStandardTolerance = 1e-8;
/// One of the few starts from which 80 iterations lead to only hexagons, as in the paper's picture.
constexpr std::uint64_t kAllHexagonSeed = 15;

std::string site_cell(const plane::Points& sites) {
    std::string text;
    for (const double x : sites.reshaped()) {
        if (!text.empty()) text += ' ';
        append_number(text, x);
    }
    return text;
}

plane::Points parse_sites(const std::string& cell) {
    LineScanner scanner("sites", cell);
    scanner.next();
    const auto& words = scanner.words();
    plane::Points sites(2, static_cast<Eigen::Index>(words.size() / 2));
    for (Eigen::Index k = 0; k < sites.size(); ++k) sites.data()[k] = scanner.number(words[k]);
    return sites;
}

StudyRow fig8_row(const std::string& panel, const RunStatistics& run, const plane::Points& sites) {
    StudyRow row{panel};
    for (std::string& cell : run_cells(run)) row.push_back(std::move(cell));
    row.push_back(site_cell(sites));
    return row;
}

StudyRow periodic_row(const std::string& panel, const plane::Points& start,
                      const plane::CvtOptions& options) {
    const plane::CvtResult result = compute_cvt(unit_square(), start, options);
    return fig8_row(panel, result.run,
                    plane::wrapped_sites(
                        {.delaunay = result.delaunay, .run = result.run, .counts = result.counts},
                        plane::Vec2::Zero()));
}

std::vector<StudyRow> run_fig8(int n, int /*run*/, std::uint64_t seed) {
    const plane::Points start = uniform_points(unit_square(), n, seed);
    const plane::ClippedCvt standard =
        compute_clipped_cvt(unit_square(), start, {kStandardTolerance});
    plane::CvtOptions lloyd;
    lloyd.run.solver = Solver::kLloyd;
    lloyd.run.tolerance = 0;
    lloyd.run.max_iterations = kLloydIterations;
    return {periodic_row("input", start, plain_lbfgs(0, 0)),
            fig8_row("standard", standard.run, standard.sites), periodic_row("lloyd", start, lloyd),
            periodic_row("lbfgs", start, plain_lbfgs(0, kLbfgsIterations))};
}

std::string title_of(const std::string& panel, const std::string& iterations) {
    if (panel == "input") return "input: periodic Voronoi diagram";
    if (panel == "standard") return "standard CVT, " + iterations + " L-BFGS iterations";
    if (panel == "lloyd") return "periodic CVT, " + iterations + " Lloyd iterations";
    return "periodic CVT, " + iterations + " L-BFGS iterations";
}

/// The diagram of the sites as given.
plane::CvtResult at_rest(const plane::Points& sites) {
    return compute_cvt(unit_square(), sites, plain_lbfgs(0, 0));
}

StudyResult conclude_fig8(const Study& /*study*/, const StudyTable& runs) {
    StudyTable table;
    table.notes = {"hexagons: cells with six sides; of the standard CVT they are not counted"};
    table.columns = {"n",      "seed",         "panel",    "iterations", "evaluations",
                     "energy", "energy/F_hex", "residual", "hexagons"};
    std::vector<CellPanel> panels;
    for (const StudyRow& row : runs.rows) {
        const auto cell = [&](const char* name) { return row[runs.column(name)]; };
        const plane::Points sites = parse_sites(cell("sites"));
        const bool standard = cell("panel") == "standard";
        const double ratio =
            runs.number(row, "energy") / f_hex(static_cast<int>(runs.number(row, "n")));
        CellPanel panel =
            standard ? clipped_panel(unit_square(), sites) : periodic_panel(at_rest(sites));
        const std::string hexagons =
            standard ? "-" : std::to_string(count_hexagons(at_rest(sites)));
        panel.caption = {title_of(cell("panel"), cell("iterations")),
                         "F = " + rounded(runs.number(row, "energy"), 6) + " = " +
                             rounded(ratio, 6) + " of the hexagonal bound"};
        if (!standard) panel.caption.push_back(hexagons + " hexagons of " + cell("n") + " cells");
        panels.push_back(std::move(panel));
        table.rows.push_back({cell("n"), cell("seed"), cell("panel"), cell("iterations"),
                              cell("evaluations"), rounded(runs.number(row, "energy"), 8),
                              rounded(ratio, 8), rounded(runs.number(row, "residual"), 3),
                              hexagons});
    }
    const Legend legend{"From random sites to the standard and the periodic CVT",
                        panel_legend(panels)};
    StudyResult result;
    result.tables.push_back(std::move(table));
    StudyPicture picture;
    picture.svg = encode_cell_panels(legend, panels, {2, 440});
    result.pictures.push_back(std::move(picture));
    return result;
}

}  // namespace

StudyRecipe fig8_recipe() {
    return {.name = "fig8",
            .description = "input, standard CVT, periodic CVT by Lloyd and by L-BFGS, as pictures",
            .standard = Study{"fig8", {150}, 1, kAllHexagonSeed},
            .most_sites = 3000,
            .timed = false,
            .columns = {"panel", "iterations", "evaluations", "energy", "residual", "sites"},
            .notes = {"standard: to a residual of 1e-8; lloyd: 3000 iterations; lbfgs: 80 "
                      "iterations; sites: x y of each, in the order of the input"},
            .tables = {""},
            .pictures = {""},
            .printed_columns = 9,
            .run = run_fig8,
            .conclude = conclude_fig8};
}

}  // namespace pcvt
