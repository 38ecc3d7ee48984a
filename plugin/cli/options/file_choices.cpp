#include "plugin/cli/options/file_choices.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/options/option_values.hpp"
#include "plugin/job/job_files.hpp"

namespace pcvt::cli {
namespace {

constexpr int kMostPixelsOfARow = 1 << 16;

}  // namespace

void add_file_choices(CLI::App& app, FileChoices& choices) {
    app.add_option("--colour", choices.colour,
                   "the quantity that colours show; cells: neighbours differ; orbit: of\n"
                   "the sites under --symmetry, neighbouring orbits differ [sides; in\n"
                   "pictures with --phases phase, with inclusions tag, of grains cells, and\n"
                   "of other cells with --density size]")
        ->type_name(listed_words(kColourings, "|", "|"));
    app.add_option("--background", choices.background,
                   "the background of .svg; none: the page shows through, and text follows\n"
                   "light and dark pages [none]")
        ->type_name("none|#rrggbb");
    app.add_option("--glb-nodes", choices.glb_nodes,
                   "the nodes of .glb and .gltf; cells: one and a material for each cell;\n"
                   "one: one node, vertices shared by all cells, a material for each\n"
                   "colour [cells up to 2000 cells, else and for grains one]")
        ->type_name(listed_words(kGltfNodes, "|", "|"));
    app.add_flag("--float32", choices.float32,
                 "of .ply: 32-bit coordinates, and cells as triangles, which viewers\n"
                 "such as three.js need");
    app.add_option("--pixels", choices.pixels,
                   "width of .png: one period, from u = 0 to 1 and from v = 0 at the bottom\n"
                   "to 1, which repeats without a seam, as the texture of .obj and .glb\n"
                   "too [" +
                       std::to_string(kDefaultPixels) + "]")
        ->type_name("N");
    app.add_option("--voxels", choices.voxels,
                   "of .vti: voxels along x and y [about 16 along h = sqrt(area / n)];\n"
                   "NZ repeats the layer along z, where DAMASK splits a grid over processes")
        ->type_name("NX,NY[,NZ]");
    app.add_option("--coriolis", choices.coriolis,
                   "of .nc: the Coriolis parameter F + BETA y at cells, edges and vertices;\n"
                   "with BETA it jumps where y does, so walls must lie there in the model\n"
                   "[none]")
        ->type_name("F[,BETA]");
    app.add_option("--cut", choices.cut,
                   "of .svg and .dxf: only lines to cut, each edge once and without\n"
                   "colours, in a tile MM millimetres wide\n[.svg: a picture; .dxf: the unit of "
                   "the periods]")
        ->type_name("MM");
    app.add_option("--element", choices.element,
                   "of .inp: elements for plane strain (CPE) or plane stress (CPS) [CPE]")
        ->type_name(listed_words(kPlaneElements, "|", "|"));
    app.add_option("--job", choices.job,
                   "of .inp: materials and steps besides the mesh, so that CalculiX runs\n"
                   "the file as it is; elastic: the homogenised stiffness, with the constants\n"
                   "of --material [the mesh alone, to *INCLUDE in a job]")
        ->type_name(listed_words(kSolverJobs, "|", "|"));
    app.add_option("--thickness", choices.thickness,
                   "of .foam: height of the layer of cells along z [sqrt(area / faces)]")
        ->type_name("T");
    app.add_option("--surface", choices.surface,
                   "of .obj, .ply and .glb: a closed surface for each cell, or the\n"
                   "boundary of the tile, whose faces are matched [cells]")
        ->type_name(listed_words(kSurfaceForms, "|", "|"));
}

FileOptions file_options(const CLI::App& app, const FileChoices& choices) {
    FileOptions options;
    if (app.count("--colour") > 0) {
        options.colouring = chosen_row("--colour", choices.colour, kColourings).colouring;
    }
    if (app.count("--background") > 0) {
        options.background = background_colour(choices.background);
    }
    if (app.count("--glb-nodes") > 0) {
        options.gltf_nodes = chosen_row("--glb-nodes", choices.glb_nodes, kGltfNodes).nodes;
    }
    options.single_precision = choices.float32;
    if (app.count("--pixels") > 0) {
        options.pixels = whole_number("--pixels", choices.pixels, 1, kMostPixelsOfARow);
    }
    if (app.count("--voxels") > 0) options.voxels = voxel_counts("--voxels", choices.voxels);
    if (app.count("--coriolis") > 0) {
        options.coriolis = coriolis_parameter("--coriolis", choices.coriolis);
    }
    if (app.count("--cut") > 0) options.cut_width = positive_number("--cut", choices.cut);
    if (app.count("--element") > 0) {
        options.element = chosen_row("--element", choices.element, kPlaneElements).element;
    }
    if (app.count("--job") > 0) {
        options.job = chosen_row("--job", choices.job, kSolverJobs).job;
    }
    if (app.count("--thickness") > 0) {
        options.thickness = positive_number("--thickness", choices.thickness);
    }
    if (app.count("--surface") > 0) {
        options.surfaces = chosen_row("--surface", choices.surface, kSurfaceForms).form;
    }
    return options;
}

}  // namespace pcvt::cli
