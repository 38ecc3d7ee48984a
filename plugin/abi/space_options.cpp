#include "plugin/abi/space_options.hpp"

#include "plugin/abi/option_values.hpp"
#include "plugin/abi/options.hpp"

namespace pcvt::abi {
namespace {

constexpr const char* kPlaneAlone =
    "is not for three dimensions; leave it at its default, or set dimension to 2";
constexpr const char* kPlaneFile = "is not for files in three dimensions; leave it at its default";

static_assert(find_abi_value(kSpaceStarts, PCVT_START_RANDOM)->start == SpaceStart::kRandom);
static_assert(find_abi_value(kSpaceStarts, PCVT_START_COARSE)->start == SpaceStart::kCoarse);
static_assert(find_abi_value(kSpaceStarts, PCVT_START_LATTICE)->start == SpaceStart::kLattice);
static_assert(find_abi_value(kSpaceSolvers, PCVT_SOLVER_LBFGS)->solver == Solver::kLbfgs);
static_assert(find_abi_value(kSpaceSolvers, PCVT_SOLVER_LLOYD)->solver == Solver::kLloyd);
static_assert(find_abi_value(kSpaceMeshes, PCVT_VORONOI)->mesh == SpaceMesh::kVoronoi);
static_assert(find_abi_value(kSpaceMeshes, PCVT_DELAUNAY)->mesh == SpaceMesh::kDelaunay);
static_assert(find_abi_value(kSurfaceForms, PCVT_SURFACE_CELLS)->form == SurfaceForm::kCells);
static_assert(find_abi_value(kSurfaceForms, PCVT_SURFACE_BOUNDARY)->form == SurfaceForm::kBoundary);

/// @param words  the choices, for the message.
template <class Table>
const auto& space_row(const char* name, std::int32_t value, const Table& table, const char* words) {
    if (const auto* row = find_abi_value(table, value)) return *row;
    throw InvalidInput(std::string(name) + " " + std::to_string(value) +
                       " is not for three dimensions; take " + words);
}

void refuse_plane_shapes(const UnusedFields<pcvt_options>& plane) {
    plane.refuse("lattice", &pcvt_options::lattice);
    plane.refuse("origin", &pcvt_options::origin);
    plane.refuse("find_origin", &pcvt_options::find_origin);
    plane.refuse("columns", &pcvt_options::columns);
    plane.refuse("rows", &pcvt_options::rows);
    plane.refuse("grain_order", &pcvt_options::grain_order);
    plane.refuse("grain_size", &pcvt_options::grain_size);
    plane.refuse("grain_per_edge", &pcvt_options::grain_per_edge);
    plane.refuse("walls", &pcvt_options::walls);
    plane.refuse("wall_cells", &pcvt_options::wall_cells);
    plane.refuse("inclusions", &pcvt_options::inclusions);
    plane.refuse("fibres", &pcvt_options::fibres);
    plane.refuse("holes", &pcvt_options::holes);
}

void refuse_plane_cells(const UnusedFields<pcvt_options>& plane) {
    plane.refuse("budget", &pcvt_options::budget);
    plane.refuse("density_source", &pcvt_options::density_source);
    plane.refuse("density_range", &pcvt_options::density_range);
    plane.refuse("density", &pcvt_options::density);
    plane.refuse("density_data", &pcvt_options::density_data);
    plane.refuse("areas", &pcvt_options::areas);
    plane.refuse("n_areas", &pcvt_options::n_areas);
    plane.refuse("area_law", &pcvt_options::area_law);
    plane.refuse("aspect", &pcvt_options::aspect);
    plane.refuse("aspect_degrees", &pcvt_options::aspect_degrees);
    plane.refuse("phases", &pcvt_options::phases);
    plane.refuse("orientations", &pcvt_options::orientations);
    plane.refuse("n_orientations", &pcvt_options::n_orientations);
    plane.refuse("random_orientations", &pcvt_options::random_orientations);
    plane.refuse("symmetry", &pcvt_options::symmetry);
    plane.refuse("fixed_sites", &pcvt_options::fixed_sites);
    plane.refuse("n_fixed_sites", &pcvt_options::n_fixed_sites);
}

void refuse_plane_files(const pcvt_write_options& options) {
    const UnusedFields<pcvt_write_options> plane(options, {}, kPlaneFile);
    plane.refuse("outline", &pcvt_write_options::outline);
    plane.refuse("colour", &pcvt_write_options::colour);
    plane.refuse("gltf_nodes", &pcvt_write_options::gltf_nodes);
    plane.refuse("single_precision", &pcvt_write_options::single_precision);
    plane.refuse("pixels", &pcvt_write_options::pixels);
    plane.refuse("element", &pcvt_write_options::element);
    plane.refuse("cut_width", &pcvt_write_options::cut_width);
    plane.refuse("background", &pcvt_write_options::background);
    plane.refuse("voxels", &pcvt_write_options::voxels);
    plane.refuse("voxel_layers", &pcvt_write_options::voxel_layers);
    plane.refuse("coriolis", &pcvt_write_options::coriolis);
    plane.refuse("job", &pcvt_write_options::job);
    plane.refuse("thickness", &pcvt_write_options::thickness);
    plane.refuse("materials", &pcvt_write_options::materials);
}

space::Lattice space_lattice(const double* numbers) {
    require_finite("lattice3", numbers, 9);
    const auto row = [numbers](int k) {
        return space::Vec3(Eigen::Map<const space::Vec3>(numbers + 3 * k));
    };
    try {
        return {row(0), row(1), row(2)};
    } catch (const InvalidInput& error) {
        throw InvalidInput(std::string("lattice3: ") + error.what());
    }
}

space::Points space_sites(const pcvt_options& options) {
    if (options.sites == nullptr) return space::Points(3, 0);
    require_finite_points("site", options.sites, options.n_sites, 3);
    return Eigen::Map<const space::Points>(options.sites, 3, options.n_sites);
}

}  // namespace

bool means_space(const pcvt_options& options) {
    if (options.dimension == 3) return true;
    if (options.dimension != 2) {
        throw InvalidInput("dimension " + std::to_string(options.dimension) +
                           " is unknown; take 2 or 3");
    }
    const UnusedFields<pcvt_options> space(options, default_options(),
                                           "is for three dimensions; set dimension to 3");
    space.refuse("lattice3", &pcvt_options::lattice3);
    return false;
}

SpaceJob make_space_job(const pcvt_options& options) {
    const UnusedFields<pcvt_options> plane(options, default_options(), kPlaneAlone);
    refuse_plane_shapes(plane);
    refuse_plane_cells(plane);
    if (options.n_sites < 1 || options.n_sites > space::kMostSites) {
        throw InvalidInput("n_sites is not between 1 and " + std::to_string(space::kMostSites));
    }
    require_positive("tolerance", options.tolerance);
    require_one_start(options.sites, options.start);
    SpaceJob job;
    job.lattice = space_lattice(options.lattice3);
    job.n_sites = options.n_sites;
    if (options.start != PCVT_START_DEFAULT) {
        job.start = space_row("start", options.start, kSpaceStarts,
                              "PCVT_START_DEFAULT, PCVT_START_RANDOM, PCVT_START_COARSE or "
                              "PCVT_START_LATTICE")
                        .start;
    }
    job.seed = options.seed;
    if (options.solver != PCVT_SOLVER_DEFAULT) {
        job.run.solver = space_row("solver", options.solver, kSpaceSolvers,
                                   "PCVT_SOLVER_DEFAULT, PCVT_SOLVER_LBFGS or PCVT_SOLVER_LLOYD")
                             .solver;
    }
    job.run.tolerance = options.tolerance;
    job.run.max_iterations = options.max_iterations;
    job.run.n_threads = thread_count(options.n_threads);
    job.points = space_sites(options);
    job.duplicates = duplicates(options);
    require_finite("short_edges", &options.short_edges, 1);
    job.short_edges = options.short_edges;
    return job;
}

SpaceFileOptions space_file_options(const std::string& path, const pcvt_write_options& options) {
    refuse_plane_files(options);
    SpaceFileOptions files;
    files.mesh =
        space_row("kind", options.kind, kSpaceMeshes, "PCVT_VORONOI or PCVT_DELAUNAY").mesh;
    files.surfaces = chosen_row("surface", options.surface, kSurfaceForms).form;
    const SpaceFormat* const format = find_space_format(path);
    const bool has_surfaces = format == nullptr || format->surfaces == FormatSurfaces::kChosen;
    if (options.surface != PCVT_SURFACE_CELLS && !has_surfaces) {
        throw InvalidInput("surface is for " + surface_extensions() + "; leave it at its default");
    }
    return files;
}

}  // namespace pcvt::abi
