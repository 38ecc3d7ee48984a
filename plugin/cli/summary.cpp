#include "plugin/cli/summary.hpp"

#include <cstdio>

#include "plugin/cli/console.hpp"

namespace pcvt::cli {
namespace {

std::string vector_text(const Vec2& v) {
    // Adding 0 turns -0 into 0.
    return "(" + figure(v.x() + 0.0) + ", " + figure(v.y() + 0.0) + ")";
}

std::string line(const char* label, const std::string& text) {
    char head[16];
    std::snprintf(head, sizeof head, "%-10s ", label);
    return head + text + "\n";
}

std::string valence_text(const JobOutcome& outcome) {
    std::string text = std::to_string(outcome.n_hexagons) + " of " +
                       std::to_string(outcome.n_sites) + " cells; sides";
    for (const auto& [sides, count] : outcome.valences) {
        text += " " + std::to_string(sides) + ":" + std::to_string(count);
    }
    return text;
}

std::string seam_lines(const JobOutcome& outcome) {
    std::string text;
    for (const SeamSize& seam : outcome.seams) {
        text +=
            line("seam", std::string(seam.kind == TileKind::kCells ? "voronoi" : "delaunay") +
                             ", " + std::to_string(seam.n_boundary_edges) + " boundary edges in " +
                             std::to_string(seam.n_edge_pairs) + " pairs");
    }
    return text;
}

std::string energy_text(const JobOutcome& outcome) {
    std::string text = figure(outcome.energy);
    if (outcome.energy_bound) {
        text += ", " + figure(outcome.energy / *outcome.energy_bound) + " of the hexagonal bound";
    }
    if (outcome.density) {
        text += ", " + figure(outcome.energy / outcome.density->expected_energy) +
                " of what many cells of this density tend to";
    }
    return text;
}

std::string density_lines(const DensityFigures& density) {
    std::string text =
        line("density", "from " + figure(density.least) + " to " + figure(density.greatest) + ", " +
                            figure(density.evaluations_per_site) + " evaluations a site");
    text += line("mass", figure(density.mass) + ", off the integral of the density by " +
                             figure(density.mass_deviation));
    text += line("spacing", "off the law density^(-1/4) by " +
                                figure(100 * density.spacing_deviation) + " % (median)");
    if (density.n_rough_cells == 0) return text;
    return text + line("rough", std::to_string(density.n_rough_cells) +
                                    " cells where the density is not smooth: their centroids are "
                                    "known to " +
                                    figure(density.quadrature_error) + " of their spacing");
}

}  // namespace

std::string summary(const Job& job, const JobOutcome& outcome) {
    std::string text;
    text += line("sites", std::to_string(outcome.n_sites));
    text += line("lattice", vector_text(job.lattice.a()) + " " + vector_text(job.lattice.b()));
    text += line("stop", std::string(stop_name(outcome.stop)) + " after " +
                             std::to_string(outcome.iterations) + " iterations, " +
                             std::to_string(outcome.evaluations) + " evaluations");
    text += line("energy", energy_text(outcome));
    text += line("residual", figure(outcome.residual));
    text += line("hexagons", valence_text(outcome));
    if (outcome.density) text += density_lines(*outcome.density);
    text += seam_lines(outcome);
    for (const std::string& file : outcome.files) text += line("file", file);
    if (!job.report.empty()) text += line("report", job.report);
    text += line("seconds", figure(outcome.seconds.total));
    return text;
}

}  // namespace pcvt::cli
