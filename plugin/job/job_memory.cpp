#include "plugin/job/job_memory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

#include "mesher/base/error.hpp"
#include "plugin/job/available_memory.hpp"
#include "plugin/job/job_tiles.hpp"
#include "plugin/job/space_memory.hpp"

namespace pcvt {
namespace {

// Measured at 5e4 to 1e7 sites, with the heap that the command keeps (malloc_tuning); the figures
// include the triangulation of the sites, which lives to the end of the run.

/// Bytes a site until the sites are where they end.
constexpr double kTriangulating = 185;
constexpr double kOptimising = 205;
constexpr double kWithDensity = 60;
/// Runs with prescribed areas, at fixed and at moving sites.
constexpr double kFittingAreas = 780;
constexpr double kMovingWithAreas = 980;
/// Sites of a file, with their lines.
constexpr double kFromFile = 65;

/// A run that builds its tile only for the figures.
constexpr FormatMemory kBuilt{600, 0, 230};
constexpr FormatMemory kBuiltBox{930, 0, 230};
/// A tile that is held while others are built and written.
constexpr FormatMemory kHeld{160, 60, 60};
/// A tile that is mapped to the round space of its aspect for its proof.
constexpr FormatMemory kMapped{160, 60, 170};
/// Meshes that a host of the C interface asks for, beside the sites, for each copy of these:
/// measured at 1e5 and 1e6 sites, with the arrays of the interface.
constexpr FormatMemory kHanded{400, 160, 260};
/// A box outline, and the map to the round space of an aspect, take these times as much.
constexpr double kBoxedCells = 1.9;
constexpr double kMappedGrains = 1.3;
/// A wedge of six or fifteen nodes in place of its triangle: most of its file are equations.
constexpr std::array<double, 3> kWedge{1, 3.7, 7};
/// The part of its own run that a file adds while another one is written.
constexpr double kBesideAnother = 0.5;
/// A pixel of a picture that one colours.
constexpr double kPixel = 3.2;
/// A voxel of an image of cells.
constexpr double kVoxel = 11;
/// The same voxel in each further layer, which the proof decompresses.
constexpr double kVoxelOfALayer = 4.2;
/// The number of pixels of a side where the job gives none.
constexpr double kDefaultPixels = 500;
/// The part of these bytes that depends on the sites and not on their copies in a repeated tile.
constexpr double kOfSites = 1.0 / 3;
/// Triangles of grains in a square of their size; equilateral ones would be 2.3.
constexpr double kTrianglesPerSquare = 3;
/// A triangle with mid-side nodes takes this many times the memory of one without.
constexpr double kOrder2 = 1.85;

/// An estimate may be too high by this factor: a run is refused only where it cannot fit.
constexpr double kMostAbovePeak = 1.25;

constexpr double kMegabyte = 1e6;
constexpr double kGigabyte = 1e9;

/// With the mirror images between walls.
double n_sites(const Job& job) {
    const double n = job.n_wanted();
    return n * n_images(job.walls);
}

/// The number of triangles of the grains, those with mid-side nodes counted as several.
double n_grain_triangles(const Job& job) {
    const double copies = job.tile.repeat.n_copies();
    // Edges of the default size are h / 3; a regular hexagon has edges of 0.62 h.
    const double parts = job.tile.grain_per_edge > 0 ? 1.6 * job.tile.grain_per_edge : 3;
    const double squares = job.tile.grain_size > 0 ? job.in_plane().lattice.area() * copies /
                                                         (job.tile.grain_size * job.tile.grain_size)
                                                   : n_sites(job) * copies * parts * parts;
    return kTrianglesPerSquare * squares * (job.tile.order == 2 ? kOrder2 : 1);
}

double mesh_bytes(const Job& job, plane::MeshKind kind, const FormatMemory& bytes) {
    if (mesh_kind_row(kind).grain_size) return bytes.grain * n_grain_triangles(job);
    const double copies = job.tile.repeat.n_copies();
    const double a_site = kind == plane::MeshKind::kVoronoi ? bytes.cell : 2 * bytes.triangle;
    return a_site * n_sites(job) * (kOfSites + (1 - kOfSites) * copies);
}

double voxel_bytes(const Job& job) {
    const plane::VoxelCounts counts = requested_voxels(format_request(job));
    return double(counts.x) * counts.y * (kVoxel + kVoxelOfALayer * (counts.z - 1));
}

/// A run that writes only this file.
double file_bytes(const Job& job, const JobFile& file) {
    const plane::MeshKind kind =
        file.mesh < 0 ? plane::MeshKind::kVoronoi : job.meshes[static_cast<std::size_t>(file.mesh)];
    const double side = job.file_options.pixels != 0 ? job.file_options.pixels : kDefaultPixels;
    const double pixels = file.format->takes.pixels ? kPixel * side * side : 0;
    const int wedges =
        file.format->takes.element ? plane_element_row(job.file_options.element).wedge_order : 0;
    return kWedge[wedges] * mesh_bytes(job, kind, file.format->memory) + pixels +
           (file.format->takes.voxels ? voxel_bytes(job) : 0);
}

/// The sites, from their start to the end of their optimisation.
double site_bytes(const Job& job) {
    const bool is_fixed = job.run.max_iterations == 0;
    const double moving = job.has_weights() ? (is_fixed ? kFittingAreas : kMovingWithAreas)
                                            : (is_fixed ? kTriangulating : kOptimising);
    return n_sites(job) * (moving + (job.density ? kWithDensity : 0));
}

/// The meshes of a run and their files, with the triangulation of the sites.
double tile_bytes(const Job& job, const std::vector<JobFile>& files) {
    // The files that take most are written at the same time.
    std::vector<double> writing;
    for (const JobFile& file : files) writing.push_back(file_bytes(job, file));
    std::sort(writing.begin(), writing.end(), std::greater<>());
    const std::size_t n_at_once =
        std::min(writing.size(), static_cast<std::size_t>(std::max(1, job.run.n_threads)));
    double meshes = 0;
    for (std::size_t k = 0; k < n_at_once; ++k)
        meshes += (k == 0 ? 1 : kBesideAnother) * writing[k];
    // All tiles of a job are built before the first file is written.
    if (needs_tiles(job, files)) {
        const FormatMemory& built = job.tile.outline == plane::Outline::kBox ? kBuiltBox : kBuilt;
        meshes = std::max(meshes, mesh_bytes(job, job.meshes.front(), built));
        for (std::size_t k = 1; k < job.meshes.size(); ++k) {
            meshes += mesh_bytes(job, job.meshes[k], kHeld);
        }
    }
    if (job.aspect) {
        // The cells are counted in the plane in any case.
        meshes = std::max(meshes + mesh_bytes(job, job.meshes.front(), kMapped),
                          mesh_bytes(job, plane::MeshKind::kVoronoi, kBuilt));
    }
    return meshes;
}

}  // namespace

void require_available(const std::string& what, double estimate, const char* remedy) {
    const std::optional<double> available = available_memory();
    if (!available || estimate <= kMostAbovePeak * *available) return;
    throw LimitExceeded(what + " about " + memory_text(estimate) + " of memory, and " +
                        memory_text(*available) + " are available; " + remedy);
}

double estimated_memory(const Job& job, const std::vector<JobFile>& files) {
    if (job.is_in_space()) return memory_in_space(job, files);
    const double from_file = job.n_given() > 0 ? kFromFile * n_sites(job) : 0;
    return kCommandBytes + kThreadBytes * job.run.n_threads + from_file +
           std::max(site_bytes(job), tile_bytes(job, files));
}

void require_memory(const Job& job, const std::vector<JobFile>& files) {
    require_available(job.is_in_space() ? space_run_takes(job) : "the run takes",
                      estimated_memory(job, files),
                      files.empty() ? "take fewer sites" : kFewerOutputs);
}

void require_memory_to_write(const Job& job, const std::vector<JobFile>& files) {
    if (job.is_in_space()) {
        require_available("the files take", space_memory_to_write(job, files), kFewerOutputs);
        return;
    }
    // The result holds the triangulation, and perhaps its tile.
    const double held = kTriangulating * n_sites(job) + mesh_bytes(job, job.meshes.front(), kHeld);
    require_available("the files take", tile_bytes(job, files) - held, kFewerOutputs);
}

void require_memory_for_mesh(const Job& job, plane::MeshKind kind) {
    const double copies = job.tile.repeat.n_copies();
    if (mesh_kind_row(kind).grain_size) {
        require_available("the tile takes",
                          kHanded.grain * n_grain_triangles(job) * (job.aspect ? kMappedGrains : 1),
                          "take fewer sites, or larger grains");
        return;
    }
    const double boxed = job.tile.outline == plane::Outline::kBox ? kBoxedCells : 1;
    const double a_site =
        kind == plane::MeshKind::kVoronoi ? boxed * kHanded.cell : 2 * kHanded.triangle;
    require_available("the mesh takes", a_site * n_sites(job) * copies,
                      copies > 1 ? "take fewer sites or copies" : "take fewer sites");
}

std::string memory_text(double bytes) {
    std::array<char, 32> text;
    const bool is_small = bytes < 0.1 * kGigabyte;
    std::snprintf(text.data(), text.size(), is_small ? "%.3g MB" : "%.3g GB",
                  bytes / (is_small ? kMegabyte : kGigabyte));
    return text.data();
}

}  // namespace pcvt
