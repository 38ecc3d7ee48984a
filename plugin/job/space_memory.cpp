#include "plugin/job/space_memory.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/space/delaunay/orbit_insertion.hpp"
#include "plugin/job/job_memory.hpp"

namespace pcvt {
namespace {

/// Bytes a site: triangulating, optimising and building the cells, measured as SpaceFormat::memory.
constexpr double kBuilding = 5600;
/// The sites and their triangulation, and not the heap that their run leaves.
constexpr double kComputed = 400;
/// Tetrahedra that are held while other files are written.
constexpr double kHeldTetrahedra = 1100;

/// Cells that lose short edges, and the heap that this leaves for the rest of the run.
constexpr double kRemovingEdges = 7600;
constexpr double kRemovedEdges = 1200;

/// A voxel of an image of cells: its label, and those that the proof reads back, measured at 2^24
/// and 2^26 voxels.
constexpr double kVoxelInSpace = 10;

/// Tetrahedra inside of cells: of a cell at least, over the number of cubes of their size in its
/// volume, and bytes of each while their files are written, measured at 50 to 1,000 random cells.
constexpr double kGrainsOfCell = 130;
constexpr double kGrainsOfCube = 24;
constexpr double kGrainBytes = 1500;
/// The bytes that nodes in the middle of edges add for each.
constexpr double kMiddleNodes = 1000;

/// The tetrahedra inside of a cell to expect.
double grains_of_cell(const Job& job) {
    if (!mesh_kind_row(job.meshes.front()).grain_size) return 0;
    const double size = job.tile.grain_size;
    const double volume = job.in_space().lattice.volume() / job.n_wanted();
    constexpr double kDefaultCubes = 27;
    const double cubes = size > 0 ? volume / (size * size * size) : kDefaultCubes;
    return kGrainsOfCell + kGrainsOfCube * cubes;
}

/// A message about memory names the tetrahedra where there are this many times as usual.
constexpr double kManyTetrahedra = 3;

/// Bytes a site of the largest part of a run with these files.
double largest_bytes(const Job& job, const std::vector<JobFile>& files) {
    const double left = job.tile.short_edges > 0 ? kRemovedEdges : 0;
    double a_site = job.tile.short_edges > 0 ? kRemovingEdges : kBuilding;
    double held = 0;
    for (const JobFile& file : files) {
        a_site = std::max(a_site, file.format->space->memory + left);
        if (file.format->space->shows_tetrahedra(job.meshes.front())) held = kHeldTetrahedra;
    }
    const double grains =
        (kGrainBytes + (job.tile.order == 2 ? kMiddleNodes : 0)) * grains_of_cell(job);
    return a_site + (grains > 0 ? grains : held);
}

/// The number of cells, or of their pieces in a box, to expect: one side of a cube crosses about
/// 1.5 n^(2/3) cells.
double n_pieces(const Job& job) {
    const double n = job.n_wanted() * job.tile.repeat.n_copies();
    if (job.tile.outline != plane::Outline::kBox) return n;
    const Eigen::Vector3d heights = job.in_space().lattice.heights();
    const double area_over_square = job.in_space().lattice.volume() * heights.cwiseInverse().sum() /
                                    (3 * std::pow(job.in_space().lattice.volume(), 2.0 / 3));
    return n + 4.5 * area_over_square * std::pow(n, 2.0 / 3);
}

double voxels_bytes(const Job& job, const std::vector<JobFile>& files) {
    double bytes = 0;
    for (const JobFile& file : files) {
        if (file.format->space->encode_voxels == nullptr) continue;
        const VoxelCounts counts =
            requested_voxels(job.in_space().lattice, job.n_wanted(), job.file_options.voxels);
        bytes += kVoxelInSpace * counts.x * counts.y * counts.z;
    }
    return bytes;
}

}  // namespace

double memory_in_space(const Job& job, const std::vector<JobFile>& files) {
    const double n = job.n_wanted() * job.tile.repeat.n_copies();
    // The bytes a site are those of sites that are spread evenly.
    const double n_even =
        n_pieces(job) * std::max(1.0, job.n_tetrahedra * job.tile.repeat.n_copies() /
                                          space::kTetrahedraPerSite / n);
    return kCommandBytes + kThreadBytes * job.run.n_threads + n_even * largest_bytes(job, files) +
           voxels_bytes(job, files);
}

double space_memory_to_write(const Job& job, const std::vector<JobFile>& files) {
    return n_pieces(job) * (largest_bytes(job, files) - kComputed) + voxels_bytes(job, files);
}

std::string space_run_takes(const Job& job) {
    const auto n = static_cast<double>(job.n_given());
    if (!(job.n_tetrahedra > kManyTetrahedra * space::kTetrahedraPerSite * n)) {
        return "the run takes";
    }
    return "the sites have about " + std::to_string(std::llround(job.n_tetrahedra / n)) +
           " Delaunay tetrahedra each, as sites on two lines have, and the run takes";
}

}  // namespace pcvt
