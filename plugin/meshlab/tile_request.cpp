#include "plugin/meshlab/tile_request.hpp"

#include <array>
#include <charconv>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "plugin/meshlab/words.hpp"

namespace pcvt::meshlab {
namespace {

/// The values of the parameter "select".
enum Selection { kSelectNothing, kSelectVertices, kSelectFaces, kSelectBoth };

/// The words of a table as the entries of a parameter, whose value is the number of the word.
template <class Words>
QStringList entries(const Words& words) {
    QStringList list;
    for (const char* word : words) list << word;
    return list;
}

void add_sites(RichParameterList& list) {
    list.addParam(RichInt("sites", 300, "Sites", "How many cells one period has."));
    list.addParam(RichString("lattice", "1, 0, 0, 1", "Period vectors",
                             "Width and height of a rectangle, or ax, ay, bx, by: any two "
                             "independent vectors."));
    list.addParam(RichInt("seed", 0, "Random seed", "Same seed, same tile."));
    list.addParam(
        RichEnum("start", PCVT_START_DEFAULT, entries(kStartWords), "Start",
                 "Where the sites are before they are optimised; coarse: from coarse to fine; "
                 "lattice: on a disturbed lattice; best: after a search."));
    list.addParam(RichString("density", "", "Density",
                             "A positive formula in x, y (length) and u, v (0 to 1 along the "
                             "period vectors), or the name of a .png file; cells are small where "
                             "it is large. Empty: uniform."));
}

void add_tile(RichParameterList& list) {
    list.addParam(
        RichEnum("mesh", PCVT_VORONOI, entries(kMeshWords), "Mesh",
                 "Voronoi cells are polygons: fans of triangles with hidden edges. Grains "
                 "are triangles inside of cells."));
    list.addParam(RichEnum("outline", PCVT_WHOLE, entries(kOutlineWords), "Outline",
                           "Whether no cell is cut, or the tile is a box, cut along the period "
                           "parallelogram. Delaunay triangles are never cut."));
    list.addParam(RichFloat("grainSize", 0, "Size of triangles inside of cells",
                            "Edge length; 0: chosen by pcvt."));
    list.addParam(RichInt("columns", 1, "Periods along a", "How often the tile is repeated."));
    list.addParam(RichInt("rows", 1, "Periods along b", "How often the tile is repeated."));
    list.addParam(RichFloat("shortEdges", 0, "Remove short edges",
                            "Cells lose edges shorter than this times sqrt(area / sites)."));
}

void add_optimiser(RichParameterList& list) {
    list.addParam(RichFloat("tolerance", 1e-6F, "Tolerance",
                            "Ends when no site is further from the centroid of its cell than this "
                            "times sqrt(area / sites)."));
    list.addParam(RichInt("maxIterations", -1, "Most iterations",
                          "0: the Voronoi diagram of the sites as they start; -1: no limit."));
}

void add_look(RichParameterList& list) {
    list.addParam(RichEnum("colour", static_cast<int>(Colouring::kBySides),
                           {"None", "Each cell its own", "Number of sides"}, "Colours",
                           "Of cells, or of the vertices of Delaunay triangles, which are the "
                           "sites. By sides: hexagons are pale, fewer blue, more orange."));
    list.addParam(RichEnum("select", kSelectNothing,
                           {"Nothing", "Vertices on the seam", "Faces at the seam", "Both"},
                           "Select",
                           "The seam is the boundary: each of its edges is glued to another one "
                           "by a period. Vertices that become one have the same quality."));
}

double decimal_of(float value) {
    std::array<char, 32> text{};
    const char* end = std::to_chars(text.begin(), text.end(), value).ptr;
    double number = 0;
    std::from_chars(text.begin(), end, number);
    return number;
}

/// Numbers between commas or blanks.
/// @throws std::invalid_argument with any other text.
std::vector<double> read_numbers(const std::string& text) {
    constexpr std::string_view kGaps = ", \t";
    std::vector<double> numbers;
    std::size_t begin = text.find_first_not_of(kGaps);
    while (begin != std::string::npos) {
        const std::size_t end = std::min(text.find_first_of(kGaps, begin), text.size());
        double number = 0;
        const auto [rest, error] = std::from_chars(text.data() + begin, text.data() + end, number);
        if (error != std::errc() || rest != text.data() + end) {
            throw std::invalid_argument("period vectors: '" + text.substr(begin, end - begin) +
                                        "' is not a number");
        }
        numbers.push_back(number);
        begin = text.find_first_not_of(kGaps, end);
    }
    return numbers;
}

void read_lattice(const std::string& text, double* lattice) {
    std::vector<double> numbers = read_numbers(text);
    if (numbers.size() == 2) numbers = {numbers[0], 0, 0, numbers[1]};
    if (numbers.size() != 4) {
        throw std::invalid_argument("period vectors: give width, height or ax, ay, bx, by, not '" +
                                    text + "'");
    }
    std::copy(numbers.begin(), numbers.end(), lattice);
}

}  // namespace

void add_parameters(RichParameterList& parameters) {
    add_sites(parameters);
    add_tile(parameters);
    add_optimiser(parameters);
    add_look(parameters);
}

TileRequest read_request(const RichParameterList& parameters) {
    TileRequest request;
    pcvt_options& options = request.options;
    if (pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION) != PCVT_OK) {
        throw std::invalid_argument(pcvt_last_error());
    }
    read_lattice(parameters.getString("lattice").toStdString(), options.lattice);
    const int seed = parameters.getInt("seed");
    if (seed < 0) throw std::invalid_argument("the random seed is negative");
    options.seed = static_cast<uint64_t>(seed);
    options.n_sites = parameters.getInt("sites");
    options.start = parameters.getEnum("start");
    options.tolerance = decimal_of(parameters.getFloat("tolerance"));
    options.max_iterations = parameters.getInt("maxIterations");
    options.columns = parameters.getInt("columns");
    options.rows = parameters.getInt("rows");
    options.grain_size = decimal_of(parameters.getFloat("grainSize"));
    options.short_edges = decimal_of(parameters.getFloat("shortEdges"));
    request.density = parameters.getString("density").toStdString();
    request.kind = parameters.getEnum("mesh");
    request.outline = parameters.getEnum("outline");
    request.colouring = static_cast<Colouring>(parameters.getEnum("colour"));
    const int selection = parameters.getEnum("select");
    request.select_vertices = selection == kSelectVertices || selection == kSelectBoth;
    request.select_faces = selection == kSelectFaces || selection == kSelectBoth;
    return request;
}

}  // namespace pcvt::meshlab
