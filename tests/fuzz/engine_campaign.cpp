#include <sys/time.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <map>

#include "tests/fuzz/random_inputs.hpp"
#include "tests/support/checked_engine.hpp"
#include "tests/support/moves.hpp"

/// Runs random jobs and compares the engine with its references (engine_twin.hpp), until the time
/// or the number of jobs is reached or a job finds a difference. Job k of a seed is always the
/// same.
namespace pcvt::testing {
namespace {

/// A job that uses more CPU time hangs.
constexpr int kSecondsPerJob = 120;
constexpr int kMostMovesPerJob = 24;
constexpr double kSecondsPerLine = 60;

struct Options {
    std::uint64_t seed = 1;
    std::int64_t first_job = 0;
    std::int64_t jobs = -1;
    double seconds = 10;
};

/// The timer's message, prepared in advance, because a signal handler must not allocate.
char reproduction[200];

void report_hang(int) {
    constexpr char kWords[] = "a job hangs; ";
    const auto written = write(STDERR_FILENO, kWords, sizeof kWords - 1) +
                         write(STDERR_FILENO, reproduction, std::strlen(reproduction));
    _exit(written > 0 ? 1 : 2);
}

/// One sequence of moves, recorded for the report of a difference.
struct Job {
    EngineTally tally;
    std::map<std::string, int> lattices;
    std::string story;
    std::string fault;
};

/// A random kind of move; two thirds are local.
int any_kind(std::mt19937_64& random) {
    const int n_kinds = random() % 2 == 0 ? kLocalMoveKinds : kMoveKinds;
    return static_cast<int>(random() % static_cast<unsigned>(n_kinds));
}

void move_about(CheckedEngine& engine, std::mt19937_64& random, std::string& story) {
    const int n_moves = 1 + static_cast<int>(random() % kMostMovesPerJob);
    int kind = 0;
    for (int k = 0; k < n_moves && engine.fault().empty(); ++k) {
        // Repeats one kind in sequence: some moves reach their goal exactly only after three
        // repetitions.
        if (k == 0 || random() % 3 == 0) kind = any_kind(random);
        const auto [name, direction] = any_move(engine.delaunay(), engine.energy(), random, kind);
        const double t = random() % 4 == 0 ? 0.25 : 1;
        story += "\n  " + std::to_string(k) + ": " + name + (t == 1 ? "" : ", a quarter");
        const bool moved = engine.move(direction, t);
        if (!engine.fault().empty() || !moved) continue;
        if (random() % 3 == 0) {
            story += ", and back";
            engine.step_back();
        } else {
            engine.settle();
        }
    }
    if (engine.fault().empty()) engine.release();
}

Job run_job(std::uint64_t seed, std::int64_t number) {
    std::seed_seq seeds{std::uint32_t(seed), std::uint32_t(seed >> 32), std::uint32_t(number),
                        std::uint32_t(number >> 32)};
    std::mt19937_64 random(seeds);
    Job job;
    try {
        const Beginning beginning = any_beginning(random);
        const plane::Lattice& reduced = beginning.sites.reduction().reduced;
        std::ostringstream text;
        text.precision(17);
        text << beginning.lattice_kind << " lattice (" << reduced.a().transpose() << ") ("
             << reduced.b().transpose() << "), " << beginning.sites.n_sites() << " sites "
             << beginning.sites_kind;
        job.story = text.str();
        CheckedEngine engine(beginning.sites);
        move_about(engine, random, job.story);
        job.tally = engine.tally();
        job.fault = engine.fault();
    } catch (const std::exception& error) {
        job.fault = error.what();
    }
    return job;
}

void print(const char* head, const Options& options, std::int64_t jobs, const EngineTally& sum) {
    std::printf(
        "%s: seed %llu, %lld jobs, %lld moves (%lld with coincident sites), %lld flips, "
        "%lld rebuilds, %lld local repairs, %lld of %lld predicates left the filter\n",
        head, static_cast<unsigned long long>(options.seed), static_cast<long long>(jobs),
        static_cast<long long>(sum.moves), static_cast<long long>(sum.undefined),
        static_cast<long long>(sum.flips), static_cast<long long>(sum.rebuilds),
        static_cast<long long>(sum.local_repairs), static_cast<long long>(sum.exact),
        static_cast<long long>(sum.predicates));
    std::fflush(stdout);
}

int run_campaign(const Options& options) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    std::signal(SIGPROF, report_hang);
    EngineTally sum;
    std::int64_t jobs = 0;
    double next_line = kSecondsPerLine;
    for (; options.jobs >= 0 ? jobs < options.jobs : seconds() < options.seconds; ++jobs) {
        const std::int64_t number = options.first_job + jobs;
        std::snprintf(reproduction, sizeof reproduction,
                      "again by: engine_campaign --seed %llu --first-job %lld --jobs 1\n",
                      static_cast<unsigned long long>(options.seed),
                      static_cast<long long>(number));
        const itimerval limit{{0, 0}, {kSecondsPerJob, 0}};
        setitimer(ITIMER_PROF, &limit, nullptr);
        const Job job = run_job(options.seed, number);
        sum += job.tally;
        if (!job.fault.empty()) {
            std::printf("%s\n%s\n%s", job.story.c_str(), job.fault.c_str(), reproduction);
            return 1;
        }
        if (seconds() > next_line) {
            print("so far", options, jobs + 1, sum);
            next_line += kSecondsPerLine;
        }
    }
    print("no difference", options, jobs, sum);
    return 0;
}

}  // namespace
}  // namespace pcvt::testing

int main(int argc, char** argv) {
    pcvt::testing::Options options;
    CLI::App app("Compares the engine with its references on random jobs.");
    app.add_option("--seed", options.seed);
    app.add_option("--first-job", options.first_job);
    app.add_option("--jobs", options.jobs, "as many jobs, however long they take");
    app.add_option("--seconds", options.seconds, "without --jobs");
    CLI11_PARSE(app, argc, argv);
    return pcvt::testing::run_campaign(options);
}
