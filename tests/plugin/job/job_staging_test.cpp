#include "plugin/job/job_staging.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "plugin/job/run_job.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using pcvt::testing::TemporaryFolder;
using ::testing::HasSubstr;

/// Returns a job for a honeycomb that is periodic on a rectangle, which every format supports.
Job job_for_every_format(const TemporaryFolder& folder, int n_threads) {
    Job job;
    job.in_plane().lattice = plane::Lattice::rectangle(1, 2 / std::sqrt(3.0));
    job.n_sites = 192;
    job.start = Start::kLattice;
    job.meshes = {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay};
    job.run.n_threads = n_threads;
    for (const std::string extension : {"obj", "ply", "glb", "gltf", "om", "svg", "vtu", "foam"}) {
        job.outputs.push_back(folder / ("tile." + extension));
    }
    for (const char* name : {"sites.txt", "mesh.nc"}) job.outputs.push_back(folder / name);
    return job;
}

std::map<std::string, std::string> files_written(int n_threads) {
    const TemporaryFolder folder;
    const RunSummary outcome =
        run_job(job_for_every_format(folder, n_threads), [](const JobProgress&) { return true; });
    EXPECT_EQ(outcome.run.stop, Stop::kConverged);
    return testing::files_below(folder);
}

TEST(JobStaging, SeveralThreadsWriteTheBytesOfOne) {
    const std::map<std::string, std::string> by_one = files_written(1);
    EXPECT_GT(by_one.size(), 30U);
    EXPECT_EQ(files_written(6), by_one);
}

// Random sites give obtuse triangles, which an MPAS mesh must not have.
TEST(JobStaging, ReportsTheFaultOfTheFirstFileInTheList) {
    const TemporaryFolder folder;
    Job job;
    job.n_sites = 20;
    job.run.max_iterations = 0;
    job.run.n_threads = 4;
    for (const char* name : {"tile.obj", "q.nc", "p.nc", "r.nc"}) {
        job.outputs.push_back(folder / name);
    }
    for (int k = 0; k < 20; ++k) {
        try {
            run_job(job, [](const JobProgress&) { return true; });
            FAIL() << "no fault";
        } catch (const InvalidInput& error) {
            ASSERT_THAT(error.what(), HasSubstr("q.nc"));
        }
        ASSERT_TRUE(testing::files_below(folder).empty());
    }
}

}  // namespace
}  // namespace pcvt
