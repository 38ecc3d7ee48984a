#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/bytes/file_fields.hpp"
#include "io/formats/space_format.hpp"
#include "io/forms/file_options.hpp"
#include "io/forms/tile_file.hpp"
#include "io/run_files/cell_writer.hpp"
#include "io/voxels/vti_reader.hpp"
#include "mesher/finite_volume/mpas_grid.hpp"
#include "mesher/plane/mesh/tile_options.hpp"

namespace pcvt {

/// The Voronoi cells of a whole torus, for formats that hold a staggered grid.
struct Torus {
    const plane::PeriodicMesh& cells;
    /// Corner of the domain in which the points are written.
    plane::Vec2 origin;
    /// The density at each site; empty where it is uniform.
    std::span<const double> site_densities;
    /// The run that made the cells; may be empty.
    std::string history = {};
};

using TileWriter = std::vector<EncodedFile>(const plane::Tile& tile, const std::string& path);
/// Writes a tile in one of several forms, which the options choose.
using TileFormWriter = std::vector<EncodedFile>(const plane::Tile& tile, const FileOptions& options,
                                                const std::string& path);
using TorusWriter = std::vector<EncodedFile>(const Torus& torus, const FileOptions& options,
                                             const std::string& path);
using SiteWriter = std::vector<EncodedFile>(const plane::Points& sites, const std::string& path);
/// Writes measures of the cells at the sites.
using CellWriter = std::vector<EncodedFile>(const CellRows& rows, const std::string& path);

/// Writes the cells as voxels, with the phases, orientations and elastic constants of the cells.
using VoxelWriter = std::vector<EncodedFile>(const plane::VoxelImage& image,
                                             const plane::VoxelCells& cells,
                                             const CellMaterials& materials,
                                             const ElasticChoices& elastic,
                                             const std::string& path);

using TileReader = TileFile(const std::vector<EncodedFile>& files,
                            const std::optional<plane::Lattice>& lattice);
using GridReader = MpasGrid(const std::vector<EncodedFile>& files);
using VoxelReader = VoxelFile(const std::vector<EncodedFile>& files);
/// Whether `files` read back as exactly these sites.
using SiteReader = bool(const std::vector<EncodedFile>& files, const plane::Points& sites);
/// Whether `files` read back as exactly these rows.
using CellReader = bool(const std::vector<EncodedFile>& files, const CellRows& rows);

/// The content of a file, known before anything is computed.
struct FormatRequest {
    /// The lattice of the tile or torus, repetitions included.
    plane::Lattice lattice;
    /// How the tile of the file is made.
    plane::TileOptions tile = {};
    /// The number of sites of one period.
    double n_sites = 1;
    Walls walls = Walls::kNone;
    bool has_holes = false;
    /// Whether the cells are power cells.
    bool has_weights = false;
    FileOptions files = {};

    /// The number of all sites in `lattice`.
    double n_all_sites() const { return n_sites * tile.repeat.n_copies(); }
    /// The mean distance of the sites.
    double spacing() const;
};

/// The voxels of a request, or the default.
/// @throws InvalidInput, LimitExceeded as voxel_grid() does.
plane::VoxelCounts requested_voxels(const FormatRequest& request);
/// The same in space.
/// @param counts  those of FileOptions.
/// @throws InvalidInput, LimitExceeded as space::voxel_grid() does.
VoxelCounts requested_voxels(const space::Lattice& lattice, double n_sites, VoxelCounts counts);

/// Bytes of a run that writes one file of a format: a site for cells, the whole torus, or no mesh
/// at all; a Delaunay triangle; and a triangle of grains. Measured at 5e4 to 1e7 sites.
struct FormatMemory {
    double cell;
    double triangle;
    double grain;
};

/// One row of the table of formats.
///
/// Example usage:
///   const Format* format = find_format("tile.obj");
///   for (const EncodedFile& file : encode_tile(*format, tile, "tile.obj")) {
///       outputs.stage(file.path, file.bytes);
///   }
struct Format {
    /// With the dot: ".obj".
    std::string_view extension;
    std::string_view description;
    /// What the summary says of its files: what they cannot hold.
    std::string_view note = {};
    /// Encodes the content of the format, which is a tile, the torus, the sites, the cells or their
    /// voxels: one entry per path. Empty if the format holds only tiles in space.
    std::variant<std::monostate, TileWriter*, TileFormWriter*, TorusWriter*, SiteWriter*,
                 CellWriter*, VoxelWriter*>
        write = {};
    /// Reads `files` (the file itself first, companions where there are any) back; a lattice
    /// replaces one that the file lacks. Empty if pcvt does not read the format.
    std::variant<std::monostate, TileReader*, GridReader*, SiteReader*, CellReader*, VoxelReader*>
        read = {};
    /// Returns the labels, groups and other fields of a file, which are compared with those that
    /// `write` gives for the tile in the file; nullptr if the tile is all that the format holds.
    FieldReader* fields = nullptr;
    bool holds_sites = true;
    /// The paths that `write` fills for a path, the file itself first; of a folder those in it.
    std::vector<std::string> (*paths)(const std::string& path) = single_path;
    bool is_folder = false;
    bool holds_polygons = true;
    /// 2: the nodes in the middle of edges are written, where the tile has them.
    int highest_order = 1;
    /// Throws InvalidInput with the reason if the format cannot hold the request; nullptr if it
    /// holds every request.
    void (*check)(const FormatRequest& request) = nullptr;
    /// Whether positions are 32-bit floats, and whether those of a distant tile are relative to
    /// whole periods near it.
    bool is_single_precision = false;
    bool moves_distant_tiles = false;
    /// Refuses a path that the programs for this format cannot open; nullptr if they open any.
    /// Throws InvalidInput.
    void (*check_path)(const std::string& path) = nullptr;
    /// The choices that the format takes for a tile in the plane.
    FormatChoices takes = {};
    /// The file of a tile states the phases, and the orientations that the format takes, of its
    /// cells; the reader reads them.
    bool states_materials = false;
    /// The file of a tile states the orbit of the site of each element; the reader reads them.
    bool states_orbits = false;
    FormatMemory memory;
    /// The part of a tile in space that the format holds; `nullopt`: nothing.
    std::optional<SpaceFormat> space = {};

    /// The choices that the format takes in a dimension.
    FormatChoices choices(bool in_space) const {
        if (!in_space) return takes;
        return space ? space->takes : FormatChoices();
    }
    /// Whether its files hold the job of a solver.
    bool holds_job(const FileOptions& options) const {
        return takes.job && options.job != SolverJob::kNone;
    }
    /// Whether its files state the elastic constants that the options choose.
    bool states_constants(const FileOptions& options) const {
        return takes.constants && (!takes.job || holds_job(options));
    }
    /// Whether its files of a tile in the plane have a height along z.
    bool holds_thickness(const FileOptions& options) const {
        return takes.thickness && (!takes.element || are_wedges(options.element));
    }
    /// Whether its files of space hold the surfaces that an option chooses.
    bool has_surfaces() const {
        return space.has_value() && space->surfaces == FormatSurfaces::kChosen;
    }
    bool holds_single_precision(const FileOptions& options) const {
        return is_single_precision || (takes.single_precision && options.single_precision);
    }
    bool needs_torus() const { return std::holds_alternative<TorusWriter*>(write); }
    bool needs_tile() const {
        return std::holds_alternative<TileWriter*>(write) ||
               std::holds_alternative<TileFormWriter*>(write);
    }
    bool is_only_in_space() const { return std::holds_alternative<std::monostate>(write); }
    /// Whether `pcvt check` proves the file: it holds a tile, a grid or voxels.
    bool is_readable() const {
        return is_only_in_space() || reads_grid() || reads_voxels() ||
               std::holds_alternative<TileReader*>(read);
    }
    bool reads_sites() const { return std::holds_alternative<SiteReader*>(read); }
    bool reads_cells() const { return std::holds_alternative<CellReader*>(read); }
    bool reads_voxels() const { return std::holds_alternative<VoxelReader*>(read); }
    bool reads_grid() const { return std::holds_alternative<GridReader*>(read); }
};

/// The order of the rows is that of the extensions in messages.
std::span<const Format> formats();

/// The bytes of a tile in a format.
/// @pre format.needs_tile().
std::vector<EncodedFile> encode_tile(const Format& format, const plane::Tile& tile,
                                     const std::string& path, const FileOptions& options = {});

/// The tile in the files of a format.
/// @pre format.is_readable(), and neither format.reads_grid() nor format.reads_voxels().
TileFile decode_tile(const Format& format, const std::vector<EncodedFile>& files,
                     const std::optional<plane::Lattice>& lattice);

/// The row for the extension of `path` (case does not matter), nullptr if there is none.
const Format* find_format(const std::string& path);
/// The row of the format of these files: that of a folder by what they hold, any other by the
/// extension of the first file. nullptr if there is none.
const Format* find_format(const std::vector<EncodedFile>& files);

/// Returns the extensions of formats that hold tiles in space: ".obj, .ply, ... or .txt".
std::string space_extensions();
/// Returns those that show tetrahedra of this mesh, ".msh, .inp or .vtu".
std::string tetrahedra_extensions(plane::MeshKind mesh);
/// Returns those that state PolyhedralMesh::short_edges, ".vtu or .foam".
std::string short_edges_extensions();
/// Returns those that take power cells, ".vtu, .csv or .txt".
std::string weight_extensions();
/// Returns those that take elongated cells.
std::string metric_extensions();
/// Returns those whose form FileOptions::surfaces chooses, ".obj, .ply or .glb".
std::string surface_extensions();

/// Returns the kind of these files, as `pcvt check` reads them; nothing if they do not hold a tile
/// in space.
std::optional<SpaceFileKind> space_file_kind(const std::vector<EncodedFile>& files);

}  // namespace pcvt
