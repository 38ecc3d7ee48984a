#include "plugin/job/job_progress.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "plugin/job/job.hpp"
#include "plugin/job/run_job.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using pcvt::testing::TemporaryFolder;
using std::chrono_literals::operator""ms;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;

constexpr std::array kPhases{Phase::kStarting, Phase::kOptimising, Phase::kBuilding,
                             Phase::kProving, Phase::kWriting};

/// Returns a job with every phase: a coarse start, three meshes and two outputs.
Job job_with_every_phase(const TemporaryFolder& folder) {
    Job job;
    job.n_sites = 1000;
    job.run.n_threads = 2;
    job.meshes = {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay, plane::MeshKind::kGrains};
    job.outputs = {folder / "t.ply", folder / "s.txt"};
    job.report = folder / "r.json";
    return job;
}

std::vector<JobProgress> seen_by(const Job& job) {
    std::vector<JobProgress> seen;
    const RunSummary summary = run_job(job, [&](const JobProgress& progress) {
        seen.push_back(progress);
        return true;
    });
    EXPECT_EQ(summary.run.stop, Stop::kConverged);
    return seen;
}

TEST(JobProgress, PhasesComeInOrderAndFractionsNeverFallWithinOne) {
    const TemporaryFolder folder;
    std::vector<Phase> phases;
    double fraction = 0;
    for (const JobProgress& progress : seen_by(job_with_every_phase(folder))) {
        if (phases.empty() || progress.phase != phases.back()) {
            EXPECT_GT(fraction, phases.empty() ? -1 : 0.9) << progress.text;
            phases.push_back(progress.phase);
            fraction = 0;
        }
        EXPECT_GE(progress.fraction, fraction) << progress.text;
        EXPECT_LE(progress.fraction, 1) << progress.text;
        fraction = progress.fraction;
    }
    EXPECT_EQ(phases, std::vector<Phase>(kPhases.begin(), kPhases.end()));
    EXPECT_NEAR(fraction, 1, 1e-9);
}

TEST(JobProgress, WordsNameTheMeshAndTheFile) {
    const TemporaryFolder folder;
    std::vector<std::string> texts;
    for (const JobProgress& progress : seen_by(job_with_every_phase(folder))) {
        if (texts.empty() || texts.back() != progress.text) texts.push_back(progress.text);
    }
    EXPECT_THAT(texts,
                IsSupersetOf({"placing the sites", "optimising", "building voronoi, 1 of 3",
                              "building grains, 3 of 3", "proving delaunay, 2 of 3",
                              "writing t-voronoi.ply, 1 of 4", "writing t-grains.ply, 3 of 4"}));
}

TEST(JobProgress, ASearchReportsItsBudget) {
    Job job;
    job.n_sites = 20;
    job.start = Start::kBest;
    job.budget = 2000;
    const std::vector<JobProgress> seen = seen_by(job);
    EXPECT_THAT(seen, Contains(::testing::Field(&JobProgress::text, "searching")));
    EXPECT_EQ(seen.front().fraction, 0);
    EXPECT_THAT(seen, Contains(::testing::Field(&JobProgress::fraction, ::testing::Gt(0.3))));
    EXPECT_EQ(seen.back().text, "optimising");
}

TEST(JobProgress, CancellingInAnyPhaseLeavesNothing) {
    for (const Phase phase : kPhases) {
        const TemporaryFolder folder;
        int n_calls = 0;
        const RunSummary summary =
            run_job(job_with_every_phase(folder), [&](const JobProgress& progress) {
                n_calls += progress.phase == phase;
                return progress.phase != phase;
            });
        EXPECT_EQ(summary.run.stop, Stop::kCancelled);
        EXPECT_EQ(n_calls, 1);
        EXPECT_THAT(folder.names(), IsEmpty());
    }
}

TEST(JobProgress, IsReportedOnTheCallingThreadAlone) {
    const TemporaryFolder folder;
    run_job(job_with_every_phase(folder),
            [caller = std::this_thread::get_id()](const JobProgress&) {
                EXPECT_EQ(caller, std::this_thread::get_id());
                return true;
            });
}

/// Records the fractions of a watched work.
struct Recorder {
    std::vector<double> fractions;
    JobCallback callback = [this](const JobProgress& progress) {
        fractions.push_back(progress.fraction);
        return true;
    };
    Job job;
    JobMonitor monitor{callback, job};
};

TEST(JobProgress, ALongStepIsReportedTenTimesASecond) {
    Recorder recorder;
    const auto begin = std::chrono::steady_clock::now();
    recorder.monitor.watch([&] {
        recorder.monitor.begin(Phase::kBuilding, "building");
        recorder.monitor.advance(0.5);
        std::this_thread::sleep_for(1500ms);
    });
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    // One at the beginning of the phase, one of the first tenth and one at the end more; a busy
    // machine lets fewer through.
    EXPECT_GE(recorder.fractions.size(), 5U);
    EXPECT_LE(double(recorder.fractions.size()), 10 * took.count() + 3);
    EXPECT_EQ(recorder.fractions.back(), 0.5);
}

TEST(JobProgress, AFractionNeverFalls) {
    Recorder recorder;
    recorder.monitor.watch([&] {
        recorder.monitor.begin(Phase::kBuilding, "building");
        for (const double fraction : {0.7, 0.3, 7.0}) {
            recorder.monitor.advance(fraction);
            recorder.monitor.describe("more");
        }
    });
    std::vector<double>& seen = recorder.fractions;
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    EXPECT_THAT(seen, ElementsAre(0, 0.7, 1));
}

TEST(JobProgress, FaultsOfTheWorkComeThrough) {
    Recorder recorder;
    EXPECT_THROW(recorder.monitor.watch([] { throw std::out_of_range("mine"); }),
                 std::out_of_range);
}

TEST(JobProgress, CancellingDuringTheLastStepCounts) {
    const JobCallback cancels = [](const JobProgress&) { return false; };
    const Job job;
    JobMonitor monitor(cancels, job);
    EXPECT_THROW(monitor.watch([&] { monitor.begin(Phase::kWriting, "writing"); }), Cancelled);
}

TEST(JobProgress, AFaultOfTheCallbackEndsTheWork) {
    const JobCallback throws = [](const JobProgress&) -> bool { throw std::out_of_range("mine"); };
    const Job job;
    JobMonitor monitor(throws, job);
    bool went_on = false;
    const auto work = [&] {
        monitor.begin(Phase::kBuilding, "building");
        // The callback runs on another thread, which a busy machine may start late.
        for (int k = 0; k < 1000; ++k) {
            std::this_thread::sleep_for(10ms);
            monitor.advance(0.5);
        }
        went_on = true;
    };
    EXPECT_THROW(monitor.watch(work), std::out_of_range);
    EXPECT_FALSE(went_on);
}

}  // namespace
}  // namespace pcvt
