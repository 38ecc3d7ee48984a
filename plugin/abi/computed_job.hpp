#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "plugin/abi/guard.hpp"
#include "plugin/abi/lazy.hpp"
#include "plugin/abi/run_status.hpp"
#include "plugin/abi/write_options.hpp"
#include "plugin/job/run_job.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// The part of a result that does not depend on its dimension.
template <class JobWorld>
class ComputedJob {
   public:
    using World = JobWorld;

    ComputedJob(Job job, Computation<World>&& computed)
        : job_(std::move(job)), computed_(std::move(computed)) {
        for (const std::string& name : computed_.materials.phase_names) {
            phase_names_.push_back(name.c_str());
        }
    }

    /// PCVT_MINIMUM_...
    std::int32_t minimum() const {
        return minimum_.get([&] { return minimum_number(minimum_of(computed_.cells)); });
    }

   protected:
    const Job& job() const { return job_; }
    const Computation<World>& computed() const { return computed_; }

    /// The figures of both dimensions.
    /// @param count_sides  returns the cells by their number of sides or faces.
    template <class CountSides>
    pcvt_statistics statistics(double energy_bound, const CountSides& count_sides) const {
        const std::vector<int>& valences = valences_.get([&] { return listed(count_sides()); });
        const RunStatistics& run = computed_.cells.run;
        pcvt_statistics view{};
        view.energy = run.energy;
        view.energy_bound = energy_bound;
        view.residual = run.residual;
        view.rms_residual = run.rms_residual;
        view.seconds_build = computed_.seconds.build;
        view.seconds_optimize = computed_.seconds.optimize;
        view.valences = valences.empty() ? nullptr : valences.data();
        view.n_valences = static_cast<std::int32_t>(valences.size());
        view.stop = stop_number(run.stop);
        view.iterations = run.iterations;
        view.evaluations = run.evaluations;
        view.n_threads = job_.run.n_threads;
        view.n_dropped = static_cast<std::int32_t>(job_.dropped.sites.size());
        view.dropped = dropped_pairs(job_.dropped);
        return view;
    }

    /// Fills in the phases and the orientations of a view.
    /// @tparam View  pcvt_sites or pcvt_cells.
    template <class View>
    void show_materials(View& view) const {
        const CellMaterials& materials = computed_.materials;
        if (!materials.site_phase.empty()) view.phases = materials.site_phase.data();
        if (!phase_names_.empty()) view.phase_names = phase_names_.data();
        view.n_phases = static_cast<std::int32_t>(phase_names_.size());
        // Three doubles each, without padding.
        static_assert(sizeof(BungeAngles) == 3 * sizeof(double));
        if (materials.site_orientation.empty()) return;
        view.orientations = &materials.site_orientation.front().phi1;
    }

    /// Writes the files of a request.
    /// @returns false if the callback cancelled.
    /// @throws as write_job(); CoarsePrecision where 32-bit floats do not hold the tile.
    bool write(const WriteRequest& request, const TileSource<World>& tiles,
               const JobCallback& callback) const {
        const RunSummary summary = write_job<World>(job_of(request), computed_, tiles, callback);
        if (!summary.refused.empty()) throw CoarsePrecision(summary.refused.front().reason);
        return summary.run.stop != Stop::kCancelled;
    }

    /// The job with the files of a request.
    Job job_of(const WriteRequest& request) const {
        Job job = job_;
        job.meshes = {request.layout.kind};
        job.tile.outline = request.layout.outline;
        if (!request.path.empty()) job.outputs = {request.path};
        job.file_options = request.files;
        job.report = request.report;
        job.force = request.replace;
        job.materials = shown_materials(job.materials, request.files.colouring);
        return job;
    }

   private:
    /// The materials that a file must hold, which are those that its colours show. The cells have
    /// their materials, also where a file does not state them.
    static MaterialChoices shown_materials(const MaterialChoices& materials,
                                           const std::optional<Colouring>& colouring) {
        const ColouringNeed need =
            colouring ? colouring_row(*colouring).needs : ColouringNeed::kNothing;
        MaterialChoices shown;
        if (need == ColouringNeed::kPhases) shown.phases = materials.phases;
        if (need != ColouringNeed::kOrientations) return shown;
        shown.draws_orientations = materials.draws_orientations;
        shown.orientations = materials.orientations;
        return shown;
    }

    static std::vector<int> listed(const std::map<int, int>& counts) {
        std::vector<int> list;
        for (const auto& [sides, count] : counts) {
            list.resize(static_cast<std::size_t>(sides) + 1, 0);
            list[sides] = count;
        }
        return list;
    }

    Job job_;
    Computation<World> computed_;
    std::vector<const char*> phase_names_;
    Lazy<std::vector<int>> valences_;
    Lazy<std::int32_t> minimum_;
};

}  // namespace pcvt::abi
