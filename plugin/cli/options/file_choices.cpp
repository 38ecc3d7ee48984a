#include "plugin/cli/options/file_choices.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "plugin/cli/options/option_values.hpp"
#include "plugin/job/job_files.hpp"

namespace pcvt::cli {

void add_file_choices(CLI::App& app, FileChoices& choices, NumberTexts& numbers) {
    app.add_option("--colour", choices.colour,
                   "the quantity that colours show; cells: neighbours differ; orbit: of\n"
                   "the sites under --symmetry, neighbouring orbits differ; orientation: the\n"
                   "inverse pole figure along z of cubic crystals [sides; in pictures with\n"
                   "--phases phase, with --orientations orientation, with inclusions tag, of\n"
                   "grains cells, and of other cells with --density size; in space with\n"
                   "--phases phase, with --orientations orientation, else faces]")
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
    add_number(app, "--pixels", numbers);
    app.add_option("--voxels", choices.voxels,
                   "of .vti: voxels along x and y [about 16 along h = sqrt(area / n)];\n"
                   "NZ repeats the layer along z, where DAMASK splits a grid over processes;\n"
                   "in space NX,NY,NZ [about 16 along h = cbrt(volume / n)]")
        ->type_name("NX,NY[,NZ]");
    app.add_option("--coriolis", choices.coriolis,
                   "of .nc: the Coriolis parameter F + BETA y at cells, edges and vertices;\n"
                   "with BETA it jumps where y does, so walls must lie there in the model\n"
                   "[none]")
        ->type_name("F[,BETA]");
    add_number(app, "--cut", numbers);
    app.add_option("--element", choices.element,
                   "of .inp: triangles for plane strain (CPE) or plane stress (CPS), or one\n"
                   "layer of wedges along z, periodic there as well, for all six strains\n"
                   "(C3D6, C3D15 of --order 2) [CPE]")
        ->type_name(listed_words(kPlaneElements, "|", "|"));
    app.add_option("--job", choices.job,
                   "of .inp: materials and steps besides the mesh, so that CalculiX runs\n"
                   "the file as it is; elastic: the homogenised stiffness, with the constants\n"
                   "of --material [only the mesh, to *INCLUDE in a job]")
        ->type_name(listed_words(kSolverJobs, "|", "|"));
    add_number(app, "--thickness", numbers);
    app.add_option("--surface", choices.surface,
                   "of .obj, .ply, .glb, .stl: a closed surface for each cell, or the\n"
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
    if (app.count("--voxels") > 0) options.voxels = voxel_counts("--voxels", choices.voxels);
    if (app.count("--coriolis") > 0) {
        options.coriolis = coriolis_parameter("--coriolis", choices.coriolis);
    }
    if (app.count("--element") > 0) {
        options.element = chosen_row("--element", choices.element, kPlaneElements).element;
    }
    if (app.count("--job") > 0) {
        options.job = chosen_row("--job", choices.job, kSolverJobs).job;
    }
    if (app.count("--surface") > 0) {
        options.surfaces = chosen_row("--surface", choices.surface, kSurfaceForms).form;
    }
    return options;
}

}  // namespace pcvt::cli
