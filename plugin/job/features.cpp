#include "plugin/job/features.hpp"

#include <algorithm>

#include "mesher/base/choices.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt {
namespace {

using F = Feature;

bool shows(const Job& job, ColouringNeed need) {
    const std::optional<Colouring>& colouring = job.file_options.colouring;
    return colouring && colouring_row(*colouring).needs == need;
}

bool has_mesh_kind(const Job& job, plane::MeshKind kind) {
    return std::find(job.meshes.begin(), job.meshes.end(), kind) != job.meshes.end();
}

/// Whether walls across an axis meet a property of that axis.
template <class OfAxis>
bool across_walls(const Job& job, const OfAxis& of_axis) {
    return (has_walls_across(job.walls, 0) && of_axis(0)) ||
           (has_walls_across(job.walls, 1) && of_axis(1));
}

template <bool FormatChoices::*kMember>
bool takes(const Format& format, bool in_space) {
    return format.choices(in_space).*kMember;
}

constexpr std::array kFeatures{
    FeatureRow{.feature = F::kRetry,
               .option = "--retry",
               .is_chosen = [](const Job& job) { return job.retries > 0; }},
    FeatureRow{.feature = F::kGivenSites,
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.n_given() > 0; }},
    FeatureRow{.feature = F::kPlaneLattice, .fields = "lattice"},
    FeatureRow{.feature = F::kObliqueLattice,
               .is_chosen =
                   [](const Job& job) {
                       return !job.is_in_space() && !is_upright(job.in_plane().lattice);
                   }},
    FeatureRow{
        .feature = F::kSpaceLattice, .fields = "lattice3", .in_plane = false, .in_space = true},
    FeatureRow{.feature = F::kSymmetry,
               .option = "--symmetry",
               .fields = "symmetry",
               .is_chosen = [](const Job& job) { return job.symmetry.has_value(); }},
    FeatureRow{.feature = F::kOrigin, .option = "--origin", .fields = "origin", .in_space = true},
    FeatureRow{.feature = F::kFoundOrigin, .fields = "find_origin", .in_space = true},
    FeatureRow{
        .feature = F::kSpaceOrigin, .fields = "origin_z", .in_plane = false, .in_space = true},
    FeatureRow{.feature = F::kOriginOffWalls,
               .is_chosen =
                   [](const Job& job) {
                       return job.tile.finds_origin || across_walls(job, [&](int axis) {
                                  return job.in_plane().origin[axis] != 0;
                              });
                   }},
    FeatureRow{.feature = F::kDensity,
               .option = "--density",
               .fields = "density_source density density_data",
               .is_chosen = [](const Job& job) { return job.density.has_value(); }},
    FeatureRow{.feature = F::kDensityRange, .option = "--density-range", .fields = "density_range"},
    FeatureRow{
        .feature = F::kAreas,
        .option = "--areas",
        .fields = "areas n_areas area_law",
        .is_chosen = [](const Job& job) { return !job.is_in_space() && job.sizes.has_value(); }},
    FeatureRow{
        .feature = F::kVolumes,
        .option = "--volumes",
        .fields = "volumes n_volumes volume_law",
        .in_plane = false,
        .in_space = true,
        .is_chosen = [](const Job& job) { return job.is_in_space() && job.sizes.has_value(); }},
    FeatureRow{.feature = F::kWeights,
               .option = "--weights",
               .fields = "weights n_weights",
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.weights.has_value(); }},
    FeatureRow{.feature = F::kCentroids,
               .option = "--centroids",
               .fields = "sites_are_centroids",
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.centroids.has_value(); }},
    FeatureRow{.feature = F::kAspect,
               .option = "--aspect",
               .fields = "aspect",
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.aspect.has_value(); }},
    FeatureRow{.feature = F::kPlaneAspect, .fields = "aspect_degrees"},
    FeatureRow{
        .feature = F::kSpaceAspect, .fields = "aspect_axis", .in_plane = false, .in_space = true},
    FeatureRow{.feature = F::kHasWalls,
               .option = "--walls",
               .fields = "walls",
               .is_chosen = [](const Job& job) { return job.walls != Walls::kNone; }},
    FeatureRow{.feature = F::kHalfCells,
               .option = "--wall-cells",
               .fields = "wall_cells",
               .is_chosen = [](const Job& job) { return job.wall_cells == WallCells::kHalf; }},
    FeatureRow{.feature = F::kFixed,
               .option = "--fixed",
               .fields = "fixed_sites n_fixed_sites",
               .is_chosen = [](const Job& job) { return job.n_fixed() > 0; }},
    FeatureRow{.feature = F::kInclusions,
               .option = "--inclusions",
               .fields = "inclusions",
               .is_chosen = [](const Job& job) { return job.inclusions.has_value(); }},
    FeatureRow{.feature = F::kFibres,
               .option = "--fibres",
               .fields = "fibres",
               .is_chosen = [](const Job& job) { return job.fibres.has_value(); }},
    FeatureRow{.feature = F::kHoles,
               .option = "--hole",
               .fields = "holes",
               .is_chosen = [](const Job& job) { return !job.holes.empty(); }},
    FeatureRow{
        .feature = F::kStartNotRandom,
        .in_space = true,
        .is_chosen = [](const Job& job) { return job.start && *job.start != Start::kRandom; }},
    FeatureRow{.feature = F::kStartAtLattice,
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.start == Start::kLattice; }},
    FeatureRow{
        .feature = F::kStartWithEqualCells,
        .in_space = true,
        .is_chosen = [](const Job& job) { return job.start && !start_row(*job.start).with_sizes; }},
    FeatureRow{.feature = F::kBudget, .option = "--budget", .fields = "budget"},
    FeatureRow{.feature = F::kSolver,
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.run.solver != RunOptions().solver; }},
    FeatureRow{.feature = F::kNoIterations,
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.run.max_iterations == 0; }},
    FeatureRow{.feature = F::kStability,
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.stability; }},
    FeatureRow{.feature = F::kPhases,
               .option = "--phases",
               .fields = "phases site_phases n_site_phases",
               .in_space = true,
               .is_chosen = [](const Job& job) { return !job.materials.phases.empty(); },
               .in_files = "phases",
               .taken = takes<&FormatChoices::phases>},
    FeatureRow{.feature = F::kOrientations,
               .option = "--orientations",
               .fields = "orientations n_orientations random_orientations orientation_weights",
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.materials.has_orientations(); },
               .in_files = "orientations",
               .taken = takes<&FormatChoices::orientations>},
    FeatureRow{.feature = F::kMaterials,
               .option = "--material",
               .fields = "materials",
               .in_space = true,
               .is_chosen = [](const Job& job) { return !job.file_options.elastic.empty(); },
               .in_files = "elastic constants",
               .taken = takes<&FormatChoices::constants>},
    FeatureRow{
        .feature = F::kDelaunay,
        .in_space = true,
        .is_chosen = [](const Job& job) { return has_mesh_kind(job, plane::MeshKind::kDelaunay); }},
    FeatureRow{
        .feature = F::kOutline,
        .option = "--outline",
        .fields = "outline",
        .in_space = true,
        .is_chosen = [](const Job& job) { return job.tile.outline == plane::Outline::kBox; }},
    FeatureRow{.feature = F::kGrainSize,
               .option = "--size",
               .fields = "grain_size",
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.tile.grain_size > 0; }},
    FeatureRow{.feature = F::kGrainPerEdge,
               .option = "--per-edge",
               .fields = "grain_per_edge",
               .is_chosen = [](const Job& job) { return job.tile.grain_per_edge > 0; }},
    FeatureRow{
        .feature = F::kOrder, .option = "--order", .fields = "grain_order", .in_space = true},
    FeatureRow{
        .feature = F::kRepeat, .option = "--repeat", .fields = "columns rows", .in_space = true},
    FeatureRow{
        .feature = F::kRepeatLayers, .fields = "layers", .in_plane = false, .in_space = true},
    FeatureRow{.feature = F::kRepeatAcrossWalls,
               .is_chosen =
                   [](const Job& job) {
                       return across_walls(job, [&](int axis) {
                           return (axis == 0 ? job.tile.repeat.columns : job.tile.repeat.rows) > 1;
                       });
                   }},
    FeatureRow{
        .feature = F::kShortEdgesInSpace,
        .in_plane = false,
        .in_space = true,
        .is_chosen = [](const Job& job) { return job.is_in_space() && job.tile.short_edges > 0; }},
    FeatureRow{.feature = F::kTable, .option = "--cells", .in_space = true},
    FeatureRow{.feature = F::kColour,
               .option = "--colour",
               .fields = "colour",
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.file_options.colouring.has_value(); },
               .in_files = "a colouring",
               .taken = takes<&FormatChoices::colouring>},
    FeatureRow{.feature = F::kColourByDensity,
               .is_chosen = [](const Job& job) { return shows(job, ColouringNeed::kDensity); }},
    FeatureRow{.feature = F::kColourByPhase,
               .in_space = true,
               .is_chosen = [](const Job& job) { return shows(job, ColouringNeed::kPhases); }},
    FeatureRow{.feature = F::kColourByOrbit,
               .is_chosen = [](const Job& job) { return shows(job, ColouringNeed::kOrbits); }},
    FeatureRow{.feature = F::kColourByTag,
               .is_chosen = [](const Job& job) { return shows(job, ColouringNeed::kTags); }},
    FeatureRow{
        .feature = F::kColourByOrientation,
        .in_space = true,
        .is_chosen = [](const Job& job) { return shows(job, ColouringNeed::kOrientations); }},
    FeatureRow{.feature = F::kColourOfSpace,
               .in_space = true,
               .is_chosen =
                   [](const Job& job) {
                       const auto& colouring = job.file_options.colouring;
                       return !job.is_in_space() && colouring &&
                              !colouring_row(*colouring).in_plane;
                   }},
    FeatureRow{.feature = F::kBackground,
               .option = "--background",
               .fields = "background",
               .is_chosen = [](const Job& job) { return job.file_options.background.has_value(); },
               .in_files = "a background",
               .taken = takes<&FormatChoices::background>},
    FeatureRow{.feature = F::kGlbNodes,
               .option = "--glb-nodes",
               .fields = "gltf_nodes",
               .is_chosen =
                   [](const Job& job) { return job.file_options.gltf_nodes != GltfNodes::kBySize; },
               .in_files = "glTF nodes",
               .taken = takes<&FormatChoices::gltf_nodes>},
    FeatureRow{.feature = F::kSinglePrecision,
               .option = "--float32",
               .fields = "single_precision",
               .is_chosen = [](const Job& job) { return job.file_options.single_precision; },
               .in_files = "32-bit coordinates",
               .taken = takes<&FormatChoices::single_precision>},
    FeatureRow{.feature = F::kPixels,
               .option = "--pixels",
               .fields = "pixels",
               .is_chosen = [](const Job& job) { return job.file_options.pixels != 0; },
               .in_files = "a number of pixels",
               .taken = takes<&FormatChoices::pixels>},
    FeatureRow{
        .feature = F::kVoxels,
        .option = "--voxels",
        .fields = "voxels voxel_layers",
        .in_space = true,
        .is_chosen = [](const Job& job) { return job.file_options.voxels != plane::VoxelCounts{}; },
        .in_files = "a number of voxels",
        .taken = takes<&FormatChoices::voxels>},
    FeatureRow{.feature = F::kCoriolis,
               .option = "--coriolis",
               .fields = "coriolis",
               .is_chosen = [](const Job& job) { return job.file_options.coriolis.has_value(); },
               .in_files = "a Coriolis parameter",
               .taken = takes<&FormatChoices::coriolis>},
    FeatureRow{.feature = F::kCut,
               .option = "--cut",
               .fields = "cut_width",
               .is_chosen = [](const Job& job) { return job.file_options.cut_width != 0; },
               .in_files = "a width to cut",
               .taken = takes<&FormatChoices::cut_width>},
    FeatureRow{.feature = F::kElement,
               .option = "--element",
               .fields = "element",
               .is_chosen =
                   [](const Job& job) { return job.file_options.element != PlaneElement::kStrain; },
               .in_files = "a type of elements",
               .taken = takes<&FormatChoices::element>},
    FeatureRow{.feature = F::kSolverJob,
               .option = "--job",
               .fields = "job",
               .in_space = true,
               .is_chosen = [](const Job& job) { return job.file_options.job != SolverJob::kNone; },
               .in_files = "a job of a solver",
               .taken = takes<&FormatChoices::job>},
    FeatureRow{.feature = F::kThickness,
               .option = "--thickness",
               .fields = "thickness",
               .is_chosen = [](const Job& job) { return job.file_options.thickness != 0; },
               .in_files = "a thickness",
               .taken = takes<&FormatChoices::thickness>,
               .held = [](const Format& format,
                          const FileOptions& options) { return format.holds_thickness(options); },
               .held_by = "take the elements C3D6 or C3D15 of .inp"},
    FeatureRow{
        .feature = F::kSurface,
        .option = "--surface",
        .fields = "surface",
        .in_plane = false,
        .in_space = true,
        .is_chosen =
            [](const Job& job) { return job.file_options.surfaces == SurfaceForm::kBoundary; },
        .taken = [](const Format& format, bool) { return format.has_surfaces(); }}};

}  // namespace

std::span<const FeatureRow> features() { return kFeatures; }

const FeatureRow* find_option(std::string_view option) {
    return find_row(kFeatures, [&](const FeatureRow& row) { return row.option == option; });
}

}  // namespace pcvt
