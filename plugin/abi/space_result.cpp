#include "plugin/abi/space_result.hpp"

#include <algorithm>
#include <limits>

#include "mesher/space/mesh/cell_faces.hpp"
#include "plugin/abi/guard.hpp"
#include "plugin/abi/run_status.hpp"
#include "plugin/job/job_memory.hpp"
#include "plugin/job/space_files.hpp"
#include "plugin/job/space_memory.hpp"

namespace pcvt::abi {
namespace {

static_assert(sizeof(int) == sizeof(std::int32_t));
static_assert(sizeof(space::Vec3) == 3 * sizeof(double));
static_assert(sizeof(space::Offset) == 3 * sizeof(std::int32_t));

void copy_lattice(const space::Lattice& lattice, double* vectors) {
    for (const space::Vec3& period : lattice.periods()) {
        vectors = std::copy(period.data(), period.data() + 3, vectors);
    }
}

CellArrays cell_arrays(const space::PolyhedralMesh& mesh, space::Points sites) {
    CellArrays arrays;
    arrays.neighbour = mesh.neighbour;
    arrays.neighbour.resize(static_cast<std::size_t>(mesh.n_faces()), -1);
    const int n_inner = mesh.n_inner_faces();
    const auto n_boundary = static_cast<std::size_t>(mesh.n_faces() - n_inner);
    arrays.partner.resize(n_boundary);
    arrays.partner_offset.resize(n_boundary);
    for (const FiniteVolumePatch& patch : mesh.patches) {
        for (int k = 0; k < patch.n_faces; ++k) {
            const int face = patch.first_face - n_inner + k;
            arrays.partner[face] = mesh.patches[patch.partner].first_face + k;
            arrays.partner_offset[face] = patch.offset_as<space::Offset>();
        }
    }
    for (const space::CellBody& body : cell_bodies(mesh)) arrays.volumes.push_back(body.volume);
    arrays.sites = std::move(sites);
    return arrays;
}

std::vector<int> counts_by_faces(const std::map<int, int>& face_counts) {
    std::vector<int> counts;
    for (const auto& [faces, count] : face_counts) {
        counts.resize(static_cast<std::size_t>(faces) + 1, 0);
        counts[faces] = count;
    }
    return counts;
}

}  // namespace

SpaceResult::SpaceResult(Job job, SpaceComputation computed)
    : job_(std::move(job)), computed_(std::move(computed)) {
    // The result has the optimised sites; those that the run began with are not read again.
    job_.n_sites = computed_.cvt.delaunay.sites.n_sites();
    job_.in_space().points = space::Points(3, 0);
}

double SpaceResult::energy_bound() const { return pcvt::energy_bound(job_); }

const ProvedSpaceTile& SpaceResult::tile(JobMonitor& monitor) const {
    return tile_.get([&] {
        require_available("the cells take", memory_of_cells(job_, job_.n_sites),
                          "take fewer sites");
        return prove_space_tile(job_, computed_, monitor);
    });
}

const ProvedSpaceTile& SpaceResult::tile() const {
    const JobCallback no_callback;
    JobMonitor monitor(no_callback, {});
    return tile(monitor);
}

const CellArrays& SpaceResult::arrays() const {
    const space::PolyhedralMesh& mesh = tile().tile.mesh;
    return arrays_.get([&] { return cell_arrays(mesh, wrapped_sites(computed_)); });
}

pcvt_cells SpaceResult::cells() const {
    const SpaceTile& made = tile().tile;
    const space::PolyhedralMesh& mesh = made.mesh;
    const CellArrays& more = arrays();
    pcvt_cells view{};
    copy_lattice(mesh.lattice, view.lattice);
    view.points = mesh.points.front().data();
    view.point_orbit = mesh.point_orbit.data();
    view.point_offset = &mesh.point_offset.front().i;
    view.face_begin = mesh.faces.begin.data();
    view.face_points = mesh.faces.corners.data();
    view.owner = mesh.owner.data();
    view.neighbour = more.neighbour.data();
    view.partner = more.partner.data();
    view.partner_offset = &more.partner_offset.front().i;
    view.volumes = more.volumes.data();
    view.site_points = made.sites.data();
    view.sites = more.sites.data();
    view.n_cells = mesh.n_cells;
    view.n_faces = mesh.n_faces();
    view.n_inner_faces = mesh.n_inner_faces();
    view.n_points = mesh.n_points();
    view.n_face_points = static_cast<std::int32_t>(mesh.faces.corners.size());
    return view;
}

pcvt_statistics SpaceResult::statistics() const {
    const std::vector<int>& valences =
        valences_.get([&] { return counts_by_faces(tile().face_counts); });
    const RunStatistics& run = computed_.cvt.run;
    pcvt_statistics view{};
    view.energy = run.energy;
    view.energy_bound = energy_bound();
    view.residual = run.residual;
    view.rms_residual = run.rms_residual;
    view.seconds_optimize = computed_.seconds;
    view.valences = valences.data();
    view.n_valences = static_cast<std::int32_t>(valences.size());
    view.stop = stop_number(run.stop);
    view.n_sites = job_.n_sites;
    view.iterations = run.iterations;
    view.evaluations = run.evaluations;
    view.n_threads = job_.run.n_threads;
    view.n_mirrors = -1;
    view.area_error = std::numeric_limits<double>::quiet_NaN();
    view.n_dropped = static_cast<std::int32_t>(job_.dropped.sites.size());
    view.dropped = dropped_pairs(job_.dropped);
    return view;
}

std::int32_t SpaceResult::minimum() const {
    return minimum_.get([&] { return minimum_number(minimum_of(computed_)); });
}

bool SpaceResult::write(const SpaceWriteRequest& request, const JobCallback& callback) const {
    Job job = job_;
    if (!request.path.empty()) job.outputs.push_back(request.path);
    job.report = request.report;
    job.space_files = request.files;
    job.force = request.replace;
    plan_files(job);
    const SpaceTileSource make_tile = [this](JobMonitor& monitor) -> const ProvedSpaceTile& {
        return tile(monitor);
    };
    const SpaceSummary summary =
        from_geometry([&] { return write_space_job(job, computed_, make_tile, callback); });
    if (!summary.refused.empty()) throw CoarsePrecision(summary.refused.front().reason);
    return summary.run.stop != Stop::kCancelled;
}

}  // namespace pcvt::abi
