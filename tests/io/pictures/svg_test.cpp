#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <random>
#include <regex>
#include <sstream>

#include "io/colours/palette.hpp"
#include "io/pictures/svg_canvas.hpp"
#include "io/pictures/svg_writer.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt {
namespace {

using ::testing::Ge;
using testing::grid_tile;
using ::testing::HasSubstr;
using ::testing::Le;
using ::testing::Not;
using ::testing::StartsWith;
using testing::triangle_grid_tile;

std::string svg(const plane::Tile& tile, const FileOptions& options = {}) {
    return encode_svg(tile, options, "t.svg").at(0).bytes;
}

std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
        found.push_back((*at)[1]);
    }
    return found;
}

/// Width and height of the canvas.
plane::Vec2 canvas(const std::string& picture) {
    const std::smatch match = [&] {
        static const std::regex kViewBox(R"re(viewBox="0 0 ([\d.]+) ([\d.]+)")re");
        std::smatch result;
        EXPECT_TRUE(std::regex_search(picture, result, kViewBox));
        return result;
    }();
    return {std::stod(match[1]), std::stod(match[2])};
}

/// Returns every point of every path.
std::vector<plane::Vec2> path_points(const std::string& picture) {
    std::vector<plane::Vec2> points;
    static const std::regex kPoint(R"([ML](-?[\d.]+) (-?[\d.]+))");
    for (std::sregex_iterator at(picture.begin(), picture.end(), kPoint), end; at != end; ++at) {
        points.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
    }
    return points;
}

TEST(Svg, FitsTheCanvasAtAnyScaleAndAspect) {
    for (const plane::Vec2& size :
         {plane::Vec2(1, 1), plane::Vec2(20, 1), plane::Vec2(1, 20), plane::Vec2(1e6, 1e6),
          plane::Vec2(1e-3, 2e-3), plane::Vec2(1, 1000), plane::Vec2(1e59, 1e59)}) {
        for (const plane::Tile& tile :
             {grid_tile(plane::Lattice::rectangle(size.x(), size.y()), 3, 2),
              triangle_grid_tile(plane::Lattice::rectangle(size.x(), size.y()), 3, 2)}) {
            const std::string picture = svg(tile);
            const plane::Vec2 edge = canvas(picture);
            EXPECT_THAT(edge.maxCoeff(), Le(1700));
            EXPECT_THAT(edge.minCoeff(), Ge(100));
            const std::vector<plane::Vec2> points = path_points(picture);
            EXPECT_THAT(points.size(), Ge(4u * 6u));
            for (const plane::Vec2& p : points) {
                EXPECT_TRUE((p.array() >= 19.99).all() &&
                            (p.array() <= edge.array() - 19.99).all());
            }
        }
    }
}

TEST(Svg, TheYAxisPointsUpwards) {
    plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 1, 1);
    const std::vector<plane::Vec2> points = path_points(svg(tile));
    ASSERT_EQ(tile.points[tile.faces.corners[0]], plane::Vec2(0, 0));
    ASSERT_EQ(tile.points[tile.faces.corners[2]], plane::Vec2(1, 1));
    EXPECT_GT(points[2].x(), points[0].x());
    EXPECT_LT(points[2].y(), points[0].y());
}

TEST(Svg, CellsHaveTheColourOfTheirSides) {
    const std::string picture = svg(grid_tile(plane::Lattice::rectangle(1, 1), 3, 2));
    const auto fills = all_matches(picture, R"re(<path fill="([^"]+)")re");
    EXPECT_THAT(fills, ::testing::ElementsAre(hex(side_colour(4))));
    EXPECT_THAT(picture, HasSubstr("4 sides: 6<"));
    EXPECT_THAT(picture, HasSubstr("<title>Periodic Voronoi tile, 6 cells</title>"));
}

TEST(Svg, GrainsHaveABoundaryBetweenSites) {
    plane::Tile tile = testing::grain_grid_tile(plane::Lattice::rectangle(1, 1), 3, 2);
    tile.whole_sides.assign(std::size_t(tile.n_faces()), 5);
    const std::string picture = svg(tile, {.colouring = Colouring::kSides});
    EXPECT_THAT(picture, HasSubstr("<title>Periodic grains, 12 triangles</title>"));
    EXPECT_THAT(picture, HasSubstr("5 sides<"));
    const auto fills = all_matches(picture, R"re(<path fill="([^"]+)")re");
    EXPECT_THAT(fills, ::testing::ElementsAre(hex(side_colour(5))));
    tile.face_site.assign(std::size_t(tile.n_faces()), 0);
    const std::string one = svg(tile, {.colouring = Colouring::kSides});
    EXPECT_LT(path_points(one).size(), path_points(picture).size());
}

TEST(Svg, PiecesWithoutTheirSiteHaveNoDot) {
    plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 2, 1);
    tile.site_points = {{0.25, 0.5}, {0.25, 0.5}};
    const std::size_t both = path_points(svg(tile)).size();
    tile.whole_sides = {4, 4};
    EXPECT_EQ(path_points(svg(tile)).size(), both - 1);
}

TEST(Svg, TheSeamOfEachTranslationHasOneColour) {
    plane::Tile tile = grid_tile(plane::Lattice({1, 0}, {0.37, 0.81}), 3, 2);
    for (std::size_t k = 0; k < tile.edge_pairs.size(); k += 2) {
        const plane::EdgePair pair = tile.edge_pairs[k];
        tile.edge_pairs[k] = {pair.w1, pair.w0, pair.v1, pair.v0, -pair.offset};
    }
    const std::string picture = svg(tile);
    EXPECT_THAT(picture, HasSubstr("seam (1, 0)"));
    EXPECT_THAT(picture, HasSubstr("seam (0, 1)"));
    const auto strokes = all_matches(picture, R"re(stroke-linecap="round" stroke="([^"]+)")re");
    ASSERT_EQ(strokes.size(), 2u);
    EXPECT_NE(strokes[0], strokes[1]);
    for (const std::string& colour : strokes) {
        EXPECT_EQ(all_matches(picture, "(<path stroke=\"" + colour + "\")").size(), 1u);
    }
}

TEST(Svg, MarksTheSitesThatAreNotRegular) {
    const std::string regular = svg(triangle_grid_tile(plane::Lattice::rectangle(1, 1), 3, 2));
    EXPECT_THAT(regular, HasSubstr("valence 6: 6<"));
    EXPECT_THAT(regular, Not(HasSubstr("stroke=\"" + hex(side_colour(6)))));
    plane::Tile tile = triangle_grid_tile(plane::Lattice::rectangle(1, 1), 3, 3);
    // Flip the diagonal of the first square.
    tile.faces.corners[2] = 4;
    tile.faces.corners[3] = 1;
    const std::string picture = svg(tile);
    EXPECT_THAT(picture, HasSubstr("valence 5: 2<"));
    EXPECT_THAT(picture, HasSubstr("valence 7: 2<"));
    EXPECT_THAT(picture, HasSubstr("stroke=\"" + hex(side_colour(5)) + "\""));
}

TEST(Svg, ALongBasisIsDrawnByItsReducedDomain) {
    EXPECT_THAT(svg(grid_tile(plane::Lattice({1, 0}, {0.4, 1}), 3, 2)), HasSubstr(">domain<"));
    EXPECT_THAT(svg(grid_tile(plane::Lattice({1, 0}, {7, 1}), 3, 2)),
                HasSubstr(">reduced domain<"));
}

TEST(Svg, NoElementIsTooLongForParsers) {
    std::istringstream lines(svg(grid_tile(plane::Lattice::rectangle(1, 1), 250, 200)));
    std::size_t longest = 0;
    std::size_t cells = 0;
    for (std::string line; std::getline(lines, line);) {
        longest = std::max(longest, line.size());
        if (line.starts_with("<path fill")) {
            cells += static_cast<std::size_t>(std::count(line.begin(), line.end(), 'Z'));
        }
    }
    EXPECT_LT(longest, 1'200'000u);
    EXPECT_EQ(cells, 50000u);
}

TEST(Svg, NumbersArePlainDecimals) {
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        const std::string picture = svg(grid_tile(lattice, 3, 2));
        EXPECT_THAT(picture, StartsWith("<svg xmlns"));
        EXPECT_TRUE(all_matches(picture, R"((\d\.\d{4,}|\de[+-]?\d|nan|inf|-0[ "]))").empty());
        EXPECT_EQ(picture, svg(grid_tile(lattice, 3, 2)));
    }
}

/// A grid whose columns become wider to the right, by the ratio 1:3.
plane::Tile graded_tile() {
    plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 8, 8);
    for (plane::Vec2& p : tile.points) p.x() = (p.x() + p.x() * p.x()) / 2;
    return tile;
}

TEST(Svg, GrainsAreColouredOneByOne) {
    const plane::Tile tile = testing::grain_grid_tile(plane::Lattice::rectangle(1, 1), 3, 3);
    const std::string picture = svg(tile);
    const auto fills = all_matches(picture, R"re(<path fill="([^"]+)")re");
    EXPECT_THAT(fills.size(), Ge(4u));
    for (const std::string& colour : fills) EXPECT_NE(colour, hex(side_colour(5)));
    EXPECT_THAT(picture, Not(HasSubstr("<rect")));
}

TEST(Svg, DensitiesColourCellsAndSites) {
    const std::vector<double> densities{1, 2, 4, 8, 16, 32};
    const FileOptions options{.site_densities = densities, .colouring = Colouring::kDensity};
    for (const plane::Tile& tile : {grid_tile(plane::Lattice::rectangle(1, 1), 3, 2),
                                    triangle_grid_tile(plane::Lattice::rectangle(1, 1), 3, 2)}) {
        const std::string picture = svg(tile, options);
        EXPECT_THAT(picture, HasSubstr(" by density</title>"));
        for (const char* label : {">1 to 2: 1<", ">8 to 16: 1<", ">32 to 64: 1<"}) {
            EXPECT_THAT(picture, HasSubstr(label));
        }
    }
}

TEST(Svg, TheBackgroundIsNoneOrTheChosenOne) {
    const plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 3, 2);
    const auto with = [&](const char* colour) {
        return svg(tile, {.background = colour_of_hex(colour)});
    };
    // Without a background, text follows the page.
    EXPECT_THAT(svg(tile),
                HasSubstr("@media (prefers-color-scheme: dark) { .ink { fill: #e8eaef }"));
    EXPECT_THAT(svg(tile), HasSubstr("<g class=\"ink\""));
    EXPECT_THAT(all_matches(svg(tile), "(<rect width=\"\\d+\" height=\"\\d+\")").size(), 0u);
    // Text on a given background does not.
    EXPECT_THAT(with("#ffffff"), HasSubstr(" fill=\"#ffffff\"/>"));
    EXPECT_THAT(with("#ffffff"), Not(HasSubstr("<style>")));
    EXPECT_THAT(with("#101418"), HasSubstr("<style>.ink { fill: #e8eaef }"));
}

/// Advance widths of DejaVu Sans, units of em / 2048; other characters do not occur in the labels.
double advance(char c) {
    static const std::map<char, int> kWidths{
        {' ', 651},  {'(', 799},  {')', 799},  {',', 651},  {'-', 739},  {'.', 651},  {'/', 690},
        {':', 690},  {';', 690},  {'=', 1716}, {'0', 1303}, {'1', 1303}, {'2', 1303}, {'3', 1303},
        {'4', 1303}, {'5', 1303}, {'6', 1303}, {'7', 1303}, {'8', 1303}, {'9', 1303}, {'D', 1577},
        {'P', 1235}, {'V', 1401}, {'a', 1255}, {'b', 1300}, {'c', 1126}, {'d', 1300}, {'e', 1260},
        {'f', 721},  {'g', 1300}, {'h', 1298}, {'i', 569},  {'l', 569},  {'m', 1995}, {'n', 1298},
        {'o', 1253}, {'p', 1300}, {'q', 1300}, {'r', 842},  {'s', 1067}, {'t', 803},  {'u', 1298},
        {'v', 1212}, {'y', 1212}, {'z', 1075}, {'+', 1716}};
    return kWidths.at(c) / 2048.0;
}

/// Expects that the canvas holds all of the text, in a wide font; bold text is 1.11 times as wide.
void expect_text_inside(const std::string& picture) {
    static const std::regex kText(R"re(<text x="([\d.]+)" y="([\d.]+)"([^>]*)>([^<]*)<)re");
    const plane::Vec2 edge = canvas(picture);
    int n_texts = 0;
    for (std::sregex_iterator at(picture.begin(), picture.end(), kText), end; at != end; ++at) {
        double width = 0;
        for (const char c : (*at)[4].str()) width += 13 * advance(c);
        if ((*at)[3].str().find("bold") != std::string::npos) width *= 1.11;
        EXPECT_LT(std::stod((*at)[1]) + width, edge.x()) << (*at)[4];
        EXPECT_LT(std::stod((*at)[2]) + 4, edge.y()) << (*at)[4];
        ++n_texts;
    }
    EXPECT_GE(n_texts, 3);
}

TEST(Svg, TheLegendIsNeverCutOff) {
    for (const plane::Lattice& lattice :
         {plane::Lattice::rectangle(1, 1), plane::Lattice::rectangle(40, 1),
          plane::Lattice::rectangle(1, 40), plane::Lattice::rectangle(1, 1.7),
          plane::Lattice({1, 0}, {0.37, 0.81}), plane::Lattice({1, 0}, {7, 0.3})}) {
        for (int n = 1; n <= 8; ++n) {
            for (const plane::Tile& tile :
                 {grid_tile(lattice, n, 1), triangle_grid_tile(lattice, n, 2),
                  grid_tile(lattice, 1, n), testing::grain_grid_tile(lattice, n, 2)}) {
                const std::vector<double> densities{1e-7, 1234567, 1, 3.14159};
                const CellMaterials materials{
                    .phase_names = {"ferrite", "austenite"},
                    .site_phase = {0, 1, 0, 1, 0, 1, 0, 1, 0},
                    .site_orientation = std::vector<BungeAngles>(16, {30, 40, 50})};
                const std::vector<int> orbits{0, 1, 2, 3, 4, 5, 6};
                for (const ColouringRow& row : kColourings) {
                    if (!row.in_plane) continue;
                    expect_text_inside(svg(tile, {.site_densities = densities,
                                                  .materials = &materials,
                                                  .site_orbits = orbits,
                                                  .colouring = row.colouring}));
                }
            }
        }
    }
}

TEST(Svg, GradedPicturesShowSizesFromBlueToYellow) {
    const std::string picture = svg(graded_tile(), {.colouring = Colouring::kSize});
    EXPECT_THAT(picture, HasSubstr("64 cells by size; h = sqrt(area / n)"));
    EXPECT_THAT(picture, Not(HasSubstr("sides")));
    EXPECT_THAT(picture, HasSubstr("fill=\"" + hex(value_colour(0)) + "\""));
    EXPECT_THAT(picture, HasSubstr("fill=\"" + hex(value_colour(1)) + "\""));
    int n_cells = 0;
    for (const std::string& count : all_matches(picture, R"( h: (\d+)<)"))
        n_cells += std::stoi(count);
    EXPECT_EQ(n_cells, 64);
    const auto classes = all_matches(picture, R"(>[\d.]+ to ([\d.]+) h: )");
    EXPECT_THAT(classes.size(), Ge(4u));
    EXPECT_THAT(classes.size(), Le(std::size_t(kValueClasses)));
}

TEST(Svg, GradedPicturesOfEqualCellsHaveOneClass) {
    const std::string picture =
        svg(grid_tile(plane::Lattice::rectangle(1, 1), 4, 4), {.colouring = Colouring::kSize});
    EXPECT_THAT(all_matches(picture, R"( h: (\d+)<)").size(), Le(2u));
}

/// Rounds to three decimals by way of the shortest decimals of a rounded double.
std::string rounded(double value) {
    std::array<char, 40> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(),
                                   std::round(1000 * value) / 1000 + 0.0, std::chars_format::fixed);
    return {digits.begin(), end.ptr};
}

TEST(Svg, PixelsHaveAtMostThreeDecimals) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-5, 11);
    for (int k = 0; k < 20'000; ++k) {
        const double size = std::pow(10, exponent(random));
        for (const double value : {size, -size, std::round(size), std::round(10 * size) / 10}) {
            std::string text;
            append_pixels(text, value);
            ASSERT_EQ(text, rounded(value)) << value;
        }
    }
    std::string text;
    for (const double value : {0.0, -0.0, -0.0004, 0.0005, 10.0}) append_pixels(text += ' ', value);
    EXPECT_EQ(text, " 0 0 0 0.001 10");
}

}  // namespace
}  // namespace pcvt
