#include "plugin/cli/check_command.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <optional>

#include "io/bytes/readable_number.hpp"
#include "io/bytes/text.hpp"
#include "io/formats/formats.hpp"
#include "mesher/cells/target_areas.hpp"
#include "plugin/checks/check_proof.hpp"
#include "plugin/cli/cell_options.hpp"
#include "plugin/cli/exit_code.hpp"
#include "plugin/cli/options/option_values.hpp"
#include "plugin/cli/options/site_source.hpp"
#include "plugin/cli/terminal/console.hpp"
#include "plugin/job/job_files.hpp"

namespace pcvt::cli {
namespace {

using checks::Question;

/// Ten times the default of `pcvt mesh --tolerance`: the bisectors of the centroids lie within a
/// few residuals of those of the sites.
constexpr double kCvtTolerance = 1e-5;

/// The files, and the properties that each must have.
struct CheckRequest {
    std::vector<std::string> files;
    Question question = {};
};

/// --cvt takes a tolerance or none; without one the command line parser hands it the next file.
void read_cvt(const CLI::App& app, const CheckOptions& options, CheckRequest& request) {
    if (app.count("--cvt") == 0) return;
    request.question.cvt_tolerance = kCvtTolerance;
    if (options.cvt.empty()) return;
    try {
        parse_number(options.cvt);
    } catch (const InvalidInput&) {
        request.files.insert(request.files.begin(), options.cvt);
        return;
    }
    request.question.cvt_tolerance = positive_number("--cvt", options.cvt);
}

/// The density itself waits for the lattice of each file.
void read_density(const CLI::App& app, const CheckOptions& options, Question& question) {
    const bool given = app.count("--density") > 0;
    if (given && !question.cvt_tolerance) throw InvalidInput("--density is for --cvt; add that");
    if (!given && app.count("--density-range") > 0) {
        throw InvalidInput("--density-range is for --density FILE.png; give one");
    }
    if (options.density.empty()) return;
    question.density = [&options](const plane::Lattice& lattice) {
        return density_option(options.density, options.density_range, lattice);
    };
}

void require_file(const std::string& option, const std::string& word, const std::string& text) {
    if (!names_area_law(text)) return;
    throw InvalidInput(option + " of check takes a file with one " + word +
                       " a site; a law draws other " + word + "s for each seed");
}

/// The files of areas and of volumes are read once for all files.
void read_sizes(const CLI::App& app, const CheckOptions& options, Question& question) {
    if (app.count("--areas") > 0) {
        require_file("--areas", "area", options.areas);
        question.areas = read_areas(area_table(options.areas));
    }
    if (app.count("--volumes") > 0) {
        require_file("--volumes", "volume", options.volumes);
        question.volumes = read_volumes(volume_table(options.volumes));
    }
}

/// @param options  must outlive the request, whose density reads them.
CheckRequest make_request(const CLI::App& app, const CheckOptions& options) {
    CheckRequest request{options.files};
    Question& question = request.question;
    require_one_lattice(app);
    if (app.count("--period") > 0) {
        question.lattice = rectangle_lattice("--period", options.period);
    }
    if (app.count("--lattice") > 0) {
        question.lattice = vector_lattice("--lattice", options.lattice);
    }
    if (app.count("--tolerance") > 0) {
        question.tolerance = positive_number("--tolerance", options.tolerance);
    }
    read_cvt(app, options, request);
    for (std::string& path : request.files) path = without_slash(path);
    read_density(app, options, question);
    read_sizes(app, options, question);
    if (app.count("--inclusions") > 0) question.inclusions = read_inclusions(options.inclusions);
    if (request.files.empty()) throw InvalidInput("no file to check; give one or more");
    return request;
}

/// @returns false where the file is refuted.
bool check(const std::string& path, const Question& question) {
    try {
        print(checks::prove(path, question));
        return true;
    } catch (const NotATile& error) {
        std::fprintf(stderr, "%s\n", error.what());
    } catch (const InvalidInput&) {
        std::fprintf(stderr, "%s\n", describe_failure(std::current_exception()).line.data());
    }
    return false;
}

}  // namespace

void add_check_options(CLI::App& app, CheckOptions& options) {
    app.add_option("FILE", options.files, "tiles to prove: " + readable_extensions())
        ->option_text("...");
    app.add_option("--period", options.period, "lattice of files that state none, a rectangle")
        ->type_name("W,H");
    app.add_option("--lattice", options.lattice, "the same, any two period vectors")
        ->type_name("AX,AY,BX,BY");
    app.add_option("--tolerance", options.tolerance,
                   "a length within which the sides of a tile of another program agree\n"
                   "[4 ulps of the largest coordinate, in the precision of the file]")
        ->type_name("L");
    app.add_option("--cvt", options.cvt,
                   "prove as well that cells are centroidal Voronoi, triangles Delaunay,\n"
                   "within TOL h, h = sqrt(area / n); in single precision at least\n"
                   "within what that resolves [" +
                       figure(kCvtTolerance) + "]")
        ->option_text("[TOL]")
        ->expected(0, 1);
    app.add_option("--areas", options.areas,
                   "prove as well that power cells have the areas of a file as\n"
                   "`pcvt mesh --areas` takes it, built again from sites and weights;\n"
                   "grains: that the faces of each site have them")
        ->type_name("FILE[:COLUMN]");
    app.add_option("--volumes", options.volumes,
                   "in space, prove as well that the cells have the volumes of a file as\n"
                   "`pcvt mesh --volumes` takes it, within 1e-9 of the mean or of their own\n"
                   "(1e-8 and 1e-7 above 20,000 and 200,000 cells), or what rounding changes")
        ->type_name("FILE[:COLUMN]");
    app.add_option("--inclusions", options.inclusions,
                   "prove as well that no cell crosses the outline of a shape of\n"
                   "`pcvt mesh --inclusions FILE`, that the outline consists of edges of\n"
                   "cells, and that the cells inside have its tag and its area")
        ->type_name("FILE");
    app.add_option("--density", options.density,
                   "of the centroids of --cvt, as for `pcvt mesh`, in the file's lattice")
        ->type_name("EXPR|FILE.png");
    app.add_option("--density-range", options.density_range, "as for `pcvt mesh`")
        ->type_name("LO,HI");
    app.footer(
        "Rebuilds the seam from the positions and the lattice, and compares it:\n"
        "each boundary edge has one reversed partner by one lattice vector, the tile is a disc,\n"
        "its Euler characteristic is 0 after gluing, the areas sum to that of the domain.\n"
        "Polyhedra (.vtu, .foam): each cell is convex and closed, each face has two cells or one\n"
        "partner by one lattice vector, and the cells are the Voronoi cells of the sites.\n"
        "Site ids are proved too; in files of pcvt for solvers each group, set and array must\n"
        "be the one that follows from the tile.\n"
        "Reads regular files of at most 4 GiB each.\n\n"
        "Examples:\n"
        "  pcvt check tile.obj tile.glb\n"
        "  pcvt check tile.obj --cvt 1e-4\n"
        "  pcvt check grains.obj --areas grains.txt\n"
        "  pcvt check grains.vtu --volumes grains.csv:volume\n"
        "  pcvt check composite.obj --inclusions shapes.txt\n"
        "  pcvt check --period 2,1 from-elsewhere.obj\n"
        "  pcvt check --period 1,1 --tolerance 1e-9 from-gmsh.msh\n");
}

ExitCode run_check(const CLI::App& app, const CheckOptions& options) {
    const CheckRequest request = make_request(app, options);
    bool all_proved = true;
    for (const std::string& path : request.files) {
        all_proved = check(path, request.question) && all_proved;
    }
    return all_proved ? ExitCode::kDone : ExitCode::kBadInput;
}

}  // namespace pcvt::cli
