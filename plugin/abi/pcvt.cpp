#include "plugin/pcvt.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "plugin/abi/density.hpp"
#include "plugin/abi/guard.hpp"
#include "plugin/abi/host_progress.hpp"
#include "plugin/abi/options.hpp"
#include "plugin/abi/progress_sites.hpp"
#include "plugin/abi/result.hpp"
#include "plugin/abi/run_status.hpp"
#include "plugin/abi/space_result.hpp"
#include "plugin/abi/struct_versions.hpp"
#include "plugin/abi/views.hpp"
#include "plugin/abi/write_options.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/version.hpp"

// NOLINTNEXTLINE(readability-identifier-naming): the name that C knows.
struct pcvt_result {
    template <class Content, class... Arguments>
    explicit pcvt_result(std::in_place_type_t<Content> type, Arguments&&... arguments)
        : content(type, std::forward<Arguments>(arguments)...) {}

    /// In the plane, or in space.
    std::variant<pcvt::abi::Result, pcvt::abi::SpaceResult> content;
};

namespace pcvt::abi {
namespace {

/// The bound of the energy, which runs without a density have; else NaN.
double bound_of(const pcvt_options& options, const Job& job) {
    const bool uniform = options.density == nullptr && options.density_source == nullptr;
    return uniform ? energy_bound(job) : std::numeric_limits<double>::quiet_NaN();
}

/// @returns false if the callback cancelled.
bool read_density(const pcvt_options& options, const JobCallback& callback, const std::fenv_t& host,
                  Job& job) {
    JobMonitor monitor(callback, job);
    try {
        set_density(options, host, job);
    } catch (const Cancelled&) {
        return false;
    }
    return true;
}

/// @tparam Content  Result or SpaceResult.
template <class Content>
pcvt_status generate(Job job, const pcvt_options& options, pcvt_result** result,
                     const std::fenv_t& host) {
    settle_duplicates(job);
    const Job* const shown = job.is_in_space() ? nullptr : &job;
    const JobCallback callback = job_callback({options.progress, options.progress_data, shown},
                                              bound_of(options, job), host);
    std::optional<Computation<typename Content::World>> computed;
    if (read_density(options, callback, host, job)) {
        computed = compute_job<typename Content::World>(job, callback);
    }
    if (!computed) return cancelled_status();
    const pcvt_status status = status_of(job.run.max_iterations, computed->cells.run);
    // The callback may not be called after this call.
    if (job.density) job.density = plane::Density{};
    *result = new pcvt_result(std::in_place_type<Content>, std::move(job), *std::move(computed));
    return status;
}

pcvt_status generate(const pcvt_options* given, pcvt_result** result, const std::fenv_t& host) {
    if (result == nullptr) throw InvalidInput("result is a null pointer");
    *result = nullptr;
    const pcvt_options options = read_struct("pcvt_options", given);
    Job job = make_job(options);
    return job.is_in_space() ? generate<SpaceResult>(std::move(job), options, result, host)
                             : generate<Result>(std::move(job), options, result, host);
}

const auto& content(const pcvt_result* result) {
    if (result == nullptr) throw InvalidInput("result is a null pointer");
    return result->content;
}

const Result& plane_content(const pcvt_result* result) {
    if (const auto* plane = std::get_if<Result>(&content(result))) return *plane;
    throw InvalidInput("the result has three dimensions; pcvt_get_cells gives its cells and sites");
}

const SpaceResult& space_content(const pcvt_result* result) {
    if (const auto* space = std::get_if<SpaceResult>(&content(result))) return *space;
    throw InvalidInput("the result has two dimensions; take pcvt_get_tile or pcvt_get_mesh");
}

pcvt_status write(const pcvt_result* result, const char* path, const pcvt_write_options* given,
                  const std::fenv_t& host) {
    const auto& made = content(result);
    pcvt_write_options options{};
    if (given != nullptr) options = read_struct("pcvt_write_options", given);
    if (path != nullptr && *path == '\0') {
        throw InvalidInput("path is empty; give the name of a file");
    }
    if (path == nullptr && (options.report == nullptr || *options.report == '\0')) {
        throw InvalidInput("neither path nor report; give one");
    }
    const bool in_space = std::holds_alternative<SpaceResult>(made);
    const WriteRequest request = write_request(path, options, in_space);
    const HostProgress progress{options.progress, options.progress_data};
    const bool is_written = std::visit(
        [&](const auto& computed) {
            return computed.write(request, job_callback(progress, computed.energy_bound(), host));
        },
        made);
    return is_written ? PCVT_OK : cancelled_status();
}

}  // namespace
}  // namespace pcvt::abi

using namespace pcvt::abi;

uint32_t pcvt_abi_version(void) { return PCVT_ABI_VERSION; }

const char* pcvt_version(void) { return pcvt::version(); }

const char* pcvt_status_text(pcvt_status status) {
    switch (status) {
        case PCVT_OK:
            return "done";
        case PCVT_CANCELLED:
            return "cancelled";
        case PCVT_NOT_CONVERGED:
            return "not converged";
        case PCVT_REFUTED:
            return "refuted";
        case PCVT_ERROR_ARGUMENT:
            return "an argument is wrong";
        case PCVT_ERROR_ABI:
            return "host and library do not fit together";
        case PCVT_ERROR_DOMAIN:
            return "the density or a callback is at fault";
        case PCVT_ERROR_MEMORY:
            return "out of memory, or a limit of pcvt";
        case PCVT_ERROR_GEOMETRY:
            return "sites coincide, or their cells are too small";
        case PCVT_ERROR_IO:
            return "a file could not be written";
        case PCVT_ERROR_INTERNAL:
            return "a fault of pcvt";
        default:
            return "unknown status";
    }
}

const char* pcvt_last_error(void) { return last_error(); }

pcvt_status pcvt_options_init(pcvt_options* options, size_t struct_size, uint32_t abi_version) {
    return give_defaults("pcvt_options", options, struct_size, abi_version, default_options);
}

pcvt_status pcvt_generate(const pcvt_options* options, pcvt_result** result) {
    return guarded([&](const std::fenv_t& host) { return generate(options, result, host); });
}

void pcvt_free(pcvt_result* result) { delete result; }

pcvt_status pcvt_get_progress_sites(pcvt_sites* view, size_t view_size) {
    return give("pcvt_sites", view, view_size, [] { return ProgressSites::current_view(); });
}

pcvt_status pcvt_get_sites(const pcvt_result* result, pcvt_sites* view, size_t view_size) {
    return give("pcvt_sites", view, view_size, [&] { return plane_content(result).sites(); });
}

pcvt_status pcvt_get_inclusions(const pcvt_result* result, pcvt_inclusions* view,
                                size_t view_size) {
    return give("pcvt_inclusions", view, view_size,
                [&] { return plane_content(result).inclusions(); });
}

pcvt_status pcvt_get_statistics(const pcvt_result* result, pcvt_statistics* view,
                                size_t view_size) {
    return give("pcvt_statistics", view, view_size, [&] {
        return std::visit([](const auto& made) { return made.statistics(); }, content(result));
    });
}

pcvt_status pcvt_get_minimum(const pcvt_result* result, int32_t* minimum) {
    return guarded([&](const std::fenv_t&) {
        if (minimum == nullptr) throw pcvt::InvalidInput("minimum is a null pointer");
        *minimum = std::visit([](const auto& made) { return made.minimum(); }, content(result));
        return pcvt_status{PCVT_OK};
    });
}

pcvt_status pcvt_get_mesh(const pcvt_result* result, int32_t kind, pcvt_mesh* view,
                          size_t view_size) {
    return give("pcvt_mesh", view, view_size,
                [&] { return plane_content(result).mesh(tile_kind(kind)); });
}

pcvt_status pcvt_get_tile(const pcvt_result* result, int32_t kind, int32_t outline, pcvt_tile* view,
                          size_t view_size) {
    return give("pcvt_tile", view, view_size, [&] {
        const Layout layout{tile_kind(kind), tile_outline(outline)};
        return plane_content(result).tile(layout);
    });
}

pcvt_status pcvt_get_cells(const pcvt_result* result, pcvt_cells* view, size_t view_size) {
    return give("pcvt_cells", view, view_size, [&] { return space_content(result).cells(); });
}

pcvt_status pcvt_write(const pcvt_result* result, const char* path,
                       const pcvt_write_options* options) {
    return guarded([&](const std::fenv_t& host) { return write(result, path, options, host); });
}
