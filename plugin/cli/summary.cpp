#include "plugin/cli/summary.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "io/bytes/text.hpp"
#include "io/formats/output_files.hpp"
#include "plugin/cli/site_summary.hpp"
#include "plugin/cli/terminal/console.hpp"
#include "plugin/cli/tile_summary.hpp"
#include "plugin/job/run_job.hpp"

namespace pcvt::cli {
namespace {

std::string valence_text(const RunSummary& summary) {
    std::string text = std::to_string(summary.n_with_sides(6)) + " of " +
                       std::to_string(summary.n_sites) + " cells; sides";
    for (const auto& [sides, count] : summary.valences) {
        text += " " + std::to_string(sides) + ":" + std::to_string(count);
    }
    return text;
}

/// The line that says whether the result is a minimum.
std::string minimum_line(const std::optional<Minimum>& minimum) {
    return summary_line("minimum", minimum ? minimum_name(*minimum) : "not known: not converged");
}

/// The line of a lattice that says whether it is a minimum.
std::string stability_line(const LatticeStability& stability) {
    const std::string verdict = stability.minimum == Minimum::kYes  ? "the pattern is a minimum"
                                : stability.minimum == Minimum::kNo ? "the pattern is a saddle"
                                                                    : "too near to call";
    const std::string reason =
        stability.smallest
            ? "smallest eigenvalue " + figure(*stability.smallest) + " of the largest"
            : "one site has only the translations";
    return summary_line("stability", verdict + "; " + reason);
}

/// An energy, and its ratio to that of as many of the best known cells.
std::string energy_over_bound(const Job& job, double energy, double bound) {
    return figure(energy) + ", " + figure(energy / bound) +
           (job.is_in_space() ? " of truncated octahedra" : " of the hexagonal bound");
}

/// The best exact lattice, its energy and its stability.
std::string pattern_lines(const Job& job, const PatternFigures& pattern) {
    return summary_line("pattern", vectors_text(pattern.basis.colwise()) + ", energy " +
                                       energy_over_bound(job, pattern.energy, energy_bound(job))) +
           stability_line(pattern.stability);
}

std::string energy_text(const Job& job, const RunSummary& summary) {
    const double energy = summary.run.energy;
    std::string text = summary.energy_bound ? energy_over_bound(job, energy, *summary.energy_bound)
                                            : figure(energy);
    if (summary.density) {
        text += ", " + figure(energy / summary.density->expected_energy) +
                " of the limit for many cells of this density";
    }
    return text;
}

/// The line of tetrahedra inside of cells.
std::string space_grain_line(const SpaceGrainFigures& grains) {
    std::string text = std::to_string(grains.n_tetrahedra) + " tetrahedra on " +
                       std::to_string(grains.n_points) + " points, ";
    text += grains.smallest_angle ? "dihedral angles from " + figure(*grains.smallest_angle) +
                                        " to " + figure(*grains.largest_angle) + " degrees"
                                  : "each beside a sharp place; dihedral angles";
    if (grains.n_sharp > 0) {
        text += (grains.smallest_angle ? "; from " : " from ") +
                figure(grains.smallest_sharp_angle) + " at " +
                counted(grains.n_sharp, "sharp place") +
                " of the cells (corners, edges, narrow faces, flat cells), the sharpest of " +
                figure(grains.sharpest) + " degrees";
    }
    return summary_line("grains", text);
}

/// X,Y,Z with all digits.
std::string as_option(const space::Vec3& p) {
    std::string text;
    for (const double x : p) append_number(text += text.empty() ? "" : ",", x);
    return text;
}

/// The lines of the cells of a tile in space.
std::string polyhedra_lines(const Job& job, const RunSummary& summary) {
    const auto& [n_removed_edges, proof, box_origin] = *summary.polyhedra;
    double sum = 0;
    std::string counts;
    for (const auto& [faces, count] : summary.valences) {
        sum += double(faces) * count;
        counts += " " + std::to_string(faces) + ":" + std::to_string(count);
    }
    std::string text =
        summary_line("faces", figure(sum / summary.n_sites) + " a cell; cells with" + counts);
    if (job.tile.short_edges > 0) {
        text += summary_line("edges", std::to_string(n_removed_edges) + " under " +
                                          figure(job.tile.short_edges) + " h removed");
    }
    if (summary.space_grains) text += space_grain_line(*summary.space_grains);
    if (box_origin) {
        text += summary_line("box", counted(proof.n_cells, "piece") + " of cells, " +
                                        (job.tile.finds_origin ? "chosen " : "") + "--origin " +
                                        as_option(*box_origin));
    }
    return text +
           summary_line("seam",
                        std::to_string(2 * proof.n_boundary_pairs) + " boundary faces in " +
                            std::to_string(proof.n_boundary_pairs) + " pairs by " +
                            counted(proof.n_translations, "translation") +
                            (proof.boundary_is_manifold ? "" : "; the boundary touches itself"));
}

std::string density_lines(const plane::DensityFigures& density) {
    std::string text = summary_line(
        "density", "from " + figure(density.least) + " to " + figure(density.greatest) + ", " +
                       figure(density.evaluations_per_site) + " evaluations a site");
    text += summary_line("mass", figure(density.mass) + ", off the integral of the density by " +
                                     figure(density.mass_deviation));
    text += summary_line("spacing", "off the law density^(-1/4) by " +
                                        figure(100 * density.spacing_deviation) + " % (median)");
    if (density.n_rough_cells == 0) return text;
    return text +
           summary_line("rough", std::to_string(density.n_rough_cells) +
                                     " cells where the density is not smooth: their centroids are "
                                     "known to " +
                                     figure(density.quadrature_error) + " of their spacing");
}

std::string size_lines(const Job& job, const SizeSummary& sizes) {
    const bool in_space = job.is_in_space();
    const std::string scale = sizes.scale
                                  ? std::string(" (each ") + (in_space ? "volume" : "area") +
                                        " times " + figure(*sizes.scale) + ")"
                                  : "";
    return summary_line(in_space ? "volumes" : "areas",
                        job.sizes->name + scale + ", diameters with std / mean " +
                            figure(sizes.std_over_mean) +
                            (sizes.newton.converged ? ", converged: off by at most "
                                                    : ", not converged: off by up to ") +
                            figure(sizes.newton.largest_relative_error) + " after " +
                            counted(sizes.newton.newton_steps, "Newton step")) +
           summary_line("shapes", (in_space ? "sphericity " : "circularity ") +
                                      figure(sizes.roundness_mean) + " +- " +
                                      figure(sizes.roundness_std) +
                                      (in_space ? ", of a truncated octahedron 0.910"
                                                : ", of a regular hexagon 0.952"));
}

std::string inclusion_text(const plane::InterfaceFigures& figures) {
    std::string text = counted(static_cast<int>(figures.shapes.size()), "shape");
    if (figures.n_nested > 0) text += ", " + std::to_string(figures.n_nested) + " inside of others";
    if (figures.n_images > 0) {
        text += " (" + counted(figures.n_images, "listed image") + " left out)";
    }
    text += ", " + counted(figures.n_chords, "chord") + ", " + counted(figures.n_fixed, "site") +
            " in pairs beside them";
    if (figures.n_held > 0) text += ", " + counted(figures.n_held, "site") + " stopped at them";
    return text;
}

/// The holes, and the sites that files and tiles have.
std::string hole_text(const Job& job, const RunSummary& summary) {
    std::string names;
    for (const std::string& hole : job.holes) names += (names.empty() ? "" : ", ") + hole;
    int n_outside = 0;
    for (const PhaseFigures& phase : summary.phases) {
        const bool is_hole =
            std::find(job.holes.begin(), job.holes.end(), phase.name) != job.holes.end();
        if (!is_hole) n_outside += phase.n_cells;
    }
    return names + "; the " + counted(n_outside, "site") + " outside are numbered from 0";
}

std::string phase_lines(const Job& job, const RunSummary& summary) {
    const bool are_given = !job.materials.site_phases.empty();
    const char* const measure = job.is_in_space() ? "volume" : "area";
    std::string text;
    for (const PhaseFigures& phase : summary.phases) {
        text +=
            summary_line("phase", phase.name + " " + figure(phase.reached) + " of the " + measure +
                                      " in " + std::to_string(phase.n_cells) + " cells" +
                                      (are_given ? "" : "; wanted " + figure(phase.wanted)));
    }
    return text;
}

std::string angle_text(const AngleRange& angles) {
    const auto range = [&](double BungeAngles::*angle) {
        return figure(angles.least.*angle) + " to " + figure(angles.greatest.*angle);
    };
    return "phi1 " + range(&BungeAngles::phi1) + ", Phi " + range(&BungeAngles::Phi) + ", phi2 " +
           range(&BungeAngles::phi2) + " degrees";
}

/// The lines of the orientations of the cells.
std::string orientation_lines(const Job& job, const RunSummary& summary) {
    if (!summary.angles) return "";
    const MaterialChoices& choices = job.materials;
    std::string text;
    if (choices.draws_from_list(summary.n_sites)) {
        text = summary_line(
            "texture", "drawn from the " +
                           counted(static_cast<int>(choices.orientations.size()), "orientation") +
                           " of " + choices.orientation_source);
    }
    text += summary_line("angles", angle_text(*summary.angles));
    if (!summary.misorientations) return text;
    const Misorientations& found = *summary.misorientations;
    return text +
           summary_line("neighbours", "as cubic crystals misoriented by " + figure(found.mean) +
                                          " degrees on average, at most " + figure(found.largest) +
                                          "; without a texture 40.7 and 62.8");
}

/// Phases whose stiffnesses differ by more than this may be given in different units.
constexpr double kOneUnit = 1e3;

/// The line on constants that differ so much that their units may differ; empty for others.
std::string contrast_line(const RunSummary& summary) {
    double least = std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const NamedConstants& material : summary.constants) {
        const double c44 = stiffness_of(material.constants).c44;
        least = std::min(least, c44);
        largest = std::max(largest, c44);
    }
    if (!(largest > kOneUnit * least)) return "";
    return summary_line("contrast", "the materials differ by a factor of " +
                                        figure(largest / least) +
                                        " in C44; give all constants in one unit");
}

std::string material_lines(const Job& job, const RunSummary& summary) {
    const bool are_given = job.file_options.elastic.are_given();
    std::string text;
    for (const auto& [name, constants, source] : summary.constants) {
        const std::string of_file = source.empty() ? "" : " (" + source + "; DAMASK takes Pa)";
        text += summary_line("material", name + ": " + constants_text(constants) +
                                             (are_given                  ? of_file
                                              : constants.is_isotropic() ? " (steel in MPa)"
                                                                         : " (iron in MPa)"));
    }
    return text + contrast_line(summary);
}

std::string seed_text(const Job& job, const RunSummary& summary) {
    const std::uint64_t used = job.seed + static_cast<std::uint64_t>(summary.retries);
    return std::to_string(used) + ", because an output refused the cells of seed " +
           std::to_string(job.seed) +
           (summary.retries > 1 ? " to " + std::to_string(used - 1) : "");
}

/// The lines of what constrains the cells: their aspect, symmetry, walls and inclusions.
std::string constraint_lines(const Job& job, const RunSummary& summary) {
    std::string text;
    if (job.aspect) {
        const space::Vec3& axis = job.aspect->axis;
        text += summary_line(
            "aspect", figure(job.aspect->ratio) + " along " +
                          (job.is_in_space()
                               ? figure(axis.x()) + "," + figure(axis.y()) + "," + figure(axis.z())
                               : figure(job.aspect->degrees) + " degrees"));
    }
    if (job.symmetry) {
        text += summary_line("symmetry", std::string(plane_group_row(*job.symmetry).word) + ", " +
                                             std::to_string(summary.n_orbits) + " orbits");
    }
    if (job.walls != Walls::kNone) {
        const std::string on_walls = std::to_string(summary.n_on_walls) + " sites on walls";
        text += summary_line("walls", std::string(walls_row(job.walls).word) + ", " +
                                          wall_cells_row(job.wall_cells).word + " cells" +
                                          (summary.n_on_walls > 0 ? ", " + on_walls : ""));
    }
    if (summary.interfaces) text += summary_line("inclusions", inclusion_text(*summary.interfaces));
    if (!job.holes.empty()) text += summary_line("holes", hole_text(job, summary));
    return text;
}

}  // namespace

std::string summary_line(const char* label, const std::string& text) {
    char head[16];
    std::snprintf(head, sizeof head, "%-10s ", label);
    return head + text + "\n";
}

std::string summary_text(const Job& job, const RunSummary& summary) {
    std::string text = site_lines(job, summary.n_sites);
    if (summary.retries > 0) text += summary_line("seed", seed_text(job, summary));
    text += summary_line("stop", std::string(stop_name(summary.run.stop)) + " after " +
                                     counted(summary.run.iterations, "iteration") + ", " +
                                     counted(summary.run.evaluations, "evaluation"));
    if (summary.run.hessians > 0) {
        text += summary_line("newton", counted(summary.run.hessians, "Hessian") + ", " +
                                           counted(summary.run.cg_products, "product") +
                                           " with vectors");
    }
    text += summary_line("energy", energy_text(job, summary));
    text += summary_line("residual", figure(summary.run.residual));
    if (job.stability) text += minimum_line(summary.minimum);
    text += summary.polyhedra ? polyhedra_lines(job, summary)
                              : summary_line("hexagons", valence_text(summary));
    if (!summary.start.found.empty()) text += summary_line("found", summary.start.found);
    if (summary.start.pattern) text += pattern_lines(job, *summary.start.pattern);
    if (summary.density) text += density_lines(*summary.density);
    if (summary.sizes) text += size_lines(job, *summary.sizes);
    if (summary.centroids) {
        text += summary_line("centroids", "off those of " + *job.centroids + " by " +
                                              figure(summary.centroids->mean) +
                                              " h on average, by at most " +
                                              figure(summary.centroids->largest) + " h");
    }
    if (job.weights) text += summary_line("weights", job.weights->name);
    text += constraint_lines(job, summary);
    text += phase_lines(job, summary);
    text += orientation_lines(job, summary);
    text += material_lines(job, summary);
    text += tile_lines(job, summary);
    for (const std::string& words : summary.recovered) text += summary_line("recovered", words);
    for (const std::string& file : summary.files) {
        text += summary_line("file", file);
        if (const auto note = format_note(file); !note.empty()) text += summary_line("", note);
    }
    if (!job.report.empty()) text += summary_line("report", job.report);
    text += summary_line("seconds", figure(summary.seconds.total));
    return text;
}

}  // namespace pcvt::cli
