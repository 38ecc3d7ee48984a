#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "tests/mutants/mutated_formats.hpp"

/// Changes the fields of valid files one at a time and lists the changes that the proof accepts.
namespace pcvt::testing {
namespace {

struct Options {
    std::vector<std::string> formats;
    /// The number of mutants for each base file; 0: all.
    std::size_t sample = 0;
    std::uint64_t seed = 0;
    bool lists_fields = false;
    /// The largest number of accepted mutants that are described.
    std::size_t most_lines = 40;
    /// Where the base files and accepted mutants that are described are written; empty: nowhere.
    std::filesystem::path folder;
};

struct Tally {
    std::size_t n = 0;
    std::size_t harmless = 0;
    std::size_t accepted = 0;
};

bool is_harmless(const MutatedFormat& format, const BaseFile& base, const Mutant& mutant) {
    return std::any_of(format.harmless.begin(), format.harmless.end(), [&](const Harmless& row) {
        const bool all = row.field.ends_with('*');
        const bool field = all ? mutant.field.starts_with(row.field.substr(0, row.field.size() - 1))
                               : mutant.field == row.field;
        return field && base.name.starts_with(row.base) &&
               (row.change.empty() || row.change == mutant.change);
    });
}

std::vector<Mutant> sampled(std::vector<Mutant> mutants, const Options& options) {
    if (options.sample == 0 || mutants.size() <= options.sample) return mutants;
    std::mt19937_64 random(options.seed);
    for (std::size_t k = 0; k < options.sample; ++k) {
        std::swap(mutants[k], mutants[k + random() % (mutants.size() - k)]);
    }
    mutants.resize(options.sample);
    return mutants;
}

void write_files(const Files& files, const std::filesystem::path& folder) {
    for (const EncodedFile& file : files) {
        const std::filesystem::path path = folder / file.path;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << file.bytes;
    }
}

void run_base(const MutatedFormat& row, const BaseFile& base, const Options& options,
              std::map<std::string, Tally>& tallies) {
    if (const std::string fault = row.refusal(row.extension, base.files); !fault.empty()) {
        std::printf("%s, %s: the unchanged file is refused: %s\n", row.name.data(),
                    base.name.c_str(), fault.c_str());
        ++tallies["unchanged file"].accepted;
        return;
    }
    for (const Mutant& mutant : sampled(row.mutants(base), options)) {
        Tally& tally = tallies[mutant.field];
        ++tally.n;
        if (!row.refusal(row.extension, mutant.files()).empty()) continue;
        if (is_harmless(row, base, mutant)) {
            ++tally.harmless;
            continue;
        }
        if (++tally.accepted <= options.most_lines) {
            std::printf("%s, %s: accepted: %s, %s\n", row.name.data(), base.name.c_str(),
                        mutant.field.c_str(), mutant.change.c_str());
            if (options.folder.empty()) continue;
            write_files(base.files, options.folder / base.name / "base");
            write_files(mutant.files(), options.folder / base.name /
                                            (mutant.field + " " + mutant.change + " " +
                                             std::to_string(tally.accepted)));
        }
    }
}

/// Returns the number of faults.
std::size_t run_format(const MutatedFormat& row, const Options& options) {
    std::map<std::string, Tally> tallies;
    for (const BaseFile& base : row.bases(row.extension)) {
        run_base(row, base, options, tallies);
    }
    Tally sum;
    for (const auto& [field, tally] : tallies) {
        if (options.lists_fields) {
            std::printf("%-10s %-24s %6zu mutants, %5zu harmless, %5zu accepted\n", row.name.data(),
                        field.c_str(), tally.n, tally.harmless, tally.accepted);
        }
        sum.n += tally.n;
        sum.harmless += tally.harmless;
        sum.accepted += tally.accepted;
    }
    std::printf("%s: %zu mutants, %zu refused, %zu harmless, %zu accepted\n", row.name.data(),
                sum.n, sum.n - sum.harmless - sum.accepted, sum.harmless, sum.accepted);
    return sum.accepted;
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app{"Changes each field of valid files once; the proof must refuse the result."};
    app.add_option("FORMAT", options.formats, "rows of the table: obj space_vtu ...; none: all");
    app.add_option("--sample", options.sample, "mutants for each base file; 0: all");
    app.add_option("--seed", options.seed, "of the sample");
    app.add_flag("--fields", options.lists_fields, "list each field with its numbers");
    app.add_option("--lines", options.most_lines, "accepted mutants to describe for each field");
    app.add_option("--write", options.folder, "folder for the accepted mutants and their bases");
    CLI11_PARSE(app, argc, argv);
    std::size_t faults = 0;
    for (const MutatedFormat& row : mutated_formats()) {
        const bool wanted = options.formats.empty() ||
                            std::find(options.formats.begin(), options.formats.end(), row.name) !=
                                options.formats.end();
        if (wanted) faults += run_format(row, options);
    }
    return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace pcvt::testing

int main(int argc, char** argv) { return pcvt::testing::run(argc, argv); }
