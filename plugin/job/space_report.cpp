#include "plugin/job/space_report.hpp"

#include "io/bytes/json_writer.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/report_parts.hpp"
#include "plugin/job/version.hpp"

namespace pcvt {
namespace {

void append_pattern(JsonWriter& json,
                    const std::optional<PatternOutcome<space::LatticePattern>>& pattern) {
    if (!pattern) return;
    const space::LatticePattern& lattice = pattern->lattice;
    json.object("pattern", [&] {
        json.list("basis", std::array{0, 1, 2}, [&](int k) { json.value(lattice.basis.col(k)); });
        const auto& [a, d, f, b, c, e] = lattice.form;
        json.member("hermite", std::array{a, d, f, b, c, e});
        append_verdict(json, lattice.energy, pattern->stability);
    });
}

}  // namespace

std::string encode_space_report(const Job& job, const SpaceSummary& summary,
                                double seconds_optimising, double seconds_writing) {
    std::string text;
    JsonWriter json(text);
    json.begin_object(kJsonLines);
    json.member("version", version());
    json.member("sites", summary.n_sites);
    json.member("lattice", job.in_space().lattice.periods());
    json.member("seed", job.seed);
    json.member("solver", solver_row(job.run.solver).word);
    json.member("start", start_name(job));
    json.member("stop", stop_name(summary.run.stop));
    json.member("iterations", summary.run.iterations);
    json.member("evaluations", summary.run.evaluations);
    json.member("energy", summary.run.energy);
    json.member("energy_bound", summary.energy_bound);
    json.member("residual", summary.run.residual);
    json.member("rms_residual", summary.run.rms_residual);
    append_minimum(json, summary.minimum);
    append_counts(json, "faces", summary.face_counts);
    json.member("removed_edges", summary.n_removed_edges);
    json.member("volume", summary.proof.volume);
    json.member("boundary_pairs", summary.proof.n_boundary_pairs);
    json.member("translations", summary.proof.n_translations);
    json.member("boundary_is_manifold", summary.proof.boundary_is_manifold);
    json.member("threads", job.run.n_threads);
    json.object("seconds", [&] {
        json.member("optimize", seconds_optimising);
        json.member("write", seconds_writing);
        json.member("total", seconds_optimising + seconds_writing);
    });
    json.member("files", summary.files);
    append_pattern(json, summary.pattern);
    append_duplicates(json, job.duplicates, job.dropped);
    json.end();
    return text + '\n';
}

}  // namespace pcvt
