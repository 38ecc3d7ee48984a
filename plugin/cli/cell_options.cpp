#include "plugin/cli/cell_options.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/run_files/area_reader.hpp"
#include "io/run_files/density_image.hpp"
#include "io/run_files/inclusion_reader.hpp"
#include "io/run_files/site_reader.hpp"
#include "io/run_files/weight_reader.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/space/geometry/metric.hpp"
#include "plugin/cli/help_command.hpp"
#include "plugin/cli/options/option_values.hpp"
#include "plugin/job/job_density.hpp"

namespace pcvt::cli {
namespace {

GreyRange grey_range(const std::string& text) {
    const plane::Vec2 range = point("--density-range", text);
    for (const double limit : {range.x(), range.y()}) {
        if (!(limit >= plane::kLeastDensity && limit <= plane::kGreatestDensity)) {
            throw InvalidInput("--density-range " + text +
                               ": not from 1e-60 to 1e60; give two positive densities LO,HI");
        }
    }
    return {range.x(), range.y()};
}

void read_density(const CLI::App& app, const CellOptions& options, Job& job) {
    if (app.count("--density") == 0) {
        if (app.count("--density-range") == 0) return;
        throw InvalidInput("--density-range is for --density FILE.png; give one");
    }
    job.density = density_option(options.density, options.density_range, job.in_plane().lattice);
    job.density_name = options.density;
    if (names_picture(options.density)) job.inputs.push_back(options.density);
}

/// A law, or the name of a file.
/// @param option  "--areas" or "--volumes".
TargetSizes target_sizes(const std::string& option, const std::string& text) {
    const bool in_space = option == "--volumes";
    const char* const word = in_space ? "volume" : "area";
    if (names_area_law(text)) {
        try {
            return {.law = parse_area_law(text), .name = text};
        } catch (const InvalidInput& error) {
            throw InvalidInput(option + " " + error.what());
        }
    }
    std::error_code unknown;
    const TableName table = in_space ? volume_table(text) : area_table(text);
    if (text.empty() || !std::filesystem::exists(table.path, unknown)) {
        throw InvalidInput(
            option + " " + (text.empty() ? "''" : text) +
            ": neither a law nor a file; take equal, lognormal:S, gamma:S, a mixture "
            "SHARE*LAW@MEAN+... or a file with one " +
            word + " a line");
    }
    return {.name = text};
}

/// "R" or "R,DEGREES", in space "R" or "R,X,Y,Z".
Aspect read_aspect(const std::string& text, bool in_space) {
    const std::size_t comma = text.find(',');
    const bool is_ratio = comma == std::string::npos;
    Aspect aspect;
    if (in_space) {
        if (const auto n = std::count(text.begin(), text.end(), ','); n != 0 && n != 3) {
            throw InvalidInput("--aspect " + text +
                               ": in space the three numbers of an axis follow the ratio; give R "
                               "or R,X,Y,Z");
        }
        aspect.ratio = point("--aspect", text.substr(0, comma) + ",0").x();
        if (!is_ratio) aspect.axis = space_point("--aspect", text.substr(comma + 1));
    } else {
        const plane::Vec2 values = point("--aspect", is_ratio ? text + ",0" : text);
        aspect = {.ratio = values.x(), .degrees = values.y()};
    }
    try {
        if (in_space) {
            space::Metric(aspect.ratio, aspect.axis);
        } else {
            plane::Metric(aspect.ratio, aspect.degrees);
        }
    } catch (const InvalidInput& error) {
        throw InvalidInput("--aspect " + text + ": " + error.what());
    }
    return aspect;
}

}  // namespace

void add_cell_options(CLI::App& app, CellOptions& options, Job& job) {
    const auto add = [&](const char* name, std::string& value, const char* form,
                         const std::string& description) {
        app.add_option(name, value, description)->type_name(form);
    };
    add("--density", options.density, "EXPR|FILE.png",
        "cells are small where it is large: a formula in x, y (length) and\n"
        "u, v (0 to 1 along the period vectors), or a picture laid over\n"
        "the domain; random sites are then drawn from its square root [1];\n" +
            formula_words());
    add("--density-range", options.density_range, "LO,HI",
        "densities of black and of white pixels [0.01,1]");
    add("--areas", options.areas, "equal|lognormal:S|gamma:S|MIXTURE|FILE[:COLUMN]",
        "cells of prescribed areas, exact to 1e-10: a law of the equivalent\n"
        "diameter, drawn from --seed, S its standard deviation over its\n"
        "mean, or a mixture of laws, such as\n"
        "'0.7*lognormal:0.3@1+0.3*gamma:0.2@3', share of the cells * law @ mean\n"
        "diameter; or a table with one area a line, one for each site, or one\n"
        "diameter or radius as its header or diameter:FILE says, scaled to\n"
        "the area of the domain, which with --period auto is their sum; see\n"
        "--max-iterations");
    add("--volumes", options.volumes, "equal|lognormal:S|gamma:S|MIXTURE|FILE[:COLUMN]",
        "in space, cells of prescribed volumes, as --areas: a law of the\n"
        "equivalent diameter or a mixture, whose largest volumes begin at the\n"
        "largest cells, or a table of volumes, diameters or radii;\n"
        "--max-iterations K steps make the grains round [5]");
    add("--weights", options.weights, "FILE[:COLUMN]",
        "the power cells (Laguerre cells) of the sites of --input: one weight a\n"
        "line, a length squared, or below the header radius a radius; needs\n"
        "--max-iterations 0; a column weight of --input counts as well");
    add("--centroids", options.centroids, "FILE[:X,Y]",
        "in place of --input, the centroids of measured grains, \"x y\" a line (in\n"
        "space \"x y z\"), whose sizes --areas or --volumes FILE gives: the power\n"
        "cells with these sizes and, as nearly as they can, these centroids");
    add("--aspect", options.aspect, "R[,DEGREES]",
        "elongated cells, R times as long along DEGREES from x as across\n"
        "it, from 0.01 to 100 [1,0]; in space R,X,Y,Z: along that axis [1,1,0,0]");
    add("--walls", options.walls, "x|y|xy",
        "straight walls in place of periods: x at x = 0 and W, y at y = 0\n"
        "and H, xy all round");
    add("--wall-cells", options.wall_cells, "whole|half",
        "cells beside walls: whole, or half, whose sites lie on the wall\n[whole]");
    add("--fixed", options.fixed, "FILE[:X,Y]",
        "sites that stay where they are, \"x y\" a line as for --input; --sites\n"
        "counts them too, and the others are drawn");
    add("--inclusions", options.inclusions, "FILE",
        "shapes whose outlines no cell crosses, one a line: circle TAG x y r,\n"
        "ellipse TAG x y a b DEGREES, polygon TAG x1 y1 x2 y2 ...; images are\n"
        "implied, listed ones left out; the tags are the phases of the cells");
    add("--fibres", options.fibres, "FRACTION,N[,GAP]",
        "in place of --inclusions, N equal circles of the tag fibre with this\n"
        "part of the area, at random places by --seed, not nearer than GAP");
    app.add_option("--hole", job.holes,
                   "leaves the cells of the inclusions with this tag out: their edges\n"
                   "are walls TAG in the files; repeatable")
        ->type_name("TAG")
        ->option_text("TAG")
        ->allow_extra_args(false);
}

void read_cell_options(const CLI::App& app, const CellOptions& options, Job& job) {
    if (app.count("--aspect") > 0) job.aspect = read_aspect(options.aspect, job.is_in_space());
    if (app.count("--areas") > 0) {
        job.sizes = target_sizes("--areas", options.areas);
        if (!names_area_law(options.areas)) job.inputs.push_back(area_table(options.areas).path);
    }
    if (app.count("--volumes") > 0) {
        job.sizes = target_sizes("--volumes", options.volumes);
        if (!names_area_law(options.volumes)) {
            job.inputs.push_back(volume_table(options.volumes).path);
        }
    }
    if (app.count("--weights") > 0) {
        if (app.count("--input") == 0) {
            throw InvalidInput("--weights is for the sites of --input; add it");
        }
        job.inputs.push_back(weight_table(options.weights).path);
    }
    if (app.count("--walls") > 0) {
        job.walls = chosen_row("--walls", options.walls, std::span(kWalls).subspan<1>()).walls;
    }
    if (app.count("--wall-cells") > 0) {
        job.wall_cells = chosen_row("--wall-cells", options.wall_cells, kWallCells).cells;
    }
    if (app.count("--fixed") > 0) {
        SiteFile file = read_sites<2>(parse_table_name(options.fixed));
        job.in_plane().fixed = std::move(file.points);
        job.lines = std::move(file.lines);
        job.site_unit = std::move(file.unit);
        job.inputs.push_back(file.name);
    }
    if (app.count("--inclusions") > 0) {
        job.inclusions = read_inclusions(options.inclusions);
        job.inputs.push_back(options.inclusions);
    }
    if (app.count("--fibres") > 0) {
        try {
            job.fibres = parse_fibres(options.fibres);
        } catch (const InvalidInput& error) {
            throw InvalidInput("--fibres " + std::string(error.what()));
        }
    }
    read_density(app, options, job);
}

plane::Lattice automatic_period(const CellOptions& options) {
    double width = 1;
    double height = 1;
    if (!options.areas.empty() && !names_area_law(options.areas)) {
        width = height = std::sqrt(read_areas(area_table(options.areas)).areas.sum());
    } else if (names_picture(options.density)) {
        height = png_height_over_width(options.density);
    } else {
        throw InvalidInput(
            "--period auto takes the area of the domain from --areas FILE, or its aspect from "
            "--density FILE.png; add one of the two, or give W,H");
    }
    std::string sides;
    append_number(sides, width);
    sides += ',';
    append_number(sides, height);
    return rectangle_lattice("--period", sides);
}

void read_area_file(Job& job) {
    if (!job.sizes || names_area_law(job.sizes->name)) return;
    const bool in_space = job.is_in_space();
    AreaFile file = in_space ? read_volumes(volume_table(job.sizes->name))
                             : read_areas(area_table(job.sizes->name));
    require_areas(file, job.n_wanted(), in_space ? "volume" : "area");
    job.sizes->given = std::move(file.areas);
    job.sizes->name = std::move(file.description);
}

void read_weight_file(const CellOptions& options, Job& job) {
    if (options.weights.empty()) return;
    const WeightFile file = read_weights(weight_table(options.weights));
    require_weights(file, job.n_wanted());
    if (!file.unit.empty() && !job.site_unit.empty() && file.unit != job.site_unit) {
        throw BadFile(file.name + ":" + std::to_string(file.header_line) +
                      ": the unit of the lengths is " + file.unit + ", but that of the sites " +
                      job.site_unit + "; give both in one unit");
    }
    job.weights = GivenWeights{file.weights, file.description};
}

plane::Density density_option(const std::string& density, const std::string& range,
                              const plane::Lattice& lattice) {
    if (names_picture(density)) {
        std::optional<GreyRange> greys;
        if (!range.empty()) greys = grey_range(range);
        return source_density(density, greys, lattice);
    }
    if (!range.empty()) {
        throw InvalidInput("--density-range is for --density FILE.png; remove it");
    }
    try {
        return source_density(density, {}, lattice);
    } catch (const InvalidInput& error) {
        throw InvalidInput("--density " + in_quotes(density) + ": " + error.what());
    }
}

}  // namespace pcvt::cli
