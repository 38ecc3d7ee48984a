#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/formats/formats.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// One output of a job, with the companions that its format writes beside it.
struct JobFile {
    /// The path itself first, then the companions; of a folder the files in it.
    std::vector<std::string> paths;
    const Format* format;
    /// Formats of tiles: the index into job.meshes; else -1.
    int mesh = -1;
    /// Empty unless the files lie in a folder of their own.
    std::string folder = {};

    /// The output as messages name it: the folder, or the file itself.
    const std::string& path() const { return folder.empty() ? paths.front() : folder; }
};

/// The content that a job has for a file, besides the density.
FormatRequest format_request(const Job& job, plane::MeshKind kind);

/// The files of a job in the order of its outputs, without the report.
///
///   for (const JobFile& file : plan_files(job)) std::puts(file.paths.front().c_str());
///
/// @throws InvalidInput for an unknown extension, for a mesh that its format cannot hold, and for
///         two files of the job, or a file and an input, with the same path.
std::vector<JobFile> plan_files(const Job& job);

/// Requires that all files and the report can be written. Completes or removes the unfinished sets
/// of earlier runs, and returns one line for each set.
/// @throws OutputError
std::vector<std::string> require_all_writable(const Job& job, const std::vector<JobFile>& files);

/// Extensions with a blank between them: of the formats that a job writes, and of the formats that
/// `pcvt check` reads.
std::string output_extensions();
std::string readable_extensions();
/// Extensions, with commas between them, of the formats that hold mid-side nodes.
std::string second_order_extensions();

/// `path` without the slash that shells append to the name of a case folder: t.foam/ -> t.foam.
std::string without_slash(const std::string& path);

/// `path` with `suffix` before its extension: tile.obj, -voronoi -> tile-voronoi.obj.
std::string with_suffix(const std::string& path, const std::string& suffix);

/// Requires a file that holds the mid-side nodes of a job of order 2. The files of other formats
/// hold its corners alone.
/// @throws InvalidInput if the job has files, and none of them holds mid-side nodes.
void check_order(const Job& job, const std::vector<JobFile>& files);

/// Requires for each choice in job.file_options a file whose format takes it, and elastic constants
/// where a file would give several phases the same ones.
/// @param phases  those of the cells outside of holes.
/// @throws InvalidInput if the job has files, and none of them takes the choice.
void check_file_options(const Job& job, const std::vector<JobFile>& files,
                        const std::vector<std::string>& phases);

/// The materials with the elastic constants that the files state, of a job of a solver or chosen.
std::vector<NamedConstants> stated_constants(const std::vector<JobFile>& files,
                                             const FileOptions& options,
                                             const CellMaterials& materials);

/// The colour of "none" or "#rrggbb".
/// @throws InvalidInput for other words.
std::optional<Colour> background_colour(const std::string& word);

}  // namespace pcvt
