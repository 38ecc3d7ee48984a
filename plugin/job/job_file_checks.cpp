#include "plugin/job/job_file_checks.hpp"

#include <algorithm>

#include "plugin/job/job_checks.hpp"

namespace pcvt {
namespace {

/// The widths of a tile for cutters, in millimetres.
constexpr double kLeastCutWidth = 1e-3;
constexpr double kLargestCutWidth = 1e6;

/// A choice that files hold, as messages name it, and the formats that take it.
struct FileChoice {
    const char* name;
    bool TileFormat::*taken;
    bool (*is_made)(const Job& job);
};
constexpr FileChoice kFileChoices[] = {
    {"glTF nodes", &TileFormat::takes_gltf_nodes,
     [](const Job& job) { return job.file_options.gltf_nodes != GltfNodes::kBySize; }},
    {"32-bit coordinates", &TileFormat::takes_single_precision,
     [](const Job& job) { return job.file_options.single_precision; }},
    {"a number of pixels", &TileFormat::takes_pixels,
     [](const Job& job) { return job.file_options.pixels != 0; }},
    {"a number of voxels", &TileFormat::takes_voxels,
     [](const Job& job) { return job.file_options.voxels != VoxelCounts{}; }},
    {"a width to cut", &TileFormat::takes_cut_width,
     [](const Job& job) { return job.file_options.cut_width != 0; }},
    {"a type of elements", &TileFormat::takes_element,
     [](const Job& job) { return job.file_options.element != PlaneElement::kStrain; }},
    {"a job of a solver", &TileFormat::takes_job,
     [](const Job& job) { return job.file_options.job != SolverJob::kNone; }},
    {"a thickness", &TileFormat::takes_thickness,
     [](const Job& job) { return job.file_options.thickness != 0; }},
    {"a colouring", &TileFormat::takes_colouring,
     [](const Job& job) { return job.file_options.colouring.has_value(); }},
    {"a background", &TileFormat::takes_background,
     [](const Job& job) { return job.file_options.background.has_value(); }},
    {"phases", &TileFormat::takes_phases,
     [](const Job& job) { return !job.materials.phases.empty(); }},
    {"orientations", &TileFormat::takes_orientations,
     [](const Job& job) { return job.materials.has_orientations(); }},
};

std::string extensions_that_take(const FileChoice& choice) {
    std::string text;
    for (const TileFormat& format : tile_formats()) {
        if (!(format.*choice.taken)) continue;
        text += (text.empty() ? "" : " or ") + std::string(format.extension);
    }
    return text;
}

/// @throws InvalidInput if the run has nothing that the colours could show.
void check_colouring(const Job& job, Colouring colouring) {
    switch (colouring_row(colouring).needs) {
        case ColouringNeed::kNothing:
            return;
        case ColouringNeed::kDensity:
            if (job.density) return;
            throw InvalidInput(
                "there is no density to show in colours; give one, or colour by size");
        case ColouringNeed::kPhases:
            if (!job.materials.phases.empty() || job.has_inclusions()) return;
            throw InvalidInput(
                "there are no phases to show in colours; give some, or colour by size");
        case ColouringNeed::kOrbits:
            if (job.symmetry) return;
            throw InvalidInput(
                "there is no symmetry whose orbits colours could show; give one, or colour by "
                "cells");
        case ColouringNeed::kTags:
            if (job.has_inclusions()) return;
            throw InvalidInput(
                "there are no inclusions whose tags colours could show; give some, or colour by "
                "size");
    }
}

}  // namespace

void check_order(const Job& job, const std::vector<JobFile>& files) {
    if (job.order == 1 || files.empty()) return;
    const bool held = std::any_of(files.begin(), files.end(), [](const JobFile& file) {
        return file.format->highest_order > 1;
    });
    if (held) return;
    throw InvalidInput("no output holds the mid-side nodes of order 2; add one of " +
                       second_order_extensions() + ", or take order 1");
}

void check_file_options(const Job& job, const std::vector<JobFile>& files) {
    if (job.file_options.colouring) check_colouring(job, *job.file_options.colouring);
    const double cut_width = job.file_options.cut_width;
    if (cut_width != 0 && !(cut_width >= kLeastCutWidth && cut_width <= kLargestCutWidth)) {
        throw InvalidInput("the width to cut is not between 0.001 and 1e6 mm");
    }
    for (const FileChoice& choice : kFileChoices) {
        // Files for cutters have no colours and no background.
        const bool taken = std::any_of(files.begin(), files.end(), [&](const JobFile& file) {
            const bool is_cut = cut_width != 0 && file.format->takes_cut_width;
            return file.format->*choice.taken &&
                   (!is_cut || choice.taken == &TileFormat::takes_cut_width);
        });
        if (taken || files.empty() || !choice.is_made(job)) continue;
        throw InvalidInput(std::string("no output takes ") + choice.name + "; add one of " +
                           extensions_that_take(choice) + ", or leave the option out");
    }
    if (job.file_options.gltf_nodes == GltfNodes::kCells &&
        !has_mesh(job, &MeshKindRow::faces_have_sites)) {
        throw InvalidInput(
            "Delaunay triangles have no cells that could be nodes; take the mesh voronoi or "
            "grains, or leave the glTF nodes out");
    }
}

std::optional<Colour> background_colour(const std::string& word) {
    if (word == "none") return std::nullopt;
    if (const auto colour = colour_of_hex(word)) return colour;
    throw InvalidInput("background " + word +
                       ": not a colour; take none or #rrggbb, such as #ffffff");
}

}  // namespace pcvt
