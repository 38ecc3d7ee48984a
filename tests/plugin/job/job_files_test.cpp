#include "plugin/job/job_files.hpp"

#include <gmock/gmock.h>

namespace pcvt {
namespace {

using ::testing::ElementsAre;

TEST(JobFiles, CompanionsFollowTheirFile) {
    Job job;
    job.outputs = {"t.obj", "s.txt"};
    const std::vector<JobFile> files = plan_files(job);
    ASSERT_EQ(files.size(), 2U);
    EXPECT_THAT(files[0].paths, ElementsAre("t.obj", "t.mtl", "t.seam.json"));
    EXPECT_THAT(files[1].paths, ElementsAre("s.txt"));
    EXPECT_FALSE(files[1].format->needs_tile());
}

TEST(JobFiles, EachMeshHasASeparateFileAndTheSitesHaveOne) {
    Job job;
    job.meshes = {plane::MeshKind::kDelaunay, plane::MeshKind::kVoronoi};
    job.outputs = {"t.ply", "s.txt"};
    const std::vector<JobFile> files = plan_files(job);
    ASSERT_EQ(files.size(), 3U);
    EXPECT_THAT(files[0].paths, ElementsAre("t-delaunay.ply"));
    EXPECT_THAT(files[1].paths, ElementsAre("t-voronoi.ply"));
    EXPECT_EQ(files[1].mesh, 1);
    EXPECT_EQ(files[2].mesh, -1);
}

TEST(JobFiles, ACaseIsAFolderAndTheCGridOneForAllMeshes) {
    Job job;
    job.meshes = {plane::MeshKind::kDelaunay, plane::MeshKind::kVoronoi};
    job.outputs = {"t.foam", "t.nc"};
    const std::vector<JobFile> files = plan_files(job);
    ASSERT_EQ(files.size(), 3U);
    EXPECT_EQ(files[0].folder, "t-delaunay.foam");
    EXPECT_EQ(files[0].paths.front(), "t-delaunay.foam/constant/polyMesh/points");
    EXPECT_TRUE(files[2].format->reads_grid());
    EXPECT_THAT(files[2].paths, ElementsAre("t.nc", "t.graph.info"));
}

TEST(JobFiles, ACGridNeedsARectangleAndEveryEdge) {
    Job job;
    job.outputs = {"t.nc"};
    job.in_plane().lattice = plane::Lattice({1, 0}, {0.5, 0.8});
    EXPECT_THROW(plan_files(job), InvalidInput);
    job.tile.repeat.rows = 2;
    EXPECT_EQ(plan_files(job).size(), 1U);
    job.tile.short_edges = 0.1;
    EXPECT_THROW(plan_files(job), InvalidInput);
}

TEST(JobFiles, OneNameForTwoFilesIsRefusedInAnySpelling) {
    Job job;
    job.outputs = {"t.ply", "./x/../t.ply"};
    EXPECT_THROW(plan_files(job), InvalidInput);
    job.outputs = {"t.obj"};
    job.report = "t.seam.json";
    EXPECT_THROW(plan_files(job), InvalidInput);
    job.report.clear();
    job.inputs = {"t.mtl"};
    EXPECT_THROW(plan_files(job), InvalidInput);
}

TEST(JobFiles, ExtensionsOfEitherCaseAreKnownAndOthersRefused) {
    Job job;
    job.outputs = {"T.OBJ", "S.TXT"};
    EXPECT_EQ(plan_files(job).size(), 2U);
    for (const char* path : {"t.xyz", "t", ".obj", "t.msh", "-"}) {
        job.outputs = {path};
        EXPECT_THROW(plan_files(job), InvalidInput) << path;
    }
}

std::string refusal(const std::string& path) {
    Job job;
    job.outputs = {path};
    try {
        plan_files(job);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "";
}

TEST(JobFiles, ARefusalDistinguishesUnknownFromMissingExtensions) {
    EXPECT_EQ(refusal("t.n"), "-o t.n: unknown extension .n; take one of " + output_extensions());
    EXPECT_EQ(refusal("t"), "-o t: no extension; take one of " + output_extensions());
}

}  // namespace
}  // namespace pcvt
