#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "io/formats/formats.hpp"
#include "mesher/space/geometry/lattice.hpp"

namespace pcvt {

/// One output of a run, with the companions that its format writes beside it.
struct OutputFile {
    /// The path itself first, then the companions; of a folder the files in it.
    std::vector<std::string> paths;
    const Format* format;
    /// Formats of tiles: the index of the mesh of a run; else -1.
    int mesh = -1;
    /// Empty unless the files lie in a folder of their own.
    std::string folder = {};

    /// The output as messages name it: the folder, or the file itself.
    const std::string& path() const { return folder.empty() ? paths.front() : folder; }
};

/// The content of all files of a run in the plane, known before anything is computed.
struct RunRequest {
    /// The content of each file; its mesh is one of the run's.
    FormatRequest content;
    /// Whether the cells are those of a metric.
    bool has_metric = false;
    /// Whether the cells have phases, tags or orientations.
    bool has_materials = false;
};

/// The same of a run in space.
struct SpaceRequest {
    space::Lattice lattice;
    double short_edges = 0;
    /// 0: not known yet.
    int n_sites = 0;
    /// Whether the cells are power cells.
    bool has_weights = false;
    /// Whether the cells are those of a metric.
    bool has_metric = false;
    /// As FileOptions::voxels.
    VoxelCounts voxels = {};
    /// Whether the tile is a box of pieces of cells.
    bool is_box = false;
};

using OutputRequest = std::variant<RunRequest, SpaceRequest>;

/// Appends the files of an output: in the plane one for each mesh where the format holds a tile,
/// tile-voronoi.obj and tile-grains.obj.
///
/// Example usage:
///   std::vector<OutputFile> files;
///   add_output("tile.obj", request, job.meshes, files);
///   for (const OutputFile& file : files) std::puts(file.path().c_str());
///
/// @param meshes  of the run; in space there is one.
/// @throws InvalidInput, which begins with the path, for an unknown extension, and for a request
///         that the format cannot hold.
void add_output(const std::string& path, const OutputRequest& request,
                std::span<const plane::MeshKind> meshes, std::vector<OutputFile>& files);

/// What the files of the format of an output cannot hold, for a summary; mostly empty.
std::string format_note(const std::string& path);

/// `path` without the slash that shells append to the name of a case folder: t.foam/ -> t.foam.
std::string without_slash(const std::string& path);

/// `path` with `suffix` before its extension: tile.obj, -voronoi -> tile-voronoi.obj.
std::string with_suffix(const std::string& path, const std::string& suffix);

/// Extensions with a blank between them: of the formats that a run writes, and of the formats that
/// `pcvt check` reads.
std::string output_extensions();
std::string readable_extensions();
/// Extensions, with commas between them, of the formats that hold mid-side nodes.
std::string second_order_extensions();

/// The materials with the elastic constants that the files state, of a job of a solver or chosen.
std::vector<NamedConstants> stated_constants(const std::vector<OutputFile>& files,
                                             const FileOptions& options,
                                             const CellMaterials& materials);

}  // namespace pcvt
