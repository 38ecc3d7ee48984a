#pragma once

#include <string>
#include <vector>

#include "io/tile_formats.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// What a file holds: one of the job's tiles, the sites, or the C-grid of the torus.
enum class JobContent { kTile, kSites, kMpasGrid };

/// One file that a job was asked for, with the companions that its format writes beside it.
struct JobFile {
    /// The path itself first, then the companions; of a folder the files in it.
    std::vector<std::string> paths;
    JobContent content;
    /// Tiles: their format and their index into job.meshes; else nullptr and -1.
    const TileFormat* format = nullptr;
    int mesh = -1;
    /// Empty unless the files stand in a folder of their own.
    std::string folder = {};
};

/// The files of a job in the order in which they were asked for, the report not among them.
/// @throws InvalidInput for an extension that is not known, for a mesh that its format cannot hold,
///         and where two files of the job, or a file and an input, have one path.
std::vector<JobFile> plan_files(const Job& job);

/// Extensions with a blank between them: of what a job writes, and of what `pcvt check` reads.
std::string output_extensions();
std::string readable_extensions();

/// `path` without the slash that shells append to the name of a case folder: t.foam/ -> t.foam.
std::string without_slash(const std::string& path);

/// `path` with `suffix` before its extension: tile.obj, -voronoi -> tile-voronoi.obj.
std::string with_suffix(const std::string& path, const std::string& suffix);

}  // namespace pcvt
