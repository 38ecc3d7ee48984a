#include "plugin/abi/options.hpp"

#include <algorithm>
#include <limits>

#include "plugin/abi/option_values.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt::abi {
namespace {

// The numbers of the published interface never change.
static_assert(mesh_kind_row(plane::MeshKind::kVoronoi).abi_value == PCVT_VORONOI);
static_assert(mesh_kind_row(plane::MeshKind::kDelaunay).abi_value == PCVT_DELAUNAY);
static_assert(mesh_kind_row(plane::MeshKind::kGrains).abi_value == PCVT_GRAINS);
static_assert(find_abi_value(kPlaneElements, PCVT_CPE)->element == PlaneElement::kStrain);
static_assert(find_abi_value(kPlaneElements, PCVT_CPS)->element == PlaneElement::kStress);
static_assert(find_abi_value(kSolverJobs, PCVT_JOB_ELASTIC)->job == SolverJob::kElastic);
static_assert(colouring_row(Colouring::kSides).abi_value == PCVT_COLOUR_SIDES);
static_assert(colouring_row(Colouring::kSize).abi_value == PCVT_COLOUR_SIZE);
static_assert(colouring_row(Colouring::kCells).abi_value == PCVT_COLOUR_CELLS);
static_assert(colouring_row(Colouring::kDensity).abi_value == PCVT_COLOUR_DENSITY);
static_assert(colouring_row(Colouring::kPhase).abi_value == PCVT_COLOUR_PHASE);
static_assert(colouring_row(Colouring::kOrbit).abi_value == PCVT_COLOUR_ORBIT);
static_assert(colouring_row(Colouring::kTag).abi_value == PCVT_COLOUR_TAG);
static_assert(solver_row(Solver::kLbfgs).abi_value == PCVT_SOLVER_LBFGS);
static_assert(solver_row(Solver::kLloyd).abi_value == PCVT_SOLVER_LLOYD);
static_assert(solver_row(Solver::kNewton).abi_value == PCVT_SOLVER_NEWTON);
static_assert(find_word(plane::kPlaneGroups, "p1")->abi_value == PCVT_SYMMETRY_P1);
static_assert(find_word(plane::kPlaneGroups, "p2")->abi_value == PCVT_SYMMETRY_P2);
static_assert(find_word(plane::kPlaneGroups, "pm")->abi_value == PCVT_SYMMETRY_PM);
static_assert(find_word(plane::kPlaneGroups, "pg")->abi_value == PCVT_SYMMETRY_PG);
static_assert(find_word(plane::kPlaneGroups, "cm")->abi_value == PCVT_SYMMETRY_CM);
static_assert(find_word(plane::kPlaneGroups, "pmm")->abi_value == PCVT_SYMMETRY_PMM);
static_assert(find_word(plane::kPlaneGroups, "pmg")->abi_value == PCVT_SYMMETRY_PMG);
static_assert(find_word(plane::kPlaneGroups, "pgg")->abi_value == PCVT_SYMMETRY_PGG);
static_assert(find_word(plane::kPlaneGroups, "cmm")->abi_value == PCVT_SYMMETRY_CMM);
static_assert(find_word(plane::kPlaneGroups, "p4")->abi_value == PCVT_SYMMETRY_P4);
static_assert(find_word(plane::kPlaneGroups, "p4m")->abi_value == PCVT_SYMMETRY_P4M);
static_assert(find_word(plane::kPlaneGroups, "p4g")->abi_value == PCVT_SYMMETRY_P4G);
static_assert(find_word(plane::kPlaneGroups, "p3")->abi_value == PCVT_SYMMETRY_P3);
static_assert(find_word(plane::kPlaneGroups, "p3m1")->abi_value == PCVT_SYMMETRY_P3M1);
static_assert(find_word(plane::kPlaneGroups, "p31m")->abi_value == PCVT_SYMMETRY_P31M);
static_assert(find_word(plane::kPlaneGroups, "p6")->abi_value == PCVT_SYMMETRY_P6);
static_assert(find_word(plane::kPlaneGroups, "p6m")->abi_value == PCVT_SYMMETRY_P6M);
static_assert(walls_row(Walls::kNone).abi_value == PCVT_WALLS_NONE);
static_assert(walls_row(Walls::kX).abi_value == PCVT_WALLS_X);
static_assert(walls_row(Walls::kY).abi_value == PCVT_WALLS_Y);
static_assert(walls_row(Walls::kXY).abi_value == PCVT_WALLS_XY);
static_assert(wall_cells_row(WallCells::kWhole).abi_value == PCVT_WALL_CELLS_WHOLE);
static_assert(wall_cells_row(WallCells::kHalf).abi_value == PCVT_WALL_CELLS_HALF);
static_assert(plane::WallId::side(WallSide::kLeft).number == PCVT_WALL_LEFT);
static_assert(plane::WallId::side(WallSide::kRight).number == PCVT_WALL_RIGHT);
static_assert(plane::WallId::side(WallSide::kBottom).number == PCVT_WALL_BOTTOM);
static_assert(plane::WallId::side(WallSide::kTop).number == PCVT_WALL_TOP);
static_assert(plane::WallId::hole(0).number == PCVT_WALL_HOLE);

static_assert(find_abi_value(kDuplicates, PCVT_DUPLICATES_REFUSE)->duplicates ==
              Duplicates::kRefuse);
static_assert(find_abi_value(kDuplicates, PCVT_DUPLICATES_DROP)->duplicates == Duplicates::kDrop);
static_assert(find_word(kGltfNodes, "cells")->abi_value == PCVT_NODES_CELLS);
static_assert(find_word(kGltfNodes, "one")->abi_value == PCVT_NODES_ONE);

std::optional<Start> start(const pcvt_options& options) {
    require_one_start(options.sites, options.start);
    if (options.start == PCVT_START_DEFAULT) return std::nullopt;
    return chosen_row("start", options.start, start_rows()).start;
}

int budget(const pcvt_options& options) {
    if (options.budget == 0) return 0;
    if (options.start != PCVT_START_BEST) {
        throw InvalidInput("budget is for PCVT_START_BEST; leave it at 0");
    }
    if (options.budget < 0 || options.budget > std::numeric_limits<int>::max()) {
        throw InvalidInput("budget is not between 0 and 2147483647");
    }
    return static_cast<int>(options.budget);
}

Solver solver(std::int32_t value) {
    if (value == PCVT_SOLVER_DEFAULT) return Job().run.solver;
    return chosen_row("solver", value, kSolvers).solver;
}

void read_grains(const pcvt_options& options, Job& job) {
    const double lengths[] = {options.grain_size, options.short_edges};
    require_finite("grain_size or short_edges", lengths, 2);
    if (options.grain_size < 0) throw InvalidInput("grain_size is negative; take 0 or a length");
    if (options.grain_order < 0 || options.grain_order > 2) {
        throw InvalidInput("grain_order is not 0, 1 or 2");
    }
    if (options.grain_per_edge < 0)
        throw InvalidInput("grain_per_edge is negative; take 0 or more");
    job.tile.grain_size = options.grain_size;
    job.tile.grain_per_edge = options.grain_per_edge;
    job.tile.order = std::max(1, options.grain_order);
    job.tile.short_edges = options.short_edges;
}

std::optional<plane::PlaneGroupName> symmetry(std::int32_t value) {
    if (value == PCVT_SYMMETRY_NONE) return std::nullopt;
    return chosen_row("symmetry", value, plane::kPlaneGroups).name;
}

std::optional<WishedAreas> wished_areas(const pcvt_options& options) {
    if (options.areas != nullptr && options.area_law != nullptr) {
        throw InvalidInput("areas and area_law exclude each other; leave one out");
    }
    if (options.area_law != nullptr) {
        return WishedAreas{.law = parse_area_law(options.area_law), .name = options.area_law};
    }
    if (options.areas == nullptr) {
        if (options.n_areas == 0) return std::nullopt;
        throw InvalidInput("n_areas is not 0, but areas is a null pointer; give both");
    }
    if (options.n_areas != options.n_sites) {
        throw InvalidInput("n_areas is not n_sites; give one area for each site");
    }
    return WishedAreas{.given = Eigen::Map<const Eigen::VectorXd>(options.areas, options.n_areas),
                       .name = "given"};
}

std::optional<Aspect> aspect(const pcvt_options& options) {
    const double values[] = {options.aspect, options.aspect_degrees};
    require_finite("aspect or aspect_degrees", values, 2);
    if (options.aspect == 1) return std::nullopt;
    return Aspect{.ratio = options.aspect, .degrees = options.aspect_degrees};
}

MaterialChoices materials(const pcvt_options& options) {
    MaterialChoices choices;
    if (options.phases != nullptr) choices.phases = parse_phases(options.phases);
    if (options.random_orientations != 0 && options.random_orientations != 1) {
        throw InvalidInput("random_orientations is neither 0 nor 1");
    }
    choices.draws_orientations = options.random_orientations == 1;
    if (options.orientations == nullptr) {
        if (options.n_orientations == 0) return choices;
        throw InvalidInput(
            "n_orientations is not 0, but orientations is a null pointer; give both");
    }
    if (choices.draws_orientations) {
        throw InvalidInput(
            "orientations and random_orientations exclude each other; leave one out");
    }
    if (options.n_orientations != options.n_sites) {
        throw InvalidInput("n_orientations is not n_sites; give one orientation for each site");
    }
    for (std::int32_t s = 0; s < options.n_sites; ++s) {
        const double* const angles = options.orientations + 3 * std::ptrdiff_t{s};
        choices.orientations.push_back(checked_angles({angles[0], angles[1], angles[2]}));
    }
    return choices;
}

/// @param name  of one of them in messages.
plane::Points finite_points(const char* name, const double* numbers, std::int32_t n) {
    require_finite_points(name, numbers, n, 2);
    return Eigen::Map<const plane::Points>(numbers, 2, n);
}

plane::Points given_sites(const pcvt_options& options) {
    if (options.sites == nullptr) return plane::Points(2, 0);
    return finite_points("site", options.sites, options.n_sites);
}

plane::Points fixed_sites(const pcvt_options& options) {
    if (options.fixed_sites != nullptr) {
        return finite_points("fixed site", options.fixed_sites, options.n_fixed_sites);
    }
    if (options.n_fixed_sites == 0) return plane::Points(2, 0);
    throw InvalidInput("n_fixed_sites is not 0, but fixed_sites is a null pointer; give both");
}

}  // namespace

Duplicates duplicates(const pcvt_options& options) {
    const Duplicates chosen = chosen_row("duplicates", options.duplicates, kDuplicates).duplicates;
    if (chosen == Duplicates::kRefuse || options.sites != nullptr ||
        options.fixed_sites != nullptr) {
        return chosen;
    }
    throw InvalidInput("duplicates is for given sites; leave it at its default, or give sites");
}

void check_struct_size(const char* name, std::size_t size, std::size_t oldest) {
    // Fields are appended in multiples of eight bytes.
    if (size < oldest || size > kLargestStruct || size % alignof(double) != 0) {
        throw AbiMismatch(std::string(name) + " has size " + std::to_string(size) +
                          " in place of " + std::to_string(oldest) +
                          "; build the host with the header of this pcvt");
    }
}

void throw_unknown_fields(const char* name) {
    throw AbiMismatch(std::string(name) +
                      " has fields that this pcvt does not know; take a newer one");
}

bool uses_reserved_fields(const pcvt_options& options) {
    return options.reserved != 0 || options.reserved2 != 0 || options.reserved3 != 0 ||
           options.reserved4 != 0 || options.reserved5 != 0;
}

bool uses_reserved_fields(const pcvt_write_options& options) { return options.reserved2 != 0; }

void check_tail(const char* name, const void* begin, std::size_t size, std::size_t known) {
    const char* bytes = static_cast<const char*>(begin);
    if (std::any_of(bytes + known, bytes + size, [](char byte) { return byte != 0; })) {
        throw_unknown_fields(name);
    }
}

void check_version(std::uint32_t host) {
    constexpr std::uint32_t own = PCVT_ABI_VERSION;
    const bool same_major = host >> 16 == own >> 16;
    const bool fits = own >> 16 == 0 ? host == own : host <= own;
    if (same_major && fits) return;
    const auto text = [](std::uint32_t version) {
        return std::to_string(version >> 16) + "." + std::to_string(version & 0xFFFFU);
    };
    throw AbiMismatch("the host was built for interface " + text(host) + ", this library has " +
                      text(own) + "; build the host with the header of this pcvt");
}

pcvt_options default_options() {
    pcvt_options options{};
    options.struct_size = sizeof options;
    options.lattice[0] = options.lattice[3] = 1;
    options.max_iterations = -1;
    options.tolerance = 1e-6;
    options.columns = options.rows = 1;
    options.aspect = 1;
    options.dimension = 2;
    options.lattice3[0] = options.lattice3[4] = options.lattice3[8] = 1;
    return options;
}

plane::MeshKind tile_kind(std::int32_t kind) {
    return chosen_row("kind", kind, plane::kMeshKinds).kind;
}

plane::Outline tile_outline(std::int32_t outline) {
    if (outline == PCVT_WHOLE) return plane::Outline::kWhole;
    if (outline == PCVT_BOX) return plane::Outline::kBox;
    throw InvalidInput("outline " + std::to_string(outline) + " is unknown; take one of pcvt.h");
}

FileOptions file_options(const pcvt_write_options& options) {
    if (options.surface != PCVT_SURFACE_CELLS) {
        throw InvalidInput("surface is for three dimensions; leave it at its default");
    }
    FileOptions result;
    if (options.colour != PCVT_COLOUR_DEFAULT) {
        result.colouring = chosen_row("colour", options.colour, kColourings).colouring;
    }
    if (options.background != nullptr) result.background = background_colour(options.background);
    if (options.gltf_nodes != PCVT_NODES_DEFAULT) {
        result.gltf_nodes = chosen_row("gltf_nodes", options.gltf_nodes, kGltfNodes).nodes;
    }
    result.single_precision = options.single_precision != 0;
    if (options.pixels < 0) throw InvalidInput("pixels is negative; take 0 or more");
    result.pixels = options.pixels;
    if ((options.voxels[0] != 0 || options.voxels[1] != 0) &&
        (options.voxels[0] < plane::kLeastVoxels || options.voxels[1] < plane::kLeastVoxels)) {
        throw InvalidInput("voxels are fewer than 2 along an axis; take 2 or more, or 0 for both");
    }
    if (options.voxel_layers < 0) throw InvalidInput("voxel_layers is negative; take 0 or more");
    result.voxels = {options.voxels[0], options.voxels[1], std::max(options.voxel_layers, 1)};
    require_finite("coriolis", options.coriolis, 2);
    if (options.coriolis[0] != 0 || options.coriolis[1] != 0) {
        result.coriolis = {options.coriolis[0], options.coriolis[1]};
    }
    require_finite("cut_width", &options.cut_width, 1);
    if (options.cut_width < 0) throw InvalidInput("cut_width is negative; take 0 or a length");
    result.cut_width = options.cut_width;
    require_finite("thickness", &options.thickness, 1);
    if (options.thickness < 0) throw InvalidInput("thickness is negative; take 0 or a length");
    result.thickness = options.thickness;
    result.element = chosen_row("element", options.element, kPlaneElements).element;
    if (options.job != PCVT_JOB_NONE) {
        result.job = chosen_row("job", options.job, kSolverJobs).job;
    }
    if (options.materials != nullptr) {
        try {
            result.elastic = parse_elastic_choices(options.materials);
        } catch (const InvalidInput& error) {
            throw InvalidInput(std::string("materials: ") + error.what());
        }
    }
    return result;
}

Job make_job(const pcvt_options& options) {
    require_finite("lattice", options.lattice, 4);
    require_finite("origin", options.origin, 2);
    if (options.n_sites < 1 || options.n_sites > plane::kMostSites) {
        throw InvalidInput("n_sites is not between 1 and " + std::to_string(plane::kMostSites));
    }
    require_positive("tolerance", options.tolerance);
    Job job;
    job.in_plane().lattice = plane::Lattice({options.lattice[0], options.lattice[1]},
                                            {options.lattice[2], options.lattice[3]});
    job.in_plane().points = given_sites(options);
    job.n_sites = options.n_sites;
    job.seed = options.seed;
    job.start = start(options);
    job.budget = budget(options);
    read_grains(options, job);
    job.run.solver = solver(options.solver);
    job.run.tolerance = options.tolerance;
    job.run.max_iterations = options.max_iterations;
    job.run.n_threads = thread_count(options.n_threads);
    job.tile.columns = options.columns;
    job.tile.rows = options.rows;
    job.tile.origin = {options.origin[0], options.origin[1]};
    if (options.find_origin != 0 && options.find_origin != 1) {
        throw InvalidInput("find_origin is neither 0 nor 1");
    }
    job.tile.finds_origin = options.find_origin == 1;
    job.areas = wished_areas(options);
    job.aspect = aspect(options);
    job.symmetry = symmetry(options.symmetry);
    job.walls = chosen_row("walls", options.walls, kWalls).walls;
    job.wall_cells = chosen_row("wall_cells", options.wall_cells, kWallCells).cells;
    job.materials = materials(options);
    job.in_plane().fixed = fixed_sites(options);
    if (options.inclusions != nullptr) {
        job.inclusions = parse_inclusions("inclusions", options.inclusions);
    }
    if (options.fibres != nullptr) job.fibres = parse_fibres(options.fibres);
    if (options.holes != nullptr) job.holes = parse_tags(options.holes);
    job.duplicates = duplicates(options);
    return job;
}

}  // namespace pcvt::abi
