#include "plugin/abi/space_result.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "mesher/space/mesh/cell_faces.hpp"
#include "plugin/abi/guard.hpp"
#include "plugin/job/job_memory.hpp"
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

/// The result has the optimised sites; those that the run began with are not read again.
Job of_result(Job job, const space::Tessellation& cells) {
    job.n_sites = cells.delaunay.sites.n_sites();
    job.in_space().points = space::Points(3, 0);
    return job;
}

}  // namespace

SpaceResult::SpaceResult(Job job, Computation<SpaceWorld> computed)
    : ComputedJob(of_result(std::move(job), computed.cells), std::move(computed)) {}

double SpaceResult::energy_bound() const { return pcvt::energy_bound(job()); }

const ProvedSpaceTile& SpaceResult::tile(JobMonitor& monitor) const {
    return tile_.get([&] {
        require_available("the cells take", space_memory_to_write(job(), {}), "take fewer sites");
        Job one = job();
        one.tile.repeat = {};
        return SpaceWorld::build_tiles(one, {}, computed(), monitor);
    });
}

const ProvedSpaceTile& SpaceResult::tile() const {
    const JobCallback no_callback;
    JobMonitor monitor(no_callback, job());
    return tile(monitor);
}

const CellArrays& SpaceResult::arrays() const {
    const space::PolyhedralMesh& mesh = tile().tile.mesh;
    return arrays_.get([&] {
        return cell_arrays(mesh,
                           wrapped_positions(computed().cells.sites(), job().in_space().origin));
    });
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
    show_materials(view);
    if (made.weights.size() > 0) view.weights = made.weights.data();
    view.sites = more.sites.data();
    view.n_cells = mesh.n_cells;
    view.n_faces = mesh.n_faces();
    view.n_inner_faces = mesh.n_inner_faces();
    view.n_points = mesh.n_points();
    view.n_face_points = static_cast<std::int32_t>(mesh.faces.corners.size());
    return view;
}

pcvt_statistics SpaceResult::statistics() const {
    pcvt_statistics view =
        ComputedJob::statistics(energy_bound(), [&] { return tile().face_counts; });
    view.n_sites = job().n_sites;
    view.n_mirrors = -1;
    view.area_error = std::numeric_limits<double>::quiet_NaN();
    return view;
}

bool SpaceResult::write(const WriteRequest& request, const JobCallback& callback) const {
    // A wrong output is not a fault of the cells.
    const Job asked = job_of(request);
    SpaceWorld::check_files(asked, plan_files(asked), computed().materials.phase_names);
    std::optional<ProvedSpaceTile> other;
    const auto make_tile = [&](JobMonitor& monitor) -> const ProvedSpaceTile& {
        const bool is_box = asked.tile.outline == plane::Outline::kBox;
        if (asked.tile.repeat.n_copies() == 1 && !is_box) return tile(monitor);
        return other.emplace(SpaceWorld::build_tiles(asked, {}, computed(), monitor));
    };
    return from_geometry([&] { return ComputedJob::write(request, make_tile, callback); });
}

}  // namespace pcvt::abi
