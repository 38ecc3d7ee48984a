#include "plugin/job/job_report.hpp"

#include <algorithm>

#include "io/bytes/json_writer.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/job_tessellation.hpp"
#include "plugin/job/version.hpp"

namespace pcvt {
namespace {

/// The best value of a figure over the tiles of the run that have it; no value if none has.
template <class Better>
std::optional<double> best_of_tiles(const RunSummary& summary,
                                    std::optional<double> plane::TileFigures::*figure,
                                    const Better& better) {
    std::optional<double> best;
    for (const plane::TileFigures& tile : summary.tiles) {
        if (tile.*figure) best = better(best.value_or(*(tile.*figure)), *(tile.*figure));
    }
    return best;
}

/// The numbers of cells by their number of sides or faces.
void append_counts(JsonWriter& json, const char* key, const std::map<int, int>& counts) {
    json.object(key, [&] {
        for (const auto& [sides, n_cells] : counts) json.member(std::to_string(sides), n_cells);
    });
}

void append_pattern(JsonWriter& json, const RunSummary& summary) {
    if (!summary.start.pattern) return;
    const PatternFigures& pattern = *summary.start.pattern;
    json.object("pattern", [&] {
        json.key("basis");
        json.begin_list();
        for (const auto& vector : pattern.basis.colwise()) json.value(vector);
        json.end();
        json.member("hermite", pattern.hermite);
        json.member("energy", pattern.energy);
        json.member("minimum", minimum_name(pattern.stability.minimum));
        // Null for one site.
        json.member("smallest_eigenvalue", pattern.stability.smallest);
    });
}

/// The keys of the cells: in the plane by their sides, in space by their faces.
void append_cells(JsonWriter& json, const RunSummary& summary) {
    if (!summary.polyhedra) json.member("hexagons", summary.n_with_sides(6));
    append_counts(json, "valences", summary.valences);
    if (!summary.polyhedra) return;
    const auto& [n_removed_edges, proof, box_origin] = *summary.polyhedra;
    append_counts(json, "faces", summary.valences);
    json.member("removed_edges", n_removed_edges);
    json.member("volume", proof.volume);
    json.member("boundary_pairs", proof.n_boundary_pairs);
    json.member("translations", proof.n_translations);
    json.member("boundary_is_manifold", proof.boundary_is_manifold);
    if (!box_origin) return;
    json.object("box", [&, &proof = proof, &box_origin = box_origin] {
        json.member("origin", std::vector<double>(box_origin->begin(), box_origin->end()));
        json.member("pieces", proof.n_cells);
    });
}

/// The key `duplicates` of runs that leave out sites which coincide with earlier ones.
void append_duplicates(JsonWriter& json, const Job& job) {
    if (job.duplicates != Duplicates::kDrop) return;
    const auto append_pairs = [&](const char* key, const std::vector<CoincidentSite>& pairs) {
        json.list(key, pairs, [&](const CoincidentSite& pair) {
            json.value(std::array{pair.site, pair.earlier});
        });
    };
    json.object("duplicates", [&] {
        json.member("dropped", job.dropped.sites.size());
        append_pairs("sites", job.dropped.sites);
        if (!job.dropped.lines.empty()) append_pairs("lines", job.dropped.lines);
    });
}

void append_space_grains(JsonWriter& json, const RunSummary& summary) {
    if (!summary.space_grains) return;
    const SpaceGrainFigures& grains = *summary.space_grains;
    json.object("grains", [&] {
        json.member("tetrahedra", grains.n_tetrahedra);
        json.member("points", grains.n_points);
        json.member("smallest_angle", grains.smallest_angle);
        json.member("largest_angle", grains.largest_angle);
        json.member("sharp_features", grains.n_sharp);
        json.member("smallest_angle_at_them", grains.smallest_sharp_angle);
    });
}

void append_grains(JsonWriter& json, const RunSummary& summary) {
    const auto tile = std::find_if(summary.tiles.begin(), summary.tiles.end(),
                                   [](const auto& t) { return t.grains.has_value(); });
    if (tile == summary.tiles.end()) return;
    json.object("grains", [&] {
        json.member("triangles", tile->grains->n_triangles);
        json.member("smallest_angle", tile->grains->smallest_angle);
        json.list("sharp_corners", tile->grains->sharp_corners,
                  [&](const plane::SharpGrainCorner& corner) {
                      json.begin_list();
                      json.value(corner.site);
                      for (const double x : corner.point) json.value(x);
                      json.value(corner.angle);
                      json.end();
                  });
    });
}

void append_density(JsonWriter& json, const Job& job, const RunSummary& summary) {
    if (!summary.density) return;
    const plane::DensityFigures& figures = *summary.density;
    json.member("density", job.density_name);
    json.member("density_least", figures.least);
    json.member("density_greatest", figures.greatest);
    json.member("density_evaluations", figures.evaluations_per_site);
    json.member("mass", figures.mass);
    json.member("mass_deviation", figures.mass_deviation);
    json.member("expected_energy", figures.expected_energy);
    json.member("spacing_deviation", figures.spacing_deviation);
    json.member("quadrature_error", figures.quadrature_error);
    json.member("rough_cells", figures.n_rough_cells);
}

void append_weights(JsonWriter& json, const Job& job) {
    if (!job.weights) return;
    const Eigen::VectorXd& weights = job.weights->values;
    json.object("weights", [&] {
        json.member("source", job.weights->name);
        json.member("least", weights.minCoeff());
        json.member("greatest", weights.maxCoeff());
    });
}

void append_sizes(JsonWriter& json, const Job& job, const RunSummary& summary) {
    if (!summary.sizes) return;
    const SizeSummary& sizes = *summary.sizes;
    const bool in_space = job.is_in_space();
    const auto largest = [](double a, double b) { return std::max(a, b); };
    json.object(in_space ? "volumes" : "areas", [&] {
        json.member("law", job.sizes->name);
        if (sizes.scale) json.member("scale", *sizes.scale);
        json.member("std_over_mean", sizes.std_over_mean);
        json.member("largest_relative_error", sizes.newton.largest_relative_error);
        if (!in_space) {
            json.member("largest_relative_mesh_error",
                        best_of_tiles(summary, &plane::TileFigures::area_error, largest));
        }
        json.member("newton_steps", sizes.newton.newton_steps);
        json.member(in_space ? "sphericity_mean" : "circularity_mean", sizes.roundness_mean);
        json.member(in_space ? "sphericity_std" : "circularity_std", sizes.roundness_std);
    });
}

void append_inclusions(JsonWriter& json, const Job& job, const RunSummary& summary) {
    if (!summary.interfaces) return;
    const plane::InterfaceFigures& figures = *summary.interfaces;
    json.object("inclusions", [&] {
        json.member("source", inclusion_source(job));
        json.member("shapes", figures.shapes.size());
        if (figures.n_images > 0) json.member("images_left_out", figures.n_images);
        if (figures.n_nested > 0) json.member("nested", figures.n_nested);
        if (job.fibres && !figures.shapes.empty()) {
            json.list("fibres", figures.shapes, [&](const plane::Inclusion& inclusion) {
                const auto& [centre, radius] = std::get<plane::Circle>(inclusion.shape);
                json.value(std::array{centre.x(), centre.y(), radius});
            });
        }
        json.member("chords", figures.n_chords);
        json.member("fixed_sites", figures.n_fixed);
        json.member("held_sites", figures.n_held);
        if (!job.holes.empty()) json.member("holes", job.holes);
    });
}

void append_phases(JsonWriter& json, const RunSummary& summary) {
    if (summary.phases.empty()) return;
    json.list("phases", summary.phases, [&](const PhaseFigures& phase) {
        json.begin_object();
        json.member("name", phase.name);
        json.member("wanted", phase.wanted);
        json.member("reached", phase.reached);
        json.member("cells", phase.n_cells);
        json.end();
    });
}

void append_orientations(JsonWriter& json, const Job& job, const RunSummary& summary) {
    if (!summary.angles) return;
    const BungeAngles& least = summary.angles->least;
    const BungeAngles& greatest = summary.angles->greatest;
    json.object("orientations", [&] {
        json.member("phi1", std::array{least.phi1, greatest.phi1});
        json.member("Phi", std::array{least.Phi, greatest.Phi});
        json.member("phi2", std::array{least.phi2, greatest.phi2});
        if (job.materials.draws_from_list(summary.n_sites)) {
            json.member("drawn_from", job.materials.orientation_source);
            json.member("listed", job.materials.orientations.size());
        }
    });
}

void append_misorientations(JsonWriter& json, const RunSummary& summary) {
    if (!summary.misorientations) return;
    const Misorientations& found = *summary.misorientations;
    json.object("misorientations", [&] {
        json.member("symmetry", "cubic");
        json.member("mean", found.mean);
        json.member("largest", found.largest);
        json.member("boundaries", found.n_boundaries);
        json.member("class", Misorientations::kClass);
        json.member("counts", found.counts);
    });
}

void append_materials(JsonWriter& json, const RunSummary& summary) {
    if (summary.constants.empty()) return;
    json.list("materials", summary.constants, [&](const NamedConstants& material) {
        json.begin_object();
        json.member("name", material.name);
        for (std::size_t k = 0; k < material.constants.numbers.size(); ++k) {
            json.member(names_of(material.constants)[k], material.constants.numbers[k]);
        }
        if (!material.source.empty()) json.member("source", material.source);
        json.end();
    });
}

/// Appends the keys of every run.
void append_run(JsonWriter& json, const Job& job, const RunSummary& summary) {
    json.member("version", version());
    json.member("dimension", job.is_in_space() ? 3 : 2);
    json.member("sites", summary.n_sites);
    std::visit([&](const auto& domain) { json.member("lattice", domain.lattice.periods()); },
               job.domain);
    json.member("seed", job.seed);
    json.member("solver", solver_row(job.run.solver).word);
    json.member("start", job.n_given() > 0 ? "file" : start_row(summary.start.chosen).word);
    json.member("stop", stop_name(summary.run.stop));
    json.member("iterations", summary.run.iterations);
    json.member("evaluations", summary.run.evaluations);
    json.member("hessians", summary.run.hessians);
    json.member("cg_products", summary.run.cg_products);
    json.member("energy", summary.run.energy);
    json.member("energy_bound", summary.energy_bound);
    json.member("residual", summary.run.residual);
    json.member("rms_residual", summary.run.rms_residual);
    // Yes, no or unknown; null if the run did not determine it.
    json.member("minimum",
                summary.minimum ? std::optional(minimum_name(*summary.minimum)) : std::nullopt);
    append_cells(json, summary);
    json.member("mirrors", summary.n_mirrors);
    json.member("threads", job.run.n_threads);
    json.object("seconds", [&] {
        json.member("build", summary.seconds.build);
        json.member("optimize", summary.seconds.optimize);
        json.member("write", summary.seconds.write);
        json.member("total", summary.seconds.total);
    });
    json.member("files", summary.files);
}

/// Appends the keys of some runs.
void append_choices(JsonWriter& json, const Job& job, const RunSummary& summary) {
    const auto shortest = [](double a, double b) { return std::min(a, b); };
    if (!summary.start.found.empty()) json.member("found", summary.start.found);
    append_pattern(json, summary);
    if (const std::optional<double> edge =
            best_of_tiles(summary, &plane::TileFigures::box_shortest_edge, shortest)) {
        json.member("box_shortest_edge", *edge);
    }
    append_space_grains(json, summary);
    append_grains(json, summary);
    append_density(json, job, summary);
    append_sizes(json, job, summary);
    append_weights(json, job);
    if (summary.centroids) {
        json.object("centroids", [&] {
            json.member("source", *job.centroids);
            json.member("mean_misfit", summary.centroids->mean);
            json.member("largest_misfit", summary.centroids->largest);
        });
    }
    if (job.aspect) {
        json.object("aspect", [&] {
            json.member("ratio", job.aspect->ratio);
            if (job.is_in_space()) {
                json.member("axis",
                            std::vector<double>(job.aspect->axis.begin(), job.aspect->axis.end()));
            } else {
                json.member("degrees", job.aspect->degrees);
            }
        });
    }
    if (job.symmetry) {
        json.object("symmetry", [&] {
            json.member("group", plane_group_row(*job.symmetry).word);
            json.member("orbits", summary.n_orbits);
        });
    }
    append_inclusions(json, job, summary);
    if (job.walls != Walls::kNone) {
        json.object("walls", [&] {
            json.member("sides", walls_row(job.walls).word);
            json.member("cells", wall_cells_row(job.wall_cells).word);
            json.member("sites", summary.n_on_walls);
        });
    }
    append_phases(json, summary);
    append_duplicates(json, job);
    append_orientations(json, job, summary);
    append_misorientations(json, summary);
    append_materials(json, summary);
}

}  // namespace

std::string encode_job_report(const Job& job, const RunSummary& summary) {
    std::string text;
    JsonWriter json(text);
    json.begin_object(kJsonLines);
    append_run(json, job, summary);
    append_choices(json, job, summary);
    json.end();
    return text + '\n';
}

}  // namespace pcvt
