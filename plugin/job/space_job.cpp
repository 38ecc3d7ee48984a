#include "plugin/job/space_job.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/cvt/coarse_start.hpp"
#include "mesher/space/delaunay/orbit_insertion.hpp"
#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"
#include "plugin/job/job_memory.hpp"
#include "plugin/job/job_staging.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/space_files.hpp"
#include "plugin/job/space_memory.hpp"
#include "plugin/job/space_report.hpp"

namespace pcvt {
namespace {

/// A message about memory names the tetrahedra where there are this many times as usual.
constexpr double kManyTetrahedra = 3;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

JobMonitor::Target target_of(const Job& job) {
    JobMonitor::Target target;
    target.tolerance = job.run.tolerance;
    target.max_iterations = job.run.max_iterations;
    return target;
}

Eigen::Matrix3d period_matrix(const space::Lattice& lattice) {
    Eigen::Matrix3d period;
    for (int k = 0; k < 3; ++k) period.col(k) = lattice.periods()[k];
    return period;
}

space::Points coarse_points(const Job& job, JobMonitor& monitor) {
    space::Points points = space::coarse_start(job.in_space().lattice, job.n_sites,
                                               {{.seed = job.seed,
                                                 .n_threads = job.run.n_threads,
                                                 .progress = [&](const Progress& progress) {
                                                     return monitor.start_iteration(progress);
                                                 }}});
    if (points.cols() == 0) throw Cancelled{};
    return points;
}

void check_short_edges(double length) {
    if (length >= 0 && length <= space::kLongestShortEdge) return;
    throw InvalidInput("the length under which edges are removed is not between 0 and 0.1 h");
}

void check_stability(const Job& job) {
    if (!job.stability || job.n_wanted() <= space::kMostSitesForMinimum) return;
    throw InvalidInput("the stability is known of at most " +
                       std::to_string(space::kMostSitesForMinimum) +
                       " sites in space; leave it out, or take fewer sites");
}

/// The subject and the verb of a message about memory.
std::string run_takes(const Job& job) {
    const auto n = static_cast<double>(job.in_space().points.cols());
    if (!(job.n_tetrahedra > kManyTetrahedra * space::kTetrahedraPerSite * n))
        return "the run takes";
    return "the sites have about " + std::to_string(std::llround(job.n_tetrahedra / n)) +
           " Delaunay tetrahedra each, as sites on two lines have, and the run takes";
}

/// The best lattice and its stability, if the run begins there.
std::optional<PatternOutcome<space::LatticePattern>> find_pattern(const Job& job) {
    if (job.n_given() > 0 || chosen_start(job) != Start::kLattice) return std::nullopt;
    const space::LatticePattern pattern =
        space::best_lattice(period_matrix(job.in_space().lattice), job.n_sites);
    return PatternOutcome<space::LatticePattern>{pattern, space::lattice_stability(pattern)};
}

space::Points start_points(const Job& job,
                           const std::optional<PatternOutcome<space::LatticePattern>>& pattern,
                           JobMonitor& monitor) {
    if (job.n_given() > 0) return job.in_space().points;
    if (pattern) return pattern_points(pattern->lattice);
    if (chosen_start(job) == Start::kCoarse) return coarse_points(job, monitor);
    return uniform_points(job.in_space().lattice, job.n_sites, job.seed);
}

space::CvtResult optimise(const Job& job, const space::Points& points, JobMonitor& monitor) {
    space::CvtOptions options{job.run};
    options.run.progress = [&](const Progress& progress) { return monitor.iteration(progress); };
    space::CvtResult result = space::compute_cvt(job.in_space().lattice, points, options);
    if (result.run.stop == Stop::kCancelled) throw Cancelled{};
    return result;
}

SpaceComputation compute(const Job& job, JobMonitor& monitor) {
    const Clock::time_point begin = Clock::now();
    std::optional<PatternOutcome<space::LatticePattern>> pattern = find_pattern(job);
    SpaceComputation computation{.cvt =
                                     optimise(job, start_points(job, pattern, monitor), monitor)};
    computation.pattern = std::move(pattern);
    computation.seconds = seconds_since(begin);
    return computation;
}

/// The tile, not yet proved.
ProvedSpaceTile build_tile(const space::PeriodicDelaunay& delaunay, double short_edges,
                           JobMonitor& monitor) {
    monitor.begin(Phase::kBuilding, "building the cells");
    space::CellComplex complex = cell_complex(delaunay.sites, delaunay.tetrahedra);
    const std::size_t n_vertices = complex.vertices.size();
    complex = without_short_edges(std::move(complex), short_edges);
    ProvedSpaceTile tile{.tile = {.mesh = polyhedral_mesh(delaunay.sites, complex)},
                         .n_removed_edges = static_cast<int>(n_vertices - complex.vertices.size())};
    tile.tile.sites = sites_in_cells(delaunay.sites, tile.tile.mesh);
    return tile;
}

/// Names the first of these tetrahedra by its sites.
std::string flat_in_words(const space::TetrahedralMesh& mesh, const std::vector<int>& flat) {
    std::string sites;
    for (const int v : mesh.tetrahedra[flat.front()]) {
        sites += (sites.empty() ? "" : ", ") + std::to_string(mesh.point_site[v]);
    }
    const std::string number = flat.size() == 1
                                   ? "one tetrahedron of these sites is flat, that of sites "
                                   : std::to_string(flat.size()) +
                                         " tetrahedra of these sites are flat, the first that of "
                                         "sites ";
    return number + sites +
           ", which lie in one plane up to rounding, as where more than four sites lie on a sphere";
}

/// The tetrahedra, if a file holds them.
std::optional<space::TetrahedralMesh> build_tetrahedra(const space::PeriodicDelaunay& delaunay,
                                                       const std::vector<JobFile>& files,
                                                       const SpaceFileOptions& options,
                                                       JobMonitor& monitor) {
    const auto file = std::find_if(files.begin(), files.end(), [&](const JobFile& f) {
        return f.format->space->shows_tetrahedra(options);
    });
    if (file == files.end()) return {};
    monitor.begin(Phase::kBuilding, "building the tetrahedra");
    space::TetrahedralMesh mesh = tetrahedral_mesh(delaunay);
    const std::vector<int> flat = flat_tetrahedra(mesh, delaunay.sites.n_sites());
    if (flat.empty()) return mesh;
    throw InvalidInput("-o " + file->path() + ": " + flat_in_words(mesh, flat) +
                       "; move the sites a little, or leave " + file->path() + " out");
}

/// Requires that the boundary is a closed surface, if a file shows it.
void require_closed_boundary(const Job& job, const std::vector<JobFile>& files,
                             const space::PolyhedralProof& proof) {
    if (proof.boundary_is_manifold) return;
    for (const JobFile& file : files) {
        if (!file.format->space->shows_boundary(job.space_files)) continue;
        throw InvalidInput("-o " + file.path() +
                           ": the boundary of this tile touches itself, so that it is no surface; "
                           "take the surfaces of the cells as .obj, .ply or .glb, or other sites");
    }
}

/// Makes the tile and the files of a computed job. The commit of the files cannot be cancelled.
SpaceSummary finish(const Job& job, const std::vector<JobFile>& files,
                    const SpaceComputation& computation, const SpaceTileSource& make_tile,
                    JobMonitor& monitor) {
    const Clock::time_point begin = Clock::now();
    const space::PeriodicDelaunay& delaunay = computation.cvt.delaunay;
    OutputSet outputs;
    SpaceSummary summary;
    summary.n_sites = delaunay.sites.n_sites();
    summary.energy_bound =
        space::body_centred_energy(job.in_space().lattice.volume(), summary.n_sites);
    for (const JobFile& file : files) summary.files.push_back(file.path());
    monitor.watch([&] {
        std::optional<space::TetrahedralMesh> tetrahedra =
            build_tetrahedra(delaunay, files, job.space_files, monitor);
        const ProvedSpaceTile& proved = make_tile(monitor);
        space::Points points = wrapped_sites(computation);
        const SpaceContent content{proved.tile, std::move(points), std::move(tetrahedra)};
        summary.proof = proved.proof;
        summary.face_counts = proved.face_counts;
        summary.n_removed_edges = proved.n_removed_edges;
        require_closed_boundary(job, files, summary.proof);
        summary.refused = stage_space_files(files, content, job.space_files, monitor, outputs);
        for (const RefusedFile& file : summary.refused) std::erase(summary.files, file.path);
        summary.run = computation.cvt.run;
        summary.pattern = computation.pattern;
        if (job.stability) summary.minimum = minimum_of(computation);
        if (!job.report.empty()) {
            outputs.stage(job.report, encode_space_report(job, summary, computation.seconds,
                                                          seconds_since(begin)));
        }
        summary.recovered = wait_for_turn(outputs, monitor);
    });
    // Nothing may fail after the files appear.
    const ClientScope no_client(nullptr);
    outputs.commit(job.force);
    return summary;
}

SpaceSummary run(const Job& job, const std::vector<JobFile>& files, const JobCallback& callback) {
    JobMonitor monitor(callback, target_of(job));
    const SpaceComputation computation = compute(job, monitor);
    std::optional<ProvedSpaceTile> tile;
    const SpaceTileSource make_tile = [&](JobMonitor&) -> const ProvedSpaceTile& {
        return tile.emplace(prove_space_tile(job, computation, monitor));
    };
    return finish(job, files, computation, make_tile, monitor);
}

}  // namespace

double energy_bound(const Job& job) {
    return space::body_centred_energy(job.in_space().lattice.volume(), job.n_wanted());
}

std::optional<Minimum> minimum_of(const SpaceComputation& computation) {
    const space::PeriodicDelaunay& delaunay = computation.cvt.delaunay;
    const bool few = delaunay.sites.n_sites() <= space::kMostSitesForMinimum;
    if (computation.cvt.run.stop != Stop::kConverged || !few) return {};
    return space::decided_minimum(delaunay);
}

space::Points wrapped_sites(const SpaceComputation& computation) {
    const space::Sites& sites = computation.cvt.delaunay.sites;
    space::Points points(3, sites.n_sites());
    for (SiteId s = 0; s < sites.n_sites(); ++s) points.col(s) = sites.position(s);
    return points;
}

ProvedSpaceTile prove_space_tile(const Job& job, const SpaceComputation& computation,
                                 JobMonitor& monitor) {
    ProvedSpaceTile proved = build_tile(computation.cvt.delaunay, job.tile.short_edges, monitor);
    const SpaceTile& tile = proved.tile;
    monitor.begin(Phase::kProving, "proving the cells");
    try {
        proved.proof = prove_polyhedra(tile.mesh);
        prove_cell_sites(tile.mesh, tile.sites);
    } catch (const NotATile& error) {
        throw InternalError(std::string("a tile breaks its laws: ") + error.what());
    }
    const space::CellFaces cells(tile.mesh);
    for (int s = 0; s < cells.n_cells(); ++s) {
        ++proved.face_counts[static_cast<int>(cells[s].size())];
    }
    return proved;
}

std::optional<SpaceComputation> compute_space_job(const Job& job, const JobCallback& callback) {
    check_short_edges(job.tile.short_edges);
    require_available(run_takes(job), estimated_memory(job, {}), "take fewer sites");
    JobMonitor monitor(callback, target_of(job));
    try {
        return compute(job, monitor);
    } catch (const Cancelled&) {
        return std::nullopt;
    }
}

SpaceSummary write_space_job(const Job& job, const SpaceComputation& computation,
                             const SpaceTileSource& tile, const JobCallback& callback) {
    const std::vector<JobFile> files = plan_files(job);
    require_all_writable(job, files);
    require_available("the files take",
                      memory_to_write(job, computation.cvt.delaunay.sites.n_sites(), files),
                      kFewerOutputs);
    JobMonitor monitor(callback, target_of(job));
    try {
        return finish(job, files, computation, tile, monitor);
    } catch (const Cancelled&) {
        return {};
    }
}

SpaceSummary run_space_job(const Job& job, const JobCallback& callback) {
    const Clock::time_point begin = Clock::now();
    check_stability(job);
    check_short_edges(job.tile.short_edges);
    const std::vector<JobFile> files = plan_files(job);
    const std::vector<std::string> recovered = require_all_writable(job, files);
    require_available(run_takes(job), estimated_memory(job, files), kFewerOutputs);
    try {
        SpaceSummary summary = run(job, files, callback);
        summary.recovered.insert(summary.recovered.begin(), recovered.begin(), recovered.end());
        summary.seconds = seconds_since(begin);
        return summary;
    } catch (const Cancelled&) {
        return {};
    }
}

}  // namespace pcvt
