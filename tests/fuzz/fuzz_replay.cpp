#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "io/bytes/input_file.hpp"
#include "tests/fuzz/fuzz_targets.hpp"
#include "tests/support/mutation.hpp"

/// Runs the targets of libFuzzer without it: on their seeds, on damaged copies of the seeds, and on
/// the files of a corpus, CORPUS/TARGET/*. The same inputs in every build.
namespace pcvt::testing {
namespace {

/// CPU time of one input. Sanitizers are slower by less than the distance to real inputs.
constexpr double kMostSeconds = 20;
/// Address space of the process, where no sanitizer takes more of it.
constexpr rlim_t kMostMemory = rlim_t{2} << 30;
constexpr std::uint64_t kSeed = 1;

#if defined(__has_feature)
#define PCVT_HAS_FEATURE(name) __has_feature(name)
#else
#define PCVT_HAS_FEATURE(name) 0
#endif
constexpr bool kSanitized =
    PCVT_HAS_FEATURE(address_sanitizer) || PCVT_HAS_FEATURE(thread_sanitizer);

void limit_memory() {
    if (kSanitized) return;
    const rlimit limit{kMostMemory, kMostMemory};
    if (setrlimit(RLIMIT_AS, &limit) != 0) std::perror("setrlimit");
}

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_utime.tv_sec) + 1e-6 * double(usage.ru_utime.tv_usec);
}

struct Replay {
    int n_inputs = 0;
    int n_violations = 0;

    void run(const FuzzTarget& target, const std::string& bytes, const std::string& label) {
        ++n_inputs;
        const double begin = cpu_seconds();
        std::string violation = run_fuzz_input(target, bytes);
        const double seconds = cpu_seconds() - begin;
        if (violation.empty() && seconds > kMostSeconds) {
            violation = "takes " + std::to_string(seconds) + " s";
        }
        if (violation.empty()) return;
        ++n_violations;
        std::printf("%s: %s\n", label.c_str(), violation.c_str());
    }
};

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::is_directory(folder)) return files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void replay_target(const FuzzTarget& target, const std::string& corpus, int n_mutants,
                   Replay& replay) {
    const std::string name(target.name);
    std::mt19937_64 random(kSeed);
    const std::vector<std::string> seeds = target.seeds();
    for (std::size_t k = 0; k < seeds.size(); ++k) {
        const std::string label = name + ", seed " + std::to_string(k);
        replay.run(target, seeds[k], label);
        for (int m = 0; m < n_mutants; ++m) {
            replay.run(target, mutated(seeds[k], random), label + ", mutant " + std::to_string(m));
        }
    }
    for (const auto& file : files_in(std::filesystem::path(corpus) / name)) {
        replay.run(target, read_whole_file(file.string()), file.string());
    }
}

/// Writes the seeds to FOLDER/TARGET/seed-K, where libFuzzer begins.
void write_seeds(const std::filesystem::path& folder) {
    for (const FuzzTarget& target : fuzz_targets()) {
        const std::filesystem::path own = folder / target.name;
        std::filesystem::create_directories(own);
        const std::vector<std::string> seeds = target.seeds();
        for (std::size_t k = 0; k < seeds.size(); ++k) {
            std::ofstream(own / ("seed-" + std::to_string(k)), std::ios::binary) << seeds[k];
        }
    }
}

int run(int argc, char** argv) {
    std::string corpus;
    std::string seeds;
    int n_mutants = 20;
    bool list = false;
    CLI::App app("Replays the inputs of the fuzz targets.");
    app.add_option("CORPUS", corpus, "a folder with a folder for each target");
    app.add_option("--mutants", n_mutants, "damaged copies of each seed");
    app.add_option("--write-seeds", seeds, "write the seeds into this folder instead");
    app.add_flag("--list", list, "print the names of the targets instead");
    CLI11_PARSE(app, argc, argv);
    if (list) {
        for (const FuzzTarget& target : fuzz_targets()) {
            std::printf("%s\n", std::string(target.name).c_str());
        }
        return 0;
    }
    if (!seeds.empty()) {
        write_seeds(seeds);
        return 0;
    }
    limit_memory();
    Replay replay;
    for (const FuzzTarget& target : fuzz_targets()) {
        replay_target(target, corpus, n_mutants, replay);
    }
    std::printf("%d inputs of %zu targets, %d violations\n", replay.n_inputs, fuzz_targets().size(),
                replay.n_violations);
    return replay.n_violations == 0 ? 0 : 1;
}

}  // namespace
}  // namespace pcvt::testing

int main(int argc, char** argv) { return pcvt::testing::run(argc, argv); }
