#include "plugin/abi/result.hpp"

#include <algorithm>
#include <limits>

#include "mesher/plane/mesh/valence.hpp"
#include "plugin/abi/guard.hpp"
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
    const plane::Tile& tile = arrays.built.front().tile;
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

std::int32_t kind_number(plane::MeshKind kind) { return mesh_kind_row(kind).abi_value; }

std::int32_t outline_number(plane::Outline outline) {
    return outline == plane::Outline::kBox ? PCVT_BOX : PCVT_WHOLE;
}

}  // namespace

Result::Result(Job job, Computation<PlaneWorld> computed)
    : ComputedJob(std::move(job), std::move(computed)),
      sites_(wrapped_sites(this->computed().cells, this->job().in_plane().origin)),
      inclusions_(inclusion_arrays(this->computed().cells)) {
    for (const std::string& name : this->job().holes) hole_names_.push_back(name.c_str());
}

const plane::PeriodicMesh& Result::periodic(plane::MeshKind kind) const {
    if (kind == plane::MeshKind::kGrains) {
        throw InvalidInput("grains exist only as a tile; use pcvt_get_tile");
    }
    Job job = this->job();
    job.meshes = {kind};
    job.tile.outline = plane::Outline::kWhole;
    job.tile.repeat = {};
    check_job(job);
    return meshes_[kind_number(kind)].get([&] {
        require_memory_for_mesh(job, kind);
        return from_geometry([&] { return mesh_outside_holes(computed().cells, kind); });
    });
}

const TileArrays& Result::arrays(const Layout& layout, JobMonitor& monitor) const {
    Job job = this->job();
    job.meshes = {layout.kind};
    job.tile.outline = layout.outline;
    check_job(job);
    return tiles_[kind_number(layout.kind)][outline_number(layout.outline)].get([&] {
        require_memory_for_mesh(job, layout.kind);
        TileArrays made{from_geometry([&] { return proved_tiles(job, computed().cells, monitor); }),
                        {},
                        {},
                        {},
                        {}};
        note_orbits(made);
        return made;
    });
}

double Result::energy_bound() const {
    return job().density ? std::numeric_limits<double>::quiet_NaN()
                         : plane::energy_bound(computed().cells);
}

pcvt_sites Result::sites() const {
    pcvt_sites view{};
    copy_lattice(job().in_plane().lattice, view.lattice);
    view.points = sites_.data();
    view.n_sites = static_cast<std::int32_t>(sites_.cols());
    const Eigen::VectorXd& weights = computed().cells.delaunay.weights();
    view.weights = weights.size() == 0 ? nullptr : weights.data();
    show_materials(view);
    view.n_orbits = computed().cells.n_orbits();
    view.orbits = numbers(computed().cells.site_orbits);
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
    const plane::Tessellation& cells = computed().cells;
    pcvt_statistics view = ComputedJob::statistics(
        energy_bound(), [&] { return plane::histogram(cell_sides(cells)); });
    if (view.n_valences > 6) view.n_hexagons = view.valences[6];
    view.n_sites = static_cast<std::int32_t>(sites_.cols());
    view.n_mirrors = cells.counts.n_mirrors.value_or(-1);
    view.area_error = cells.areas ? cells.areas->largest_relative_error
                                  : std::numeric_limits<double>::quiet_NaN();
    view.newton_steps = cells.areas ? cells.areas->newton_steps : 0;
    return view;
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
    JobMonitor monitor(no_callback, job());
    const TileArrays& made = arrays(layout, monitor);
    const plane::Tile& tile = made.built.front().tile;
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
    view.n_holes = static_cast<std::int32_t>(job().holes.size());
    if (!hole_names_.empty()) view.hole_names = hole_names_.data();
    return view;
}

bool Result::write(const WriteRequest& request, const JobCallback& callback) const {
    const std::vector<JobFile> files = plan_files(job_of(request));
    const bool has_tile = !files.empty() && files.front().format->needs_tile();
    const PlaneWorld::Tiles none;
    const auto tiles = [&](JobMonitor& monitor) -> const PlaneWorld::Tiles& {
        return has_tile ? arrays(request.layout, monitor).built : none;
    };
    return ComputedJob::write(request, tiles, callback);
}

}  // namespace pcvt::abi
