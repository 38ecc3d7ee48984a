#include "plugin/abi/options.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "plugin/abi/feature_fields.hpp"
#include "plugin/abi/option_values.hpp"
#include "plugin/job/job_files.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt::abi {
namespace {

// The numbers of the published interface never change.
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

constexpr const char* kPlaneAlone =
    "is not for three dimensions; leave it at its default, or set dimension to 2";
constexpr const char* kSpaceAlone = "is for three dimensions; set dimension to 3";

/// Requires a known dimension, and no field of the other one.
/// @returns whether it is 3.
bool means_space(const pcvt_options& options) {
    if (options.dimension != 2 && options.dimension != 3) {
        throw InvalidInput("dimension " + std::to_string(options.dimension) +
                           " is unknown; take 2 or 3");
    }
    const bool in_space = options.dimension == 3;
    require_default_fields(kOptionFields, options, default_options(),
                           in_space ? &FeatureRow::in_space : &FeatureRow::in_plane,
                           in_space ? kPlaneAlone : kSpaceAlone);
    return in_space;
}

std::optional<Start> start(const pcvt_options& options, bool in_space) {
    require_one_start(options.sites, options.start);
    if (options.start == PCVT_START_DEFAULT) return std::nullopt;
    return row_for(in_space, "start", options.start, start_rows(),
                   "PCVT_START_DEFAULT, PCVT_START_RANDOM, PCVT_START_COARSE or "
                   "PCVT_START_LATTICE")
        .start;
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

Solver solver(std::int32_t value, bool in_space) {
    if (value == PCVT_SOLVER_DEFAULT) return Job().run.solver;
    return row_for(in_space, "solver", value, kSolvers,
                   "PCVT_SOLVER_DEFAULT, PCVT_SOLVER_LBFGS or PCVT_SOLVER_LLOYD")
        .solver;
}

int grain_order(const pcvt_options& options) {
    if (options.grain_order >= 0 && options.grain_order <= 2) {
        return std::max(1, options.grain_order);
    }
    throw InvalidInput("grain_order is not 0, 1 or 2");
}

std::optional<plane::PlaneGroupName> symmetry(std::int32_t value) {
    if (value == PCVT_SYMMETRY_NONE) return std::nullopt;
    return chosen_row("symmetry", value, plane::kPlaneGroups).name;
}

/// Sizes that a host gives or draws, by the names of their three fields.
std::optional<TargetSizes> target_sizes(const std::string& given, const std::string& law,
                                        const double* sizes, std::int32_t n, const char* drawn,
                                        std::int32_t n_sites) {
    const std::string word = given.substr(0, given.size() - 1);
    if (sizes != nullptr && drawn != nullptr) {
        throw InvalidInput(given + " and " + law + " exclude each other; leave one out");
    }
    if (drawn != nullptr) return TargetSizes{.law = parse_area_law(drawn), .name = drawn};
    if (sizes == nullptr) {
        if (n == 0) return std::nullopt;
        throw InvalidInput("n_" + given + " is not 0, but " + given +
                           " is a null pointer; give both");
    }
    if (n != n_sites) {
        throw InvalidInput("n_" + given + " is not n_sites; give one " + word + " for each site");
    }
    return TargetSizes{.given = Eigen::Map<const Eigen::VectorXd>(sizes, n), .name = "given"};
}

std::optional<Aspect> aspect(const pcvt_options& options) {
    const double values[] = {options.aspect, options.aspect_degrees};
    require_finite("aspect or aspect_degrees", values, 2);
    require_finite("aspect_axis", options.aspect_axis, 3);
    if (options.aspect == 1) return std::nullopt;
    Aspect aspect{.ratio = options.aspect, .degrees = options.aspect_degrees};
    const Eigen::Map<const space::Vec3> axis(options.aspect_axis);
    if (axis != space::Vec3::Zero()) aspect.axis = axis;
    return aspect;
}

std::optional<GivenWeights> given_weights(const pcvt_options& options) {
    if (options.weights == nullptr) {
        if (options.n_weights == 0) return std::nullopt;
        throw InvalidInput("n_weights is not 0, but weights is a null pointer; give both");
    }
    if (options.n_weights != options.n_sites) {
        throw InvalidInput("n_weights is not n_sites; give one weight for each site");
    }
    require_finite("weights", options.weights, options.n_weights);
    return GivenWeights{Eigen::Map<const Eigen::VectorXd>(options.weights, options.n_weights),
                        "given"};
}

/// Sets the phase of each site, of the names that `phases` lists.
void read_site_phases(const pcvt_options& options, MaterialChoices& choices) {
    if (options.phases == nullptr) {
        throw InvalidInput("site_phases needs the names of the phases; set phases");
    }
    if (options.n_site_phases != options.n_sites) {
        throw InvalidInput("n_site_phases is not n_sites; give one phase for each site");
    }
    choices.phases = named_phases(options.phases);
    const auto n_phases = static_cast<std::int32_t>(choices.phases.size());
    for (std::int32_t s = 0; s < options.n_sites; ++s) {
        const std::int32_t phase = options.site_phases[s];
        if (phase < 0 || phase >= n_phases) {
            throw InvalidInput("site_phases of site " + std::to_string(s) + " is " +
                               std::to_string(phase) + "; take 0 to " +
                               std::to_string(n_phases - 1) + ", an index of a name in phases");
        }
        choices.site_phases.push_back(phase);
    }
}

/// Sets the orientation of each site, or the list from which they are drawn.
void read_orientations(const pcvt_options& options, MaterialChoices& choices) {
    if (choices.draws_orientations) {
        throw InvalidInput(
            "orientations and random_orientations exclude each other; leave one out");
    }
    const std::int32_t n = options.n_orientations;
    if (n < 1 || (n < options.n_sites && options.orientation_weights == nullptr)) {
        throw InvalidInput(
            "n_orientations is less than n_sites; give one orientation for each site, or a list to "
            "draw from, which is longer or has weights");
    }
    for (std::int32_t k = 0; k < n; ++k) {
        const double* const angles = options.orientations + 3 * std::ptrdiff_t{k};
        choices.orientations.push_back(checked_angles({angles[0], angles[1], angles[2]}));
    }
    choices.orientation_source = "the list";
    if (options.orientation_weights == nullptr) return;
    const std::span<const double> weights(options.orientation_weights, std::size_t(n));
    const auto is_weight = [](double w) { return w >= 0 && w <= kLargestEntryWeight; };
    if (!std::all_of(weights.begin(), weights.end(), is_weight) ||
        *std::max_element(weights.begin(), weights.end()) == 0) {
        throw InvalidInput(
            "orientation_weights are not all from 0 to 1e150, or all are 0; give weights of the "
            "orientations");
    }
    choices.orientation_weights.assign(weights.begin(), weights.end());
}

MaterialChoices materials(const pcvt_options& options) {
    MaterialChoices choices;
    if (options.site_phases != nullptr) {
        read_site_phases(options, choices);
    } else if (options.n_site_phases != 0) {
        throw InvalidInput("n_site_phases is not 0, but site_phases is a null pointer; give both");
    } else if (options.phases != nullptr) {
        choices.phases = parse_phases(options.phases);
    }
    if (options.random_orientations != 0 && options.random_orientations != 1) {
        throw InvalidInput("random_orientations is neither 0 nor 1");
    }
    choices.draws_orientations = options.random_orientations == 1;
    if (options.orientations != nullptr) {
        read_orientations(options, choices);
    } else if (options.n_orientations != 0 || options.orientation_weights != nullptr) {
        throw InvalidInput(
            "n_orientations is not 0, or orientation_weights is given, but orientations is a null "
            "pointer; give all");
    }
    return choices;
}

/// Points, n of them, one a column.
/// @param name  of one of them in messages.
template <class Points>
Points finite_points(const char* name, const double* numbers, std::int32_t n) {
    constexpr int kDimension = Points::RowsAtCompileTime;
    require_finite_points(name, numbers, n, kDimension);
    return Eigen::Map<const Points>(numbers, kDimension, n);
}

template <class Lattice>
JobDomain<Lattice> domain_of(const pcvt_options& options, const Lattice& lattice) {
    using Points = typename Lattice::Points;
    JobDomain<Lattice> domain{.lattice = lattice,
                              .points = Points(Lattice::kDimension, 0),
                              .fixed = Points(Lattice::kDimension, 0)};
    if (options.sites != nullptr) {
        domain.points = finite_points<Points>("site", options.sites, options.n_sites);
    }
    if (options.fixed_sites != nullptr) {
        domain.fixed =
            finite_points<Points>("fixed site", options.fixed_sites, options.n_fixed_sites);
    } else if (options.n_fixed_sites != 0) {
        throw InvalidInput("n_fixed_sites is not 0, but fixed_sites is a null pointer; give both");
    }
    return domain;
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

/// @throws InvalidInput where no sites are given.
Duplicates duplicates(const pcvt_options& options) {
    const Duplicates chosen = chosen_row("duplicates", options.duplicates, kDuplicates).duplicates;
    if (chosen == Duplicates::kRefuse || options.sites != nullptr ||
        options.fixed_sites != nullptr) {
        return chosen;
    }
    throw InvalidInput("duplicates is for given sites; leave it at its default, or give sites");
}

}  // namespace

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

Job make_job(const pcvt_options& options) {
    const bool in_space = means_space(options);
    const int most_sites = in_space ? space::kMostSites : plane::kMostSites;
    if (options.n_sites < 1 || options.n_sites > most_sites) {
        throw InvalidInput("n_sites is not between 1 and " + std::to_string(most_sites));
    }
    require_finite("origin", options.origin, 2);
    require_finite("origin_z", &options.origin_z, 1);
    require_positive("tolerance", options.tolerance);
    Job job;
    if (in_space) {
        job.domain = domain_of(options, space_lattice(options.lattice3));
        job.in_space().origin = {options.origin[0], options.origin[1], options.origin_z};
    } else {
        job.domain = domain_of(options, plane_lattice(options.lattice));
        job.in_plane().origin = {options.origin[0], options.origin[1]};
    }
    job.n_sites = options.n_sites;
    job.seed = options.seed;
    job.start = start(options, in_space);
    job.budget = budget(options);
    read_numbers(kOptionFields, options, job);
    job.tile.order = grain_order(options);
    job.run.solver = solver(options.solver, in_space);
    job.run.n_threads = thread_count(options.n_threads);
    job.tile.repeat = {options.columns, options.rows, options.layers == 0 ? 1 : options.layers};
    if (options.find_origin != 0 && options.find_origin != 1) {
        throw InvalidInput("find_origin is neither 0 nor 1");
    }
    job.tile.finds_origin = options.find_origin == 1;
    job.sizes = in_space ? target_sizes("volumes", "volume_law", options.volumes, options.n_volumes,
                                        options.volume_law, options.n_sites)
                         : target_sizes("areas", "area_law", options.areas, options.n_areas,
                                        options.area_law, options.n_sites);
    job.weights = given_weights(options);
    if (options.sites_are_centroids != 0) {
        if (options.sites_are_centroids != 1 || options.sites == nullptr) {
            throw InvalidInput("sites_are_centroids is neither 0, nor 1 with sites");
        }
        job.centroids = "given";
    }
    job.aspect = aspect(options);
    job.symmetry = symmetry(options.symmetry);
    job.walls = chosen_row("walls", options.walls, kWalls).walls;
    job.wall_cells = chosen_row("wall_cells", options.wall_cells, kWallCells).cells;
    job.materials = materials(options);
    if (options.inclusions != nullptr) {
        job.inclusions = parse_inclusions("inclusions", options.inclusions);
    }
    if (options.fibres != nullptr) job.fibres = parse_fibres(options.fibres);
    if (options.holes != nullptr) job.holes = parse_tags(options.holes);
    job.duplicates = duplicates(options);
    return job;
}

}  // namespace pcvt::abi
