#include "plugin/abi/result.hpp"

#include <algorithm>
#include <limits>

#include "mesher/plane/mesh/valence.hpp"
#include "plugin/abi/guard.hpp"
#include "plugin/abi/run_status.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_memory.hpp"
#include "plugin/job/job_tiles.hpp"

namespace pcvt::abi {
namespace {

static_assert(sizeof(int) == sizeof(std::int32_t));
static_assert(sizeof(plane::Vec2) == 2 * sizeof(double));
static_assert(sizeof(plane::Offset) == 2 * sizeof(std::int32_t));

const double* numbers(const std::vector<plane::Vec2>& points) {
    return points.empty() ? nullptr : points.front().data();
}

const std::int32_t* numbers(const std::vector<int>& values) {
    return values.empty() ? nullptr : values.data();
}

const std::int32_t* numbers(const std::vector<plane::Offset>& offsets) {
    return offsets.empty() ? nullptr : &offsets.front().i;
}

void copy_lattice(const plane::Lattice& lattice, double* vectors) {
    const std::array<double, 4> numbers{lattice.a().x(), lattice.a().y(), lattice.b().x(),
                                        lattice.b().y()};
    std::copy(numbers.begin(), numbers.end(), vectors);
}

void note_orbits(TileArrays& arrays) {
    const plane::Tile& tile = arrays.built.tile;
    arrays.offset.resize(tile.points.size());
    for (int v = 0; v < tile.n_vertices(); ++v) arrays.orbit.push_back(v);
    for (const plane::VertexPair& pair : tile.vertex_pairs) {
        arrays.orbit[pair.w] = pair.v;
        arrays.offset[pair.w] = pair.offset;
    }
    for (const plane::EdgePair& pair : tile.edge_pairs) {
        arrays.edge_pairs.push_back({.v0 = pair.v0,
                                     .v1 = pair.v1,
                                     .w0 = pair.w0,
                                     .w1 = pair.w1,
                                     .i = pair.offset.i,
                                     .j = pair.offset.j});
    }
    for (const plane::WallEdge& edge : tile.wall_edges) {
        arrays.wall_edges.push_back({.wall = edge.wall.number, .v0 = edge.v0, .v1 = edge.v1});
    }
}

/// The number of a shape's form, and its numbers appended.
std::int32_t append(const plane::Circle& circle, std::vector<double>& numbers) {
    numbers.insert(numbers.end(), {circle.centre.x(), circle.centre.y(), circle.radius});
    return PCVT_CIRCLE;
}
std::int32_t append(const plane::Ellipse& ellipse, std::vector<double>& numbers) {
    numbers.insert(numbers.end(),
                   {ellipse.centre.x(), ellipse.centre.y(), ellipse.a, ellipse.b, ellipse.degrees});
    return PCVT_ELLIPSE;
}
std::int32_t append(const plane::Polygon& polygon, std::vector<double>& numbers) {
    for (const plane::Vec2& corner : polygon)
        numbers.insert(numbers.end(), {corner.x(), corner.y()});
    return PCVT_POLYGON;
}

InclusionArrays inclusion_arrays(const plane::Tessellation& cells) {
    InclusionArrays arrays;
    if (!cells.interfaces) return arrays;
    for (const plane::Inclusion& inclusion : cells.interfaces->shapes) {
        arrays.form.push_back(std::visit(
            [&](const auto& shape) { return append(shape, arrays.numbers); }, inclusion.shape));
        arrays.tags.push_back(cells.tag_names[inclusion.tag].c_str());
        arrays.begin.push_back(static_cast<int>(arrays.numbers.size()));
    }
    return arrays;
}

std::vector<int> counts_by_sides(const plane::Tessellation& cells) {
    std::vector<int> counts;
    for (const auto& [sides, count] : plane::histogram(cell_sides(cells))) {
        counts.resize(static_cast<std::size_t>(sides) + 1, 0);
        counts[sides] = count;
    }
    return counts;
}

std::int32_t kind_number(plane::MeshKind kind) { return mesh_kind_row(kind).abi_value; }

std::int32_t outline_number(plane::Outline outline) {
    return outline == plane::Outline::kBox ? PCVT_BOX : PCVT_WHOLE;
}

}  // namespace

Result::Result(Job job, Computation computed)
    : job_(std::move(job)),
      computed_(std::move(computed)),
      sites_(wrapped_sites(computed_.cells, job_.tile.origin)),
      inclusions_(inclusion_arrays(computed_.cells)) {
    for (const std::string& name : computed_.materials.phase_names) {
        phase_names_.push_back(name.c_str());
    }
    for (const std::string& name : job_.holes) hole_names_.push_back(name.c_str());
}

const plane::PeriodicMesh& Result::periodic(plane::MeshKind kind) const {
    if (kind == plane::MeshKind::kGrains) {
        throw InvalidInput("grains exist only as a tile; use pcvt_get_tile");
    }
    Job job = job_;
    job.meshes = {kind};
    job.tile.outline = plane::Outline::kWhole;
    job.tile.columns = job.tile.rows = 1;
    check_job(job);
    return meshes_[kind_number(kind)].get([&] {
        require_memory_for_mesh(job, kind);
        return from_geometry([&] { return mesh_outside_holes(computed_.cells, kind); });
    });
}

const TileArrays& Result::arrays(const Layout& layout, JobMonitor& monitor) const {
    Job job = job_;
    job.meshes = {layout.kind};
    job.tile.outline = layout.outline;
    check_job(job);
    return tiles_[kind_number(layout.kind)][outline_number(layout.outline)].get([&] {
        require_memory_for_mesh(job, layout.kind);
        std::vector<plane::BuiltTile> built =
            from_geometry([&] { return proved_tiles(job, computed_.cells, monitor); });
        TileArrays made{std::move(built.front()), {}, {}, {}, {}};
        note_orbits(made);
        return made;
    });
}

double energy_bound(const Job& job, int n_sites) {
    return job.density ? std::numeric_limits<double>::quiet_NaN()
                       : plane::hexagonal_bound(job.in_plane().lattice.area(), n_sites);
}

double Result::energy_bound() const {
    return job_.density ? std::numeric_limits<double>::quiet_NaN()
                        : plane::energy_bound(computed_.cells);
}

pcvt_sites Result::sites() const {
    pcvt_sites view{};
    copy_lattice(job_.in_plane().lattice, view.lattice);
    view.points = sites_.data();
    view.n_sites = static_cast<std::int32_t>(sites_.cols());
    const Eigen::VectorXd& weights = computed_.cells.delaunay.weights();
    view.weights = weights.size() == 0 ? nullptr : weights.data();
    const CellMaterials& materials = computed_.materials;
    if (!materials.site_phase.empty()) view.phases = numbers(materials.site_phase);
    if (!phase_names_.empty()) view.phase_names = phase_names_.data();
    view.n_phases = static_cast<std::int32_t>(phase_names_.size());
    view.n_orbits = computed_.cells.n_orbits();
    view.orbits = numbers(computed_.cells.site_orbits);
    // Three doubles each, without padding.
    static_assert(sizeof(BungeAngles) == 3 * sizeof(double));
    if (!materials.site_orientation.empty()) {
        view.orientations = &materials.site_orientation.front().phi1;
    }
    return view;
}

pcvt_inclusions Result::inclusions() const {
    pcvt_inclusions view{};
    if (inclusions_.form.empty()) return view;
    view.numbers = inclusions_.numbers.data();
    view.begin = numbers(inclusions_.begin);
    view.form = numbers(inclusions_.form);
    view.tags = inclusions_.tags.data();
    view.n_shapes = static_cast<std::int32_t>(inclusions_.form.size());
    return view;
}

pcvt_statistics Result::statistics() const {
    const std::vector<int>& valences =
        valences_.get([&] { return counts_by_sides(computed_.cells); });
    const plane::Tessellation& cells = computed_.cells;
    return {.energy = cells.run.energy,
            .energy_bound = energy_bound(),
            .residual = cells.run.residual,
            .rms_residual = cells.run.rms_residual,
            .seconds_build = computed_.seconds.build,
            .seconds_optimize = computed_.seconds.optimize,
            .valences = numbers(valences),
            .n_valences = static_cast<std::int32_t>(valences.size()),
            .n_hexagons = valences.size() > 6 ? valences[6] : 0,
            .stop = stop_number(cells.run.stop),
            .n_sites = static_cast<std::int32_t>(sites_.cols()),
            .iterations = cells.run.iterations,
            .evaluations = cells.run.evaluations,
            .n_threads = job_.run.n_threads,
            .n_mirrors = cells.counts.n_mirrors.value_or(-1),
            .area_error = cells.areas ? cells.areas->largest_relative_error
                                      : std::numeric_limits<double>::quiet_NaN(),
            .newton_steps = cells.areas ? cells.areas->newton_steps : 0,
            .n_dropped = static_cast<std::int32_t>(job_.dropped.sites.size()),
            .dropped = dropped_pairs(job_.dropped)};
}

std::int32_t Result::minimum() const {
    return minimum_.get([&] { return minimum_number(minimum_of(computed_.cells)); });
}

pcvt_mesh Result::mesh(plane::MeshKind kind) const {
    const plane::PeriodicMesh& mesh = periodic(kind);
    pcvt_mesh view{};
    copy_lattice(mesh.lattice, view.lattice);
    view.vertices = numbers(mesh.vertices);
    view.face_begin = numbers(mesh.face_begin);
    view.corner_vertex = numbers(mesh.corner_vertex);
    view.corner_offset = numbers(mesh.corner_offset);
    view.opposite = numbers(mesh.opposite);
    view.site = numbers(mesh.site);
    view.site_points = numbers(mesh.site_points);
    view.kind = kind_number(kind);
    view.n_vertices = mesh.n_vertices();
    view.n_faces = mesh.n_faces();
    view.n_corners = mesh.n_corners();
    return view;
}

pcvt_tile Result::tile(const Layout& layout) const {
    const JobCallback no_callback;
    JobMonitor monitor(no_callback, {});
    const TileArrays& made = arrays(layout, monitor);
    const plane::Tile& tile = made.built.tile;
    pcvt_tile view{};
    copy_lattice(tile.lattice, view.lattice);
    view.points = numbers(tile.points);
    view.face_begin = numbers(tile.faces.begin);
    view.corners = numbers(tile.faces.corners);
    view.face_site = numbers(tile.face_site);
    view.site_points = numbers(tile.site_points);
    view.vertex_site = numbers(tile.vertex_site);
    view.vertex_orbit = numbers(made.orbit);
    view.vertex_offset = numbers(made.offset);
    view.edge_pairs = made.edge_pairs.data();
    view.kind = kind_number(layout.kind);
    view.outline = outline_number(layout.outline);
    view.n_vertices = tile.n_vertices();
    view.n_faces = tile.n_faces();
    view.n_corners = static_cast<std::int32_t>(tile.faces.corners.size());
    view.n_edge_pairs = static_cast<std::int32_t>(made.edge_pairs.size());
    view.wall_edges = made.wall_edges.empty() ? nullptr : made.wall_edges.data();
    view.n_wall_edges = static_cast<std::int32_t>(made.wall_edges.size());
    view.n_holes = static_cast<std::int32_t>(job_.holes.size());
    if (!hole_names_.empty()) view.hole_names = hole_names_.data();
    return view;
}

bool Result::write(const WriteRequest& request, const JobCallback& callback) const {
    Job job = job_;
    job.meshes = {request.layout.kind};
    job.tile.outline = request.layout.outline;
    if (!request.path.empty()) job.outputs = {request.path};
    job.file_options = request.files;
    job.report = request.report;
    job.force = request.replace;
    // The cells have their materials, also where this file does not state them.
    job.materials = {};
    const std::vector<JobFile> files = plan_files(job);
    const bool has_tile = !files.empty() && files.front().format->needs_tile();
    const TileSource tiles = [&](JobMonitor& monitor) -> std::span<const plane::BuiltTile> {
        if (!has_tile) return {};
        return {&arrays(request.layout, monitor).built, 1};
    };
    const RunSummary summary = write_job(job, computed_, tiles, callback);
    if (!summary.refused.empty()) throw CoarsePrecision(summary.refused.front().reason);
    return summary.run.stop != Stop::kCancelled;
}

}  // namespace pcvt::abi
