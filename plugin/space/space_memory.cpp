#include "plugin/space/space_memory.hpp"

#include <algorithm>

#include "plugin/job/job_memory.hpp"

namespace pcvt {
namespace {

/// Bytes a site: triangulating, optimising and building the cells, measured as SpaceFormat::memory.
constexpr double kBuilding = 5600;
/// A SpaceComputation, and not the heap that its run leaves.
constexpr double kComputed = 400;
/// Tetrahedra that are held while other files are written.
constexpr double kHeldTetrahedra = 1100;

/// Bytes a site of the largest part of a run with these files.
double largest_bytes(const std::vector<SpaceJobFile>& files, const SpaceFileOptions& options) {
    double a_site = kBuilding;
    double held = 0;
    for (const SpaceJobFile& file : files) {
        a_site = std::max(a_site, file.format->memory);
        if (file.format->shows_tetrahedra(options)) held = kHeldTetrahedra;
    }
    return a_site + held;
}

}  // namespace

double estimated_memory(const SpaceJob& job, const std::vector<SpaceJobFile>& files) {
    const double n = job.points.cols() > 0 ? static_cast<double>(job.points.cols()) : job.n_sites;
    return kCommandBytes + kThreadBytes * job.n_threads +
           n * largest_bytes(files, job.file_options);
}

double memory_of_cells(int n_sites) { return memory_to_write(n_sites, {}, {}); }

double memory_to_write(int n_sites, const std::vector<SpaceJobFile>& files,
                       const SpaceFileOptions& options) {
    return n_sites * (largest_bytes(files, options) - kComputed);
}

}  // namespace pcvt
