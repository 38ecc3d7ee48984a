#include "plugin/job/number_options.hpp"

#include <array>
#include <limits>

#include "mesher/base/choices.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {
namespace {

constexpr const char* kOptimisation = "Optimisation";
constexpr const char* kOutput = "Output";

const std::array kNumberOptions{
    NumberRow{.option = "--tolerance",
              .field = "tolerance",
              .group = kOptimisation,
              .form = "T",
              .help = "converged once max |x_i - g_i| / h <= T; x_i: site i, g_i: centroid\n"
                      "of its cell, h = sqrt(area / n) [1e-6]",
              .of = [](Job& job) -> double& { return job.run.tolerance; },
              .unset = UnsetField::kNone},
    NumberRow{.option = "--max-iterations",
              .field = "max_iterations",
              .group = kOptimisation,
              .form = "K",
              .help = "the most iterations; 0: the Voronoi diagram of the sites as given;\n"
                      "with --areas, steps that move each site to the centroid of its cell:\n"
                      "0 keeps the sites, 5 gives round grains [no limit]",
              .of = [](Job& job) -> int& { return job.run.max_iterations; },
              .highest = std::numeric_limits<int>::max(),
              .unset = UnsetField::kNegative},
    NumberRow{.option = "--size",
              .field = "grain_size",
              .group = kOutput,
              .form = "H",
              .help = "length of the edges of grains [h / 3]; in space of tetrahedra\n"
                      "[a third of the cube root of the volume of each cell]",
              .of = [](Job& job) -> double& { return job.tile.grain_size; }},
    NumberRow{.option = "--per-edge",
              .field = "grain_per_edge",
              .group = kOutput,
              .form = "K",
              .help = "cut each edge of the cells into K parts, grains inside to match,\n"
                      "in place of --size",
              .of = [](Job& job) -> int& { return job.tile.grain_per_edge; },
              .lowest = 1,
              .highest = 1000},
    NumberRow{.option = "--short-edges",
              .field = "short_edges",
              .group = kOutput,
              .form = "L",
              .help = "remove Voronoi edges under L h from the cells, for finite volumes;\n"
                      "in space at most 0.1, for .vtu and .foam [0]",
              .of = [](Job& job) -> double& { return job.tile.short_edges; },
              .unset = UnsetField::kNone},
    NumberRow{.option = "--pixels",
              .field = "pixels",
              .group = kOutput,
              .form = "N",
              .help = "width of .png: one period, from u = 0 to 1 and from v = 0 at the bottom\n"
                      "to 1, which repeats without a seam, as the texture of .obj and .glb\n"
                      "too [" +
                      std::to_string(kDefaultPixels) + "]",
              .of = &FileOptions::pixels,
              .lowest = 1,
              .highest = 1 << 16},
    NumberRow{.option = "--cut",
              .field = "cut_width",
              .group = kOutput,
              .form = "MM",
              .help = "of .svg and .dxf: only lines to cut, each edge once and without\n"
                      "colours, in a tile MM millimetres wide\n"
                      "[.svg: a picture; .dxf: the unit of the periods]",
              .of = &FileOptions::cut_width},
    NumberRow{.option = "--thickness",
              .field = "thickness",
              .group = kOutput,
              .form = "T",
              .help = "height of the layer along z: of the cells of .foam, and of the wedges of\n"
                      "--element C3D6 or C3D15 [sqrt(area / faces)]",
              .of = &FileOptions::thickness}};

}  // namespace

std::span<const NumberRow> number_options() { return kNumberOptions; }

const NumberRow* find_number_option(std::string_view option) {
    return find_row(kNumberOptions, [&](const NumberRow& row) { return row.option == option; });
}

void set_number(const NumberRow& row, Job& job, double value) {
    if (row.is_of_files()) {
        set_number(row, job.file_options, value);
    } else if (row.is_whole()) {
        std::get<1>(row.of)(job) = static_cast<int>(value);
    } else {
        std::get<0>(row.of)(job) = value;
    }
}

void set_number(const NumberRow& row, FileOptions& options, double value) {
    if (row.is_whole()) {
        options.*std::get<3>(row.of) = static_cast<int>(value);
    } else {
        options.*std::get<2>(row.of) = value;
    }
}

}  // namespace pcvt
