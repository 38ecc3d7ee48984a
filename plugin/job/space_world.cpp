#include "plugin/job/space_world.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "io/formats/file_proof.hpp"
#include "io/formats/space_file_proof.hpp"
#include "io/run_files/site_writer.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/box/box_origin.hpp"
#include "mesher/space/search/lattice_pattern.hpp"
#include "mesher/space/tessellation/repeated_cells.hpp"
#include "mesher/space/voxels/voxel_image.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/job_tessellation.hpp"
#include "plugin/job/job_tiles.hpp"
#include "plugin/job/space_box.hpp"
#include "plugin/job/space_start.hpp"

namespace pcvt {
namespace {

/// The target volumes, one a site, length^3.
Eigen::VectorXd target_volumes(const Job& job) {
    const auto& [law, given, name] = *job.sizes;
    const int n = job.n_wanted();
    return scaled_volumes(given.size() > 0 ? given : draw_volumes(law, n, job.seed), n,
                          job.in_space().lattice.volume());
}

/// The centroidal steps of cells with prescribed volumes where the user states none: five make
/// grains as round as grown ones.
constexpr int kCentroidalSteps = 5;

space::VolumeCvtOptions volume_options(const Job& job, RunOptions run, JobMonitor& monitor) {
    if (run.max_iterations < 0 && !job.centroids) run.max_iterations = kCentroidalSteps;
    // Volumes of a law belong to no particular site.
    const bool are_free = job.n_given() == 0 && job.sizes->is_drawn();
    return {.volumes = target_volumes(job),
            .by_rank = are_free && run.max_iterations > 0,
            .run = std::move(run),
            .newton_progress = [&monitor](const SizeFigures& volumes) {
                monitor.newton_step(volumes.newton_steps, volumes.largest_relative_error);
            }};
}

space::Tessellation tessellate(const Job& job, const space::Points& points, const RunOptions& run,
                               JobMonitor& monitor) {
    const space::Lattice& lattice = job.in_space().lattice;
    if (job.weights) {
        return space::Tessellation(weighted_cells(lattice, points, job.weights->values, run));
    }
    if (job.sizes) {
        const space::VolumeCvtOptions options = volume_options(job, run, monitor);
        return job.centroids
                   ? space::Tessellation(fit_volumes_and_centroids(lattice, points, options))
                   : space::Tessellation(compute_volume_cvt(lattice, points, options));
    }
    return space::Tessellation(compute_cvt(lattice, points, {run}));
}

/// Requires that the boundary is a closed surface, if a file shows it.
void require_closed_boundary(const Job& job, const std::vector<JobFile>& files,
                             const space::PolyhedralProof& proof) {
    if (proof.boundary_is_manifold) return;
    for (const JobFile& file : files) {
        if (!file.format->space->shows_boundary(job.file_options.surfaces)) continue;
        throw InvalidInput(
            "-o " + file.path() +
            ": the boundary of this tile touches itself, so that it is not a surface; "
            "take the surfaces of the cells as .obj, .ply or .glb, or other sites");
    }
}

/// Requires a file that states the materials of a job whose other files hold Delaunay tetrahedra,
/// which state none.
void require_materials_held(const Job& job, const std::vector<JobFile>& files) {
    if (job.materials.empty() || files.empty() || job.meshes.front() == plane::MeshKind::kGrains) {
        return;
    }
    const bool is_held = std::any_of(files.begin(), files.end(), [&](const JobFile& file) {
        const SpaceFormat& format = *file.format->space;
        return !format.shows_tetrahedra(job.meshes.front()) &&
               (format.takes.phases || format.takes.orientations);
    });
    if (is_held) return;
    throw InvalidInput(
        "Delaunay tetrahedra are not cells, which phases and orientations belong to; take --mesh "
        "grains, or add .csv or .vti");
}

/// What the files of a job hold.
struct SpaceContent {
    const SpaceTile& tile;
    const Computation<SpaceWorld>& computation;
    /// The sites in the domain, 3 x n, for files that hold no tile.
    space::Points points;
    /// For files of tetrahedra; nothing if there is none.
    std::optional<space::TetrahedralMesh> tetrahedra;
    /// Those of the cells of all periods; the tile has those of its pieces.
    CellMaterials materials;
    const Job& job;

    plane::MeshKind mesh() const { return job.meshes.front(); }

    std::vector<EncodedFile> encode(const JobFile& file) const {
        const SpaceFormat& format = *file.format->space;
        if (format.shows_tetrahedra(mesh())) {
            FileOptions options = job.file_options;
            options.materials = materials_of_tetrahedra();
            return format.encode_tetrahedra(tetrahedra.value(), options, file.path());
        }
        if (format.encode != nullptr) {
            return format.encode(tile, job.file_options, file.path());
        }
        if (format.encode_voxels != nullptr) return encode_voxels(file);
        if (const auto* const write = std::get_if<CellWriter*>(&file.format->write)) {
            return (*write)(rows(), file.path());
        }
        return only_file(file.path(), encode_sites(points));
    }

    void prove(const JobFile& file, const std::vector<EncodedFile>& encoded) const {
        const SpaceFormat& format = *file.format->space;
        if (format.is_picture()) return;
        if (format.shows_tetrahedra(mesh())) {
            prove_own_tetrahedra(encoded, tetrahedra.value(), materials_of_tetrahedra());
        } else if (format.encode != nullptr) {
            prove_own_space_files(encoded, tile);
        } else if (file.format->reads_voxels()) {
            prove_voxel_files(*file.format, encoded, computation.materials);
        } else if (file.format->reads_cells()) {
            prove_cell_files(*file.format, encoded, rows());
        } else {
            prove_space_site_file(encoded.front(), points);
        }
    }

   private:
    /// Delaunay tetrahedra have no materials.
    const CellMaterials* materials_of_tetrahedra() const {
        const bool are_stated = mesh() == plane::MeshKind::kGrains && !materials.empty();
        return are_stated ? &materials : nullptr;
    }

    std::vector<EncodedFile> encode_voxels(const JobFile& file) const {
        const SpaceDomain& domain = job.in_space();
        const space::PeriodicDelaunay& delaunay = computation.cells.delaunay;
        const space::Lattice whole = repeated_lattice(domain.lattice, job.tile.repeat);
        const VoxelCounts counts = requested_voxels(
            whole, delaunay.sites.n_sites() * job.tile.repeat.n_copies(), job.file_options.voxels);
        const space::Metric metric = computation.cells.metric();
        const space::Vec3 origin = tile_origin(job, computation.cells);
        const space::VoxelImage image =
            voxel_image(delaunay, delaunay.weights, voxel_grid(whole, origin, counts),
                        job.run.n_threads, metric);
        const space::VoxelCells cells{.lattice = domain.lattice,
                                      .sites = points,
                                      .weights = delaunay.weights,
                                      .metric = metric};
        return file.format->space->encode_voxels(image, cells, computation.materials,
                                                 job.file_options.elastic, file.path());
    }

    CellRows rows() const {
        return {.sites = points,
                .cells = computation.cells.table(),
                .weights = computation.cells.delaunay.weights,
                .materials = computation.materials};
    }
};

/// Maps the cells and the pattern of a run in the round space of a metric back.
void elongate(const space::Metric& metric, const space::Lattice& lattice,
              space::Tessellation& cells, StartFigures& figures) {
    cells.elongation = space::Elongation{metric, metric.from_round(cells.delaunay.sites, lattice)};
    if (!figures.pattern) return;
    for (auto vector : figures.pattern->basis.colwise()) {
        vector = metric.from_round(space::Vec3(vector));
    }
}

}  // namespace

void SpaceWorld::check_files(const Job& job, const std::vector<JobFile>& files,
                             const std::vector<std::string>& phases) {
    check_order(job, files);
    check_file_options(job, files, phases);
    require_materials_held(job, files);
}

Computation<SpaceWorld> SpaceWorld::compute(const Job& job, JobMonitor& monitor, Stopwatch& watch) {
    const space::Metric metric = metric_of(job, job.in_space());
    const std::optional<Job> mapped =
        metric.is_round() ? std::nullopt : std::optional(in_round_space(job, metric));
    const Job& round = mapped ? *mapped : job;
    // Start, optimise, and map back.
    StartFigures figures;
    const space::Points points = space_start_points(round, monitor, figures);
    RunOptions run = job.run;
    run.progress = [&, first = true](const Progress& progress) mutable {
        // The first call comes once the first triangulation is built and evaluated.
        if (std::exchange(first, false)) watch.stop(&JobSeconds::build);
        return monitor.iteration(progress);
    };
    watch.stop(&JobSeconds::optimize);
    space::Tessellation cells = tessellate(round, points, run, monitor);
    watch.stop(&JobSeconds::optimize);
    if (cells.run.stop == Stop::kCancelled) throw Cancelled{};
    if (mapped) elongate(metric, job.in_space().lattice, cells, figures);
    if (job.tile.finds_origin) cells.box_origin = best_box_origin(cells.sites(), cells.complex());
    MaterialsOfCells of_cells;
    if (!job.materials.empty()) {
        of_cells = materials_of_cells(job.materials, cells.table(), job.seed);
    }
    Computation<SpaceWorld> computation{.cells = std::move(cells),
                                        .start = std::move(figures),
                                        .materials = std::move(of_cells.materials),
                                        .phases = std::move(of_cells.phases)};
    watch.stop(&JobSeconds::build);
    computation.seconds = watch.seconds();
    return computation;
}

SpaceWorld::Tiles SpaceWorld::build_tiles(const Job& job, const std::vector<JobFile>& /*files*/,
                                          const Computation<SpaceWorld>& computation,
                                          JobMonitor& monitor) {
    return build_space_tile(job, computation.cells, computation.materials, monitor);
}

FileContent SpaceWorld::content(const Job& job, const std::vector<JobFile>& files,
                                const Computation<SpaceWorld>& computation,
                                const TileSource<SpaceWorld>& tiles, JobMonitor& monitor,
                                RunSummary& summary) {
    const space::PeriodicDelaunay& delaunay = computation.cells.delaunay;
    std::optional<space::TetrahedralMesh> tetrahedra =
        build_tetrahedra(job, computation.cells, files, monitor, summary);
    const ProvedSpaceTile& built = tiles(monitor);
    summary.n_sites = delaunay.sites.n_sites();
    summary.energy_bound =
        space::body_centred_energy(job.in_space().lattice.volume(), summary.n_sites);
    if (computation.cells.volumes) {
        summary.sizes = size_summary(*computation.cells.volumes, computation.cells.table(),
                                     job.sizes->given, job.in_space().lattice.volume());
    }
    summary.centroids = computation.cells.centroids;
    summary.valences = built.face_counts;
    summary.polyhedra = built.figures;
    summary.constants = stated_constants(files, job.file_options, computation.materials);
    require_closed_boundary(job, files, built.figures.proof);
    const auto content = std::make_shared<const SpaceContent>(SpaceContent{
        built.tile, computation,
        wrapped_positions(computation.cells.sites(), tile_origin(job, computation.cells)),
        std::move(tetrahedra), space::repeated_materials(computation.materials, job.tile.repeat),
        job});
    return {.encode = [content](const JobFile& file) { return content->encode(file); },
            .prove =
                [content](const JobFile& file, const std::vector<EncodedFile>& encoded) {
                    content->prove(file, encoded);
                }};
}

}  // namespace pcvt
