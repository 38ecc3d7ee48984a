#include "plugin/space/space_memory.hpp"

#include <algorithm>

#include "plugin/job/job_memory.hpp"

namespace pcvt {
namespace {

/// Bytes a site: triangulating, optimising and building the cells, measured as SpaceFormat::memory.
constexpr double kBuilding = 5600;
/// Tetrahedra that are held while other files are written.
constexpr double kHeldTetrahedra = 800;

}  // namespace

double estimated_memory(const SpaceJob& job, const std::vector<SpaceJobFile>& files) {
    const double n = job.points.cols() > 0 ? static_cast<double>(job.points.cols()) : job.n_sites;
    double a_site = kBuilding;
    double held = 0;
    for (const SpaceJobFile& file : files) {
        a_site = std::max(a_site, file.format->memory);
        if (file.format->encode_tetrahedra != nullptr) held = kHeldTetrahedra;
    }
    return kCommandBytes + kThreadBytes * job.n_threads + n * (a_site + held);
}

}  // namespace pcvt
