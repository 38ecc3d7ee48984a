#include <algorithm>
#include <array>
#include <limits>

#include "mesher/plane/symmetry/symmetric_sites.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

constexpr double kSymmetryTolerance = 1e-6;
constexpr int kPanelColumns = 6;
constexpr double kPanelSize = 150;

/// The positions that a run occupies: only general ones, or also the centres of the highest order.
struct Occupation {
    const char* word;
    bool centres;
};
constexpr std::array kOccupations{Occupation{"general", false}, Occupation{"centres", true}};

/// The plan with about n sites; no centre is occupied where the group has none.
plane::OrbitPlan plan_of(const plane::PlaneGroup& group, const plane::SpecialPositions& special,
                         int n, bool centres) {
    plane::OrbitPlan plan{std::max(1, n / group.order()), std::vector<int>(special.mirrors.size()),
                          std::vector<bool>(special.centres.size())};
    for (std::size_t k = 0; centres && k < special.centres.size(); ++k) {
        plan.at_centres[k] = special.centres[k].order == special.centres.front().order;
    }
    return plan;
}

struct SymmetricRun {
    plane::SymmetricSites start;
    plane::CvtResult result;
};

SymmetricRun symmetric_run(plane::PlaneGroupName name, int n, bool centres, std::uint64_t seed) {
    const plane::PlaneGroup group(name, example_lattice(name));
    const plane::SpecialPositions special = special_positions(group);
    plane::SymmetricSites start = random_sites(group, plan_of(group, special, n, centres), seed);
    plane::CvtOptions options;
    options.run.tolerance = kSymmetryTolerance;
    plane::CvtResult result = compute_cvt(start, options);
    return {std::move(start), std::move(result)};
}

bool has_centres(plane::PlaneGroupName name) {
    return !special_positions(plane::PlaneGroup(name, example_lattice(name))).centres.empty();
}

std::vector<StudyRow> run_symmetry(int n, int /*run*/, std::uint64_t seed) {
    std::vector<StudyRow> rows;
    for (const plane::PlaneGroupRow& group : plane::kPlaneGroups) {
        for (const Occupation& occupation : kOccupations) {
            if (occupation.centres && !has_centres(group.name)) continue;
            const auto [start, result] = symmetric_run(group.name, n, occupation.centres, seed);
            rows.push_back({group.word, occupation.word, std::to_string(start.sites.n_sites()),
                            std::to_string(start.orbits.size()),
                            in_full(result.run.energy / result.energy_bound),
                            std::to_string(result.run.iterations), in_full(result.run.residual)});
        }
    }
    return rows;
}

/// The least and the mean energy over the bound; "-" for both without runs.
StudyRow energies(const StudyTable& runs, int n, const plane::PlaneGroupRow& group,
                  const Occupation& occupation) {
    double least = std::numeric_limits<double>::infinity();
    double sum = 0;
    int count = 0;
    for (const StudyRow& row : rows_of(runs, n)) {
        if (row[runs.column("group")] != group.word) continue;
        if (row[runs.column("sites_at")] != occupation.word) continue;
        const double energy = runs.number(row, "energy/bound");
        least = std::min(least, energy);
        sum += energy;
        ++count;
    }
    if (count == 0) return {"-", "-"};
    return {rounded(least, 6), rounded(sum / count, 6)};
}

/// One panel a group, with the centres occupied where there are some.
StudyPicture symmetry_picture(const Study& study) {
    const int n = *std::min_element(study.sites.begin(), study.sites.end());
    std::vector<CellPanel> panels;
    for (const plane::PlaneGroupRow& group : plane::kPlaneGroups) {
        const auto [start, result] =
            symmetric_run(group.name, n, has_centres(group.name), study.seed);
        CellPanel panel = orbit_panel(result, start.orbit);
        panel.caption = {group.word, std::to_string(start.sites.n_sites()) + " sites, " +
                                         std::to_string(start.orbits.size()) + " orbits"};
        panels.push_back(std::move(panel));
    }
    const Legend legend{"One period of each plane group; cells of one orbit have one colour", {}};
    StudyPicture picture;
    picture.svg = encode_cell_panels(legend, panels, {kPanelColumns, kPanelSize});
    return picture;
}

StudyResult conclude_symmetry(const Study& study, const StudyTable& runs) {
    StudyTable table;
    table.notes = {
        "energies over the hexagonal bound of the number of sites: the least and the mean of all "
        "runs; centres: also a site on each centre of the highest order of the group"};
    table.columns = {"group",         "n",           "general_least", "general_mean",
                     "centres_least", "centres_mean"};
    for (const int n : study.sites) {
        for (const plane::PlaneGroupRow& group : plane::kPlaneGroups) {
            StudyRow row{group.word, std::to_string(n)};
            for (const Occupation& occupation : kOccupations) {
                for (std::string& cell : energies(runs, n, group, occupation)) {
                    row.push_back(std::move(cell));
                }
            }
            table.rows.push_back(std::move(row));
        }
    }
    StudyResult result;
    result.tables.push_back(std::move(table));
    result.pictures.push_back(symmetry_picture(study));
    return result;
}

}  // namespace

StudyRecipe symmetry_recipe() {
    return {.name = "symmetry",
            .description = "tiles of the 17 plane groups, with and without sites on centres",
            .standard = Study{"symmetry", {48, 240}, 4, 0},
            .most_sites = 10'000,
            .domain = "with the symmetry of a group",
            .options = " --symmetry GROUP",
            .timed = false,
            .columns = {"group", "sites_at", "sites", "orbits", "energy/bound", "iterations",
                        "residual"},
            .notes = {"n / order orbits in general positions, at least one; sites_at centres: also "
                      "one site on each centre of the highest order",
                      "groups p3 to p6m: on period vectors of length 1 at 60 degrees"},
            .tables = {""},
            .pictures = {""},
            .printed_columns = 6,
            .run = run_symmetry,
            .conclude = conclude_symmetry};
}

}  // namespace pcvt
