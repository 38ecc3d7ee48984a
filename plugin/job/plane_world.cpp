#include "plugin/job/plane_world.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "io/formats/file_proof.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/symmetry/folded_density.hpp"
#include "mesher/plane/tessellation/tags.hpp"
#include "plugin/job/job_start.hpp"
#include "plugin/job/job_tessellation.hpp"
#include "plugin/job/job_tiles.hpp"
#include "plugin/job/version.hpp"

namespace pcvt {
namespace {

/// Evaluated before any file is written, because a host's density ends with its call.
std::vector<double> site_densities(const Job& job, const plane::Tessellation& cells) {
    if (!job.density) return {};
    const plane::Lattice& lattice = job.in_plane().lattice;
    const plane::Density density =
        job.symmetry ? folded_density(*job.density, plane::PlaneGroup(*job.symmetry, lattice))
                     : *job.density;
    return densities_at(density, lattice, wrapped_sites(cells, job.in_plane().origin));
}

/// Encodes the files of a job, each in the form that its format writes, and proves them.
class PlaneContent {
   public:
    PlaneContent(const Job& job, const Computation<PlaneWorld>& computation,
                 const std::vector<plane::BuiltTile>& tiles)
        : job_(job), computation_(computation), tiles_(tiles) {}

    std::vector<EncodedFile> encode(const JobFile& file) const {
        return std::visit([&](auto write) { return encode(file, write); }, file.format->write);
    }

    void prove(const JobFile& file, const std::vector<EncodedFile>& encoded) const {
        const Format& format = *file.format;
        if (format.reads_grid()) {
            prove_grid_files(format, encoded);
        } else if (format.reads_sites()) {
            prove_site_files(format, encoded, sites());
        } else if (format.reads_cells()) {
            prove_cell_files(format, encoded, cell_rows());
        } else if (format.reads_voxels()) {
            prove_voxel_files(format, encoded, computation_.materials);
        } else if (format.is_readable()) {
            prove_tile_files(format, encoded, tile(file), job_.in_plane().origin,
                             tile_options(file));
        }
    }

   private:
    /// add_output() has refused formats that hold only tiles in space.
    std::vector<EncodedFile> encode(const JobFile&, std::monostate) const { return {}; }
    std::vector<EncodedFile> encode(const JobFile& file, TileWriter* write) const {
        return write(tile(file), file.path());
    }
    std::vector<EncodedFile> encode(const JobFile& file, TileFormWriter* write) const {
        return write(tile(file), tile_options(file), file.path());
    }
    std::vector<EncodedFile> encode(const JobFile& file, TorusWriter* write) const {
        const plane::PeriodicMesh cells =
            repeated(computation_.cells.mesh(plane::MeshKind::kVoronoi), job_.tile.repeat.columns,
                     job_.tile.repeat.rows);
        const Torus torus{.cells = cells,
                          .origin = job_.in_plane().origin,
                          .site_densities = computation_.site_densities,
                          .history = history()};
        try {
            return write(torus, job_.file_options, file.path());
        } catch (const UnsuitableCells& error) {
            throw UnsuitableCells("-o " + file.path() + ": " + error.what());
        } catch (const InvalidInput& error) {
            throw InvalidInput("-o " + file.path() + ": " + error.what());
        }
    }
    std::vector<EncodedFile> encode(const JobFile& file, SiteWriter* write) const {
        return write(sites(), file.path());
    }
    std::vector<EncodedFile> encode(const JobFile& file, CellWriter* write) const {
        return write(cell_rows(), file.path());
    }
    std::vector<EncodedFile> encode(const JobFile& file, VoxelWriter* write) const {
        const plane::VoxelCounts counts = requested_voxels(format_request(job_));
        const plane::Lattice& lattice = job_.in_plane().lattice;
        const plane::VoxelGrid grid =
            voxel_grid(lattice.repeated(job_.tile.repeat.columns, job_.tile.repeat.rows),
                       job_.in_plane().origin, counts);
        const auto& elongation = computation_.cells.elongation;
        const plane::VoxelCells cells{.lattice = lattice,
                                      .sites = sites(),
                                      .weights = site_weights(computation_.cells),
                                      .metric = elongation ? elongation->metric : plane::Metric()};
        return write(
            voxel_image(computation_.cells.delaunay, cells.metric, grid, job_.run.n_threads), cells,
            computation_.materials, job_.file_options.elastic, file.path());
    }

    CellRows cell_rows() const {
        return {.sites = sites(),
                .cells = cells(),
                .weights = site_weights(computation_.cells),
                .materials = computation_.materials,
                .phases_are_tags = job_.has_inclusions(),
                .orbits = computation_.cells.site_orbits};
    }
    /// The measures of the cells, which are freed: tiles are made before files.
    CellTable cells() const {
        CellTable table = table_outside_holes(computation_.cells);
        computation_.cells.drop_cells();
        return table;
    }
    /// The run as files state it: equal for equal results.
    std::string history() const {
        return std::string("pcvt ") + version() + (job_.command.empty() ? "" : ": ") +
               job_.command + "; seed " + std::to_string(job_.seed);
    }
    FileOptions tile_options(const JobFile& file) const {
        FileOptions options = job_.file_options;
        options.site_densities = computation_.site_densities;
        options.site_orbits = computation_.cells.site_orbits;
        // Delaunay triangles have no materials where files state those of cells.
        const bool are_cells = faces_have_sites(tile(file).kind) || !file.format->states_materials;
        if (are_cells && !computation_.materials.empty()) {
            options.materials = &computation_.materials;
        }
        // The materials and groups of files are the tags.
        if (job_.has_inclusions() && !options.colouring) options.colouring = Colouring::kTag;
        return options;
    }
    plane::Points sites() const {
        return wrapped_sites(computation_.cells, job_.in_plane().origin);
    }
    const plane::Tile& tile(const JobFile& file) const {
        return tiles_[static_cast<std::size_t>(file.mesh)].tile;
    }

    const Job& job_;
    const Computation<PlaneWorld>& computation_;
    const std::vector<plane::BuiltTile>& tiles_;
};

}  // namespace

void PlaneWorld::check_files(const Job& job, const std::vector<JobFile>& files,
                             const std::vector<std::string>& phases) {
    check_order(job, files);
    check_file_options(job, files, phases);
}

Computation<PlaneWorld> PlaneWorld::compute(const Job& job, JobMonitor& monitor, Stopwatch& watch) {
    const plane::Metric metric = metric_of(job, job.in_plane());
    const std::optional<Job> round =
        metric.is_round() ? std::nullopt : std::optional(in_round_space(job, metric));
    // Start, optimise, and map back.
    JobStart start = job_start(round ? *round : job, [&monitor](const Progress& progress) {
        return monitor.start_iteration(progress);
    });
    if (start.cancelled) throw Cancelled{};
    watch.stop(&JobSeconds::optimize);
    plane::Tessellation cells = tessellate(round ? *round : job, start, monitor,
                                           [&watch] { watch.stop(&JobSeconds::build); });
    watch.stop(&JobSeconds::optimize);
    if (cells.run.stop == Stop::kCancelled) throw Cancelled{};
    cells.run.evaluations += start.evaluations;
    if (round) {
        cells.elongation = plane::Elongation{metric, job.in_plane().lattice};
        if (auto& pattern = start.figures.pattern) {
            for (auto vector : pattern->basis.colwise()) {
                vector = metric.from_round(plane::Vec2(vector));
            }
        }
    }
    std::vector<double> densities = site_densities(job, cells);
    MaterialsOfCells of_sites = materials_of_sites(cells, job.materials, job.seed);
    Computation<PlaneWorld> computation{.cells = std::move(cells),
                                        .start = std::move(start.figures),
                                        .site_densities = std::move(densities),
                                        .materials = std::move(of_sites.materials),
                                        .phases = std::move(of_sites.phases)};
    watch.stop(&JobSeconds::build);
    computation.seconds = watch.seconds();
    return computation;
}

PlaneWorld::Tiles PlaneWorld::build_tiles(const Job& job, const std::vector<JobFile>& files,
                                          const Computation<PlaneWorld>& computation,
                                          JobMonitor& monitor) {
    if (!needs_tiles(job, files)) return {};
    return proved_tiles(job, computation.cells, monitor);
}

FileContent PlaneWorld::content(const Job& job, const std::vector<JobFile>& files,
                                const Computation<PlaneWorld>& computation,
                                const TileSource<PlaneWorld>& tiles, JobMonitor& monitor,
                                RunSummary& summary) {
    const Tiles& built = tiles(monitor);
    for (const plane::BuiltTile& tile : built) summary.tiles.push_back(tile.figures);
    summary.constants = stated_constants(files, job.file_options, computation.materials);
    // Add the figures of the cells.
    const plane::Tessellation& cells = computation.cells;
    summary.n_sites = cells.n_sites();
    if (!cells.density) summary.energy_bound = energy_bound(cells);
    summary.n_mirrors = cells.counts.n_mirrors;
    summary.valences = side_counts(cells);
    summary.density = cells.density;
    if (cells.areas) {
        summary.sizes =
            size_summary(*cells.areas, cells.table(), job.sizes->given, cells.lattice().area());
    }
    summary.centroids = cells.centroids;
    summary.n_orbits = cells.n_orbits();
    if (cells.walled) summary.n_on_walls = cells.walled->n_on_walls;
    summary.interfaces = cells.interfaces;
    const auto content = std::make_shared<const PlaneContent>(job, computation, built);
    return {.encode = [content](const JobFile& file) { return content->encode(file); },
            .prove =
                [content](const JobFile& file, const std::vector<EncodedFile>& encoded) {
                    content->prove(file, encoded);
                }};
}

}  // namespace pcvt
