#pragma once

#include <string>

#include "mesher/plane/density/density.hpp"
#include "plugin/job/job.hpp"

namespace CLI {
class App;
}

namespace pcvt::cli {

/// The options for the sizes and the shapes of cells and for walls beside them, as the user typed
/// them; empty if not given.
struct CellOptions {
    std::string density;
    std::string density_range;
    std::string areas;
    std::string volumes;
    std::string weights;
    std::string centroids;
    std::string aspect;
    std::string walls;
    std::string wall_cells;
    std::string fixed;
    std::string inclusions;
    std::string fibres;
};

/// Adds the options to `app`; parsing fills `options`, and the tags of holes of `job`.
void add_cell_options(CLI::App& app, CellOptions& options, Job& job);

/// Sets the job as the options say. Does not read a file of areas.
/// @throws InvalidInput, BadFile, BadDensity, LimitExceeded naming the option.
void read_cell_options(const CLI::App& app, const CellOptions& options, Job& job);

/// The domain of --period auto: a square of the sum of the areas in a file, or a rectangle of the
/// width 1 with the aspect of a picture.
/// @throws InvalidInput if the options name neither; BadFile.
plane::Lattice automatic_period(const CellOptions& options);

/// Reads the file of areas of a job that has its sites, if it names one.
/// @throws BadFile naming the line.
void read_area_file(Job& job);

/// Reads the file of --weights, which says a weight for each of the given sites of the job.
/// @throws BadFile naming the line.
void read_weight_file(const CellOptions& options, Job& job);

/// The density of --density and --density-range.
///
///   job.density = density_option("1 + 9 * u", "", job.in_plane().lattice);
///
/// @param range    empty if the option is not given.
/// @param lattice  defines the coordinates u and v.
/// @throws InvalidInput, BadFile, BadDensity naming the options; LimitExceeded.
plane::Density density_option(const std::string& density, const std::string& range,
                              const plane::Lattice& lattice);

}  // namespace pcvt::cli
