#include "plugin/job/job_report.hpp"

#include <algorithm>

#include "io/run_files/report.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/version.hpp"

namespace pcvt {
namespace {

std::optional<Report::Pattern> report_pattern(const std::optional<PatternOutcome>& pattern) {
    if (!pattern) return std::nullopt;
    const auto& [lattice, stability] = *pattern;
    return Report::Pattern{.basis = lattice.basis,
                           .hermite = {lattice.form.a, lattice.form.b, lattice.form.d},
                           .energy = lattice.energy,
                           .minimum = minimum_name(stability.minimum),
                           .smallest_eigenvalue = stability.smallest};
}

/// The shortest over all tiles of the run.
std::optional<double> shortest_box_edge(const RunSummary& summary) {
    std::optional<double> shortest;
    for (const plane::TileFigures& tile : summary.tiles) {
        if (!tile.box_shortest_edge) continue;
        shortest = std::min(shortest.value_or(*tile.box_shortest_edge), *tile.box_shortest_edge);
    }
    return shortest;
}

std::optional<Report::Grains> report_grains(const RunSummary& summary) {
    for (const plane::TileFigures& tile : summary.tiles) {
        if (!tile.grains) continue;
        Report::Grains grains{tile.grains->n_triangles, tile.grains->smallest_angle, {}};
        for (const plane::SharpGrainCorner& corner : tile.grains->sharp_corners) {
            grains.sharp_corners.push_back({corner.site, corner.point, corner.angle});
        }
        return grains;
    }
    return std::nullopt;
}

std::optional<Report::Density> report_density(const Job& job, const RunSummary& summary) {
    if (!summary.density) return std::nullopt;
    const plane::DensityFigures& figures = *summary.density;
    return Report::Density{.name = job.density_name,
                           .least = figures.least,
                           .greatest = figures.greatest,
                           .evaluations_per_site = figures.evaluations_per_site,
                           .mass = figures.mass,
                           .mass_deviation = figures.mass_deviation,
                           .expected_energy = figures.expected_energy,
                           .spacing_deviation = figures.spacing_deviation,
                           .quadrature_error = figures.quadrature_error,
                           .rough_cells = figures.n_rough_cells};
}

/// The largest over all tiles of the run.
std::optional<double> largest_area_error(const RunSummary& summary) {
    std::optional<double> largest;
    for (const plane::TileFigures& tile : summary.tiles) {
        if (!tile.area_error) continue;
        largest = std::max(largest.value_or(*tile.area_error), *tile.area_error);
    }
    return largest;
}

std::optional<Report::Areas> report_areas(const Job& job, const RunSummary& summary) {
    if (!summary.areas) return std::nullopt;
    const AreaSummary& areas = *summary.areas;
    return Report::Areas{.law = job.areas->name,
                         .scale = areas.scale,
                         .std_over_mean = areas.std_over_mean,
                         .largest_relative_error = areas.newton.largest_relative_error,
                         .largest_relative_mesh_error = largest_area_error(summary),
                         .newton_steps = areas.newton.newton_steps,
                         .circularity_mean = areas.circularity_mean,
                         .circularity_std = areas.circularity_std};
}

std::optional<Report::Aspect> report_aspect(const Job& job) {
    if (!job.aspect) return std::nullopt;
    return Report::Aspect{.ratio = job.aspect->ratio, .degrees = job.aspect->degrees};
}

std::optional<Report::Symmetry> report_symmetry(const Job& job, const RunSummary& summary) {
    if (!job.symmetry) return std::nullopt;
    return Report::Symmetry{plane_group_row(*job.symmetry).word, summary.n_orbits};
}

std::optional<Report::Walls> report_walls(const Job& job, const RunSummary& summary) {
    if (job.walls == Walls::kNone) return std::nullopt;
    return Report::Walls{walls_row(job.walls).word, wall_cells_row(job.wall_cells).word,
                         summary.n_on_walls};
}

std::optional<Report::Inclusions> report_inclusions(const Job& job, const RunSummary& summary) {
    if (!summary.interfaces) return std::nullopt;
    const InterfaceFigures& figures = *summary.interfaces;
    std::vector<std::array<double, 3>> fibres;
    for (const plane::Inclusion& inclusion : figures.shapes) {
        if (!figures.are_drawn) break;
        const auto& [centre, radius] = std::get<plane::Circle>(inclusion.shape);
        fibres.push_back({centre.x(), centre.y(), radius});
    }
    return Report::Inclusions{.source = figures.source,
                              .shapes = static_cast<int>(figures.shapes.size()),
                              .fibres = std::move(fibres),
                              .chords = figures.n_chords,
                              .fixed_sites = figures.n_fixed,
                              .held_sites = figures.n_held,
                              .holes = job.holes};
}

std::vector<Report::Phase> report_phases(const RunSummary& summary) {
    std::vector<Report::Phase> phases;
    for (const PhaseFigures& phase : summary.phases) {
        phases.push_back({phase.name, phase.wanted, phase.reached, phase.n_cells});
    }
    return phases;
}

std::optional<Report::Orientations> report_orientations(const RunSummary& summary) {
    if (!summary.angles) return std::nullopt;
    const auto& [least, greatest] = *summary.angles;
    return Report::Orientations{
        {least.phi1, greatest.phi1}, {least.Phi, greatest.Phi}, {least.phi2, greatest.phi2}};
}

std::vector<Report::Material> report_materials(const RunSummary& summary) {
    std::vector<Report::Material> materials;
    for (const auto& [name, constants] : summary.constants) {
        Report::Material& material = materials.emplace_back();
        material.name = name;
        for (std::size_t k = 0; k < constants.numbers.size(); ++k) {
            material.constants.emplace_back(names_of(constants)[k], constants.numbers[k]);
        }
    }
    return materials;
}

}  // namespace

std::string encode_job_report(const Job& job, const RunSummary& summary) {
    const JobSeconds& seconds = summary.seconds;
    return encode_report({
        .version = version(),
        .sites = summary.n_sites,
        .lattice = job.lattice,
        .seed = summary.seed,
        .solver = solver_row(job.run.solver).word,
        .start = start_name(job),
        .stop = stop_name(summary.run.stop),
        .iterations = summary.run.iterations,
        .evaluations = summary.run.evaluations,
        .hessians = summary.run.hessians,
        .cg_products = summary.run.cg_products,
        .energy = summary.run.energy,
        .energy_bound = summary.energy_bound,
        .residual = summary.run.residual,
        .minimum = summary.minimum ? std::optional<std::string>(minimum_name(*summary.minimum))
                                   : std::nullopt,
        .hexagons = summary.n_hexagons,
        .valences = summary.valences,
        .mirrors = summary.n_mirrors,
        .threads = job.run.n_threads,
        .seconds = {seconds.build, seconds.optimize, seconds.write, seconds.total},
        .files = summary.files,
        .found = summary.start.found,
        .pattern = report_pattern(summary.start.pattern),
        .box_shortest_edge = shortest_box_edge(summary),
        .grains = report_grains(summary),
        .density = report_density(job, summary),
        .areas = report_areas(job, summary),
        .aspect = report_aspect(job),
        .symmetry = report_symmetry(job, summary),
        .walls = report_walls(job, summary),
        .inclusions = report_inclusions(job, summary),
        .phases = report_phases(summary),
        .duplicates =
            job.duplicates == Duplicates::kDrop ? std::optional(job.dropped) : std::nullopt,
        .orientations = report_orientations(summary),
        .materials = report_materials(summary),
    });
}

}  // namespace pcvt
