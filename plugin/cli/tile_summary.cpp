#include "plugin/cli/tile_summary.hpp"

#include "io/forms/file_options.hpp"
#include "plugin/cli/summary.hpp"
#include "plugin/cli/terminal/console.hpp"

namespace pcvt::cli {
namespace {

std::string grain_text(const plane::GrainFigures& grains) {
    const std::size_t n_sharp = grains.sharp_corners.size();
    return std::to_string(grains.n_triangles) + " triangles, angles from " +
           figure(grains.smallest_angle) + " degrees on" +
           (n_sharp == 0 ? "" : " but in " + std::to_string(n_sharp) + " sharp corners of pieces");
}

/// The line of the wedges of .inp files, whose height is a default or a choice.
std::string wedge_line(const Job& job) {
    if (!are_wedges(job.file_options.element)) return "";
    const double height = job.file_options.thickness;
    return summary_line(
        "wedges",
        std::string(plane_element_row(job.file_options.element).word) + ", one layer along z, " +
            (height > 0 ? figure(height) : std::string("sqrt(area / triangles)")) + " high");
}

}  // namespace

std::string tile_lines(const Job& job, const RunSummary& summary) {
    std::string text;
    if (!summary.tiles.empty()) {
        const plane::TileFigures& first = summary.tiles.front();
        text += summary_line("domain", vector_text(first.domain_corner) + " to " +
                                           vector_text(first.opposite_corner));
    }
    for (const plane::TileFigures& tile : summary.tiles) {
        text +=
            summary_line("seam", std::string(mesh_kind_row(tile.kind).word) + ", " +
                                     std::to_string(tile.n_boundary_edges) + " boundary edges in " +
                                     std::to_string(tile.n_edge_pairs) + " pairs" +
                                     (tile.n_wall_edges > 0
                                          ? ", " + std::to_string(tile.n_wall_edges) + " on walls"
                                          : ""));
        if (tile.box_shortest_edge) {
            text += summary_line(
                "box", "shortest edge of the cut " + figure(*tile.box_shortest_edge) + " h");
        }
        if (tile.grains) text += summary_line("grains", grain_text(*tile.grains));
        // Without joined corners, each cell has the area that the line "areas" states.
        if (tile.area_error && *tile.area_error > 0) {
            text +=
                summary_line("meshed", std::string(mesh_kind_row(tile.kind).word) +
                                           ", areas off by at most " + figure(*tile.area_error));
        }
    }
    return text + wedge_line(job);
}

}  // namespace pcvt::cli
