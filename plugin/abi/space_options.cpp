#include "plugin/abi/space_options.hpp"

#include "plugin/abi/feature_fields.hpp"
#include "plugin/abi/option_values.hpp"
#include "plugin/abi/options.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt::abi {
namespace {

constexpr const char* kPlaneAlone =
    "is not for three dimensions; leave it at its default, or set dimension to 2";
constexpr const char* kPlaneFile = "is not for files in three dimensions; leave it at its default";

static_assert(find_abi_value(kSpaceMeshes, PCVT_VORONOI)->mesh == SpaceMesh::kVoronoi);
static_assert(find_abi_value(kSpaceMeshes, PCVT_DELAUNAY)->mesh == SpaceMesh::kDelaunay);
static_assert(find_abi_value(kSurfaceForms, PCVT_SURFACE_CELLS)->form == SurfaceForm::kCells);
static_assert(find_abi_value(kSurfaceForms, PCVT_SURFACE_BOUNDARY)->form == SurfaceForm::kBoundary);

/// @param words  the choices, for the message.
template <class Table>
const auto& space_row(const char* name, std::int32_t value, const Table& table, const char* words) {
    const auto* const row = find_abi_value(table, value);
    if (row != nullptr && row->in_space) return *row;
    throw InvalidInput(std::string(name) + " " + std::to_string(value) +
                       " is not for three dimensions; take " + words);
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
    require_default_fields(kOptionFields, options, default_options(), &FeatureRow::in_plane,
                           "is for three dimensions; set dimension to 3");
    return false;
}

Job make_space_job(const pcvt_options& options) {
    require_default_fields(kOptionFields, options, default_options(), &FeatureRow::in_space,
                           kPlaneAlone);
    if (options.n_sites < 1 || options.n_sites > space::kMostSites) {
        throw InvalidInput("n_sites is not between 1 and " + std::to_string(space::kMostSites));
    }
    require_positive("tolerance", options.tolerance);
    require_one_start(options.sites, options.start);
    Job job;
    job.domain = SpaceDomain{space_lattice(options.lattice3)};
    job.n_sites = options.n_sites;
    if (options.start != PCVT_START_DEFAULT) {
        job.start = space_row("start", options.start, start_rows(),
                              "PCVT_START_DEFAULT, PCVT_START_RANDOM, PCVT_START_COARSE or "
                              "PCVT_START_LATTICE")
                        .start;
    }
    job.seed = options.seed;
    if (options.solver != PCVT_SOLVER_DEFAULT) {
        job.run.solver = space_row("solver", options.solver, kSolvers,
                                   "PCVT_SOLVER_DEFAULT, PCVT_SOLVER_LBFGS or PCVT_SOLVER_LLOYD")
                             .solver;
    }
    job.run.tolerance = options.tolerance;
    job.run.max_iterations = options.max_iterations;
    job.run.n_threads = thread_count(options.n_threads);
    job.in_space().points = space_sites(options);
    job.duplicates = duplicates(options);
    require_finite("short_edges", &options.short_edges, 1);
    job.tile.short_edges = options.short_edges;
    return job;
}

SpaceFileOptions space_file_options(const std::string& path, const pcvt_write_options& options) {
    require_default_fields(kWriteFields, options, {}, &FeatureRow::in_space, kPlaneFile);
    SpaceFileOptions files;
    files.mesh =
        space_row("kind", options.kind, kSpaceMeshes, "PCVT_VORONOI or PCVT_DELAUNAY").mesh;
    files.surfaces = chosen_row("surface", options.surface, kSurfaceForms).form;
    const Format* const format = find_format(path);
    const bool has_surfaces =
        format == nullptr || !format->space || format->space->surfaces == FormatSurfaces::kChosen;
    if (options.surface != PCVT_SURFACE_CELLS && !has_surfaces) {
        throw InvalidInput("surface is for " + surface_extensions() + "; leave it at its default");
    }
    return files;
}

}  // namespace pcvt::abi
