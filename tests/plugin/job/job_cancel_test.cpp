/// Every long step of a run looks often enough whether the run is cancelled. The unit of time is
/// the first triangulation of the same sites, so that the limits hold for any build and machine: it
/// takes 0.3 s for 10^6 sites.

#include <gmock/gmock.h>

#include <atomic>
#include <ctime>
#include <map>
#include <mutex>
#include <random>

#include "mesher/plane/density/pixel_grid.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/run_job.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using pcvt::testing::TemporaryFolder;
using ::testing::IsEmpty;

constexpr int kSites = 20'000;
/// In units of the first triangulation.
constexpr double kLongestPause = 8;

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The seconds of the first triangulation.
double unit_of_time() {
    const plane::Lattice square = plane::Lattice::rectangle(1, 1);
    double best = 1e9;
    for (int k = 0; k < 3; ++k) {
        const plane::Points points = uniform_points(square, kSites, k);
        const double begin = cpu_seconds();
        const plane::PeriodicDelaunay delaunay(plane::Sites(square, points));
        best = std::min(best, cpu_seconds() - begin);
    }
    return best;
}

/// Measures the time of each thread between two checkpoints, and keeps the longest one of each
/// phase.
class Pauses final : public Client {
   public:
    void pass() override {
        thread_local int of = 0;
        thread_local double last = 0;
        const double now = cpu_seconds();
        const double pause = of == id_ ? now - last : 0;
        of = id_;
        if (pause > 0.2e-3) note(pause);
        last = cpu_seconds();
    }
    void begin(const std::string& phase) {
        const std::lock_guard lock(mutex_);
        phase_ = phase;
    }
    const std::map<std::string, double>& longest() const { return longest_; }

   private:
    void note(double pause) {
        const std::lock_guard lock(mutex_);
        double& longest = longest_[phase_];
        longest = std::max(longest, pause);
    }

    static inline int n_made_ = 0;

    int id_ = ++n_made_;
    std::mutex mutex_;
    std::string phase_ = "before";
    std::map<std::string, double> longest_;
};

void expect_short_pauses(const Job& job) {
    const double limit = kLongestPause * unit_of_time();
    Pauses pauses;
    {
        const ClientScope scope(&pauses);
        run_job(job, [&](const JobProgress& progress) {
            pauses.begin(progress.text);
            return true;
        });
    }
    for (const auto& [phase, seconds] : pauses.longest()) {
        EXPECT_LT(seconds, limit) << phase << ", in units " << kLongestPause * seconds / limit;
    }
}

Job job_of(int n_sites, int max_iterations, const TemporaryFolder& folder,
           const std::vector<std::string>& names) {
    Job job;
    job.n_sites = n_sites;
    job.run.max_iterations = max_iterations;
    for (const std::string& name : names) job.outputs.push_back(folder / name);
    job.report = folder / "r.json";
    return job;
}

TEST(Cancelling, IsNoticedWhileCellsAreMadeAndWritten) {
    const TemporaryFolder folder;
    Job job = job_of(kSites, 30, folder,
                     {"t.obj", "t.ply", "t.glb", "t.gltf", "t.om", "t.svg", "t.html", "t.png",
                      "t.dxf", "t.vtu", "t.foam", "t.txt", "t.csv"});
    job.run.n_threads = 2;
    expect_short_pauses(job);
}

TEST(Cancelling, IsNoticedInBoxesRepeatsAndGrains) {
    const TemporaryFolder folder;
    Job job = job_of(kSites / 10, 30, folder, {"t.obj"});
    job.tile.repeat.columns = 4;
    job.tile.repeat.rows = 3;
    job.tile.outline = plane::Outline::kBox;
    job.tile.finds_origin = true;
    job.tile.short_edges = 0.1;
    expect_short_pauses(job);
    job = job_of(kSites / 20, 30, folder, {"t.msh", "t.inp", "u.vtu"});
    job.meshes = {plane::MeshKind::kGrains};
    job.tile.order = 2;
    job.force = true;
    expect_short_pauses(job);
}

TEST(Cancelling, IsNoticedInPatternsAndSearches) {
    const TemporaryFolder folder;
    Job job = job_of(kSites, 0, folder, {"t.ply"});
    job.start = Start::kLattice;
    job.in_plane().lattice = plane::Lattice({1, 0}, {0.37, 0.81});
    expect_short_pauses(job);
    job = job_of(300, -1, folder, {"u.ply"});
    job.start = Start::kBest;
    job.budget = 2000;
    job.force = true;
    expect_short_pauses(job);
}

TEST(Cancelling, SlowIsNoticedWithDensities) {
    const TemporaryFolder folder;
    Job job = job_of(kSites, 10, folder, {"t.txt"});
    job.density =
        plane::shared_density([](const plane::DensityPoint& p) { return 1 + 9 * p.u * p.v; });
    job.start = Start::kCoarse;
    expect_short_pauses(job);
    // Few sites on many pixels.
    job = job_of(30, 3, folder, {"t.txt"});
    std::vector<float> greys(1 << 20);
    for (std::size_t k = 0; k < greys.size(); ++k) greys[k] = float(k % 101) / 100;
    job.density = pixel_density(plane::PixelGrid(1 << 10, 1 << 10, std::move(greys), 0.1, 1));
    job.force = true;
    expect_short_pauses(job);
}

TEST(Cancelling, IsNoticedWhileAreasAreFitted) {
    const TemporaryFolder folder;
    Job job = job_of(kSites, 1, folder, {"t.svg", "t.csv"});
    job.sizes = TargetSizes{.law = parse_area_law("lognormal:0.42"), .name = "lognormal:0.42"};
    job.aspect = Aspect{.ratio = 2, .degrees = 30};
    expect_short_pauses(job);
}

/// Cancels the run at a checkpoint.
class CancelAt final : public Client {
   public:
    explicit CancelAt(long pass) : left_(pass) {}
    void pass() override {
        if (--left_ <= 0) throw Cancelled{};
    }
    long left() const { return left_; }

   private:
    std::atomic<long> left_;
};

TEST(Cancelling, AtAnyCheckpointLeavesNothing) {
    std::mt19937 random(1);
    constexpr long kMany = 1L << 40;
    const auto run = [](const TemporaryFolder& folder, CancelAt& client) {
        Job job = job_of(200, -1, folder, {"t.obj", "t.glb", "t.msh", "new/t.foam", "t.txt"});
        job.meshes = {plane::MeshKind::kGrains};
        job.run.n_threads = 2;
        const ClientScope scope(&client);
        return run_job(job, {}).run.stop;
    };
    CancelAt never(kMany);
    const TemporaryFolder whole;
    EXPECT_EQ(run(whole, never), Stop::kConverged);
    const long n_passes = kMany - never.left();
    EXPECT_GT(n_passes, 10'000);
    for (int k = 0; k < 40; ++k) {
        const TemporaryFolder folder;
        CancelAt client(1 + long(random() % std::uint64_t(n_passes * 9 / 10)));
        EXPECT_EQ(run(folder, client), Stop::kCancelled);
        EXPECT_THAT(folder.names(), IsEmpty());
    }
}

}  // namespace
}  // namespace pcvt
