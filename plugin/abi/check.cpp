// pcvt_check(). The module for browsers does not contain this file.
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "io/formats/output_files.hpp"
#include "io/run_files/area_reader.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/cells/target_areas.hpp"
#include "plugin/abi/guard.hpp"
#include "plugin/abi/host_progress.hpp"
#include "plugin/abi/option_values.hpp"
#include "plugin/abi/run_status.hpp"
#include "plugin/abi/struct_versions.hpp"
#include "plugin/checks/check_proof.hpp"
#include "plugin/job/job_density.hpp"
#include "plugin/pcvt.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name that C knows.
struct pcvt_proof {
    bool is_proved;
    std::string text;
};

namespace pcvt::abi {
namespace {

bool are_zero(const double* numbers, int n) {
    return std::all_of(numbers, numbers + n, [](double number) { return number == 0; });
}

void set_centroids(const pcvt_check_options& options, checks::Question& question) {
    question.cvt_tolerance = positive_or_none("cvt", options.cvt);
    std::optional<GreyRange> range;
    if (!are_zero(options.density_range, 2)) {
        range = GreyRange{options.density_range[0], options.density_range[1]};
    }
    if (options.density == nullptr) {
        if (range) throw InvalidInput("density_range without density; leave one out");
        return;
    }
    if (!question.cvt_tolerance) throw InvalidInput("density is for cvt; set that too");
    question.density = [source = std::string(options.density),
                        range](const plane::Lattice& lattice) {
        try {
            return source_density(source, range, lattice);
        } catch (const BadFile& error) {
            throw UnusableFile(error.what());  // The picture is wrong, not the file.
        }
    };
}

void require_file(const std::string& word, const std::string& sizes) {
    if (!names_area_law(sizes)) return;
    throw InvalidInput(word + "s is a law, which draws other " + word +
                       "s for each seed; give a file with one " + word + " a site");
}

checks::Question question_of(const pcvt_check_options& options) {
    checks::Question question;
    if (!are_zero(options.lattice, 4)) question.lattice = plane_lattice(options.lattice);
    question.tolerance = positive_or_none("tolerance", options.tolerance).value_or(0);
    set_centroids(options, question);
    if (options.areas != nullptr) {
        require_file("area", options.areas);
        question.areas = read_areas(area_table(options.areas));
    }
    if (options.volumes != nullptr) {
        require_file("volume", options.volumes);
        question.volumes = read_volumes(volume_table(options.volumes));
    }
    if (options.inclusions != nullptr) question.inclusions = read_inclusions(options.inclusions);
    return question;
}

/// The verdict with its text as one line without a line end.
pcvt_proof verdict(bool is_proved, std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return {is_proved, std::move(text)};
}

/// A file whose contents are not what its format demands is refuted as well.
/// @throws InvalidInput where it cannot be examined.
pcvt_proof proof_of(const std::string& path, const checks::Question& question) {
    try {
        return verdict(true, checks::prove(path, question));
    } catch (const NotATile& refutation) {
        return verdict(false, in_fields(refutation.what()));
    } catch (const UnusableFile&) {
        throw;
    } catch (const BadFile& refutation) {
        return verdict(false, in_fields(refutation.what()));
    }
}

pcvt_status check(const char* path, const pcvt_check_options* given, pcvt_proof** proof,
                  const std::fenv_t& host) {
    if (proof == nullptr) throw InvalidInput("proof is a null pointer");
    *proof = nullptr;
    if (path == nullptr || *path == '\0') {
        throw InvalidInput("path is empty; give the name of a file");
    }
    pcvt_check_options options{};
    if (given != nullptr) options = read_struct("pcvt_check_options", given);
    const checks::Question question = question_of(options);
    const std::string name = without_slash(path);
    const JobCallback callback = job_callback({options.progress, options.progress_data},
                                              std::numeric_limits<double>::quiet_NaN(), host);
    const Job no_job;
    JobMonitor monitor(callback, no_job);
    pcvt_proof found{};
    try {
        monitor.watch([&] {
            monitor.begin(Phase::kProving, "proving " + name);
            found = proof_of(name, question);
        });
    } catch (const Cancelled&) {
        return cancelled_status();
    }
    *proof = new pcvt_proof(std::move(found));
    if ((*proof)->is_proved) return PCVT_OK;
    set_last_error((*proof)->text.c_str());
    return PCVT_REFUTED;
}

}  // namespace
}  // namespace pcvt::abi

using namespace pcvt::abi;

pcvt_status pcvt_check(const char* path, const pcvt_check_options* options, pcvt_proof** proof) {
    return guarded([&](const std::fenv_t& host) { return check(path, options, proof, host); });
}

const char* pcvt_proof_text(const pcvt_proof* proof) {
    return proof == nullptr ? "" : proof->text.c_str();
}

void pcvt_free_proof(pcvt_proof* proof) { delete proof; }
