#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <random>
#include <regex>
#include <sstream>

#include "io/pictures/svg_canvas.hpp"
#include "io/pictures/svg_writer.hpp"
#include "io/tiles/palette.hpp"
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

std::string svg(const Tile& tile) { return encode_svg(tile, "t.svg").at(0).bytes; }

std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
        found.push_back((*at)[1]);
    }
    return found;
}

/// Width and height of the canvas.
Vec2 canvas(const std::string& picture) {
    const std::smatch match = [&] {
        static const std::regex kViewBox(R"re(viewBox="0 0 ([\d.]+) ([\d.]+)")re");
        std::smatch result;
        EXPECT_TRUE(std::regex_search(picture, result, kViewBox));
        return result;
    }();
    return {std::stod(match[1]), std::stod(match[2])};
}

/// Returns every point of every path.
std::vector<Vec2> path_points(const std::string& picture) {
    std::vector<Vec2> points;
    static const std::regex kPoint(R"([ML](-?[\d.]+) (-?[\d.]+))");
    for (std::sregex_iterator at(picture.begin(), picture.end(), kPoint), end; at != end; ++at) {
        points.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
    }
    return points;
}

TEST(Svg, FitsTheCanvasAtAnyScaleAndAspect) {
    for (const Vec2& size : {Vec2(1, 1), Vec2(20, 1), Vec2(1, 20), Vec2(1e6, 1e6), Vec2(1e-3, 2e-3),
                             Vec2(1, 1000), Vec2(1e59, 1e59)}) {
        for (const Tile& tile :
             {grid_tile(Lattice::rectangle(size.x(), size.y()), 3, 2),
              triangle_grid_tile(Lattice::rectangle(size.x(), size.y()), 3, 2)}) {
            const std::string picture = svg(tile);
            const Vec2 edge = canvas(picture);
            EXPECT_THAT(edge.maxCoeff(), Le(1700));
            EXPECT_THAT(edge.minCoeff(), Ge(100));
            const std::vector<Vec2> points = path_points(picture);
            EXPECT_THAT(points.size(), Ge(4u * 6u));
            for (const Vec2& p : points) {
                EXPECT_TRUE((p.array() >= 19.99).all() &&
                            (p.array() <= edge.array() - 19.99).all());
            }
        }
    }
}

TEST(Svg, TheYAxisPointsUpwards) {
    Tile tile = grid_tile(Lattice::rectangle(1, 1), 1, 1);
    const std::vector<Vec2> points = path_points(svg(tile));
    ASSERT_EQ(tile.points[tile.faces.corners[0]], Vec2(0, 0));
    ASSERT_EQ(tile.points[tile.faces.corners[2]], Vec2(1, 1));
    EXPECT_GT(points[2].x(), points[0].x());
    EXPECT_LT(points[2].y(), points[0].y());
}

TEST(Svg, CellsHaveTheColourOfTheirSides) {
    const std::string picture = svg(grid_tile(Lattice::rectangle(1, 1), 3, 2));
    const auto fills = all_matches(picture, R"re(<path fill="([^"]+)")re");
    EXPECT_THAT(fills, ::testing::ElementsAre(hex(side_colour(4))));
    EXPECT_THAT(picture, HasSubstr("4 sides: 6<"));
    EXPECT_THAT(picture, HasSubstr("<title>Periodic Voronoi tile, 6 cells</title>"));
}

TEST(Svg, GrainsHaveABoundaryBetweenSites) {
    Tile tile = testing::grain_grid_tile(Lattice::rectangle(1, 1), 3, 2);
    tile.whole_sides.assign(std::size_t(tile.n_faces()), 5);
    const std::string picture = svg(tile);
    EXPECT_THAT(picture, HasSubstr("<title>Periodic grains, 12 triangles</title>"));
    EXPECT_THAT(picture, HasSubstr("5 sides<"));
    const auto fills = all_matches(picture, R"re(<path fill="([^"]+)")re");
    EXPECT_THAT(fills, ::testing::ElementsAre(hex(side_colour(5))));
    tile.face_site.assign(std::size_t(tile.n_faces()), 0);
    EXPECT_LT(path_points(svg(tile)).size(), path_points(picture).size());
}

TEST(Svg, PiecesWithoutTheirSiteHaveNoDot) {
    Tile tile = grid_tile(Lattice::rectangle(1, 1), 2, 1);
    tile.site_points = {{0.25, 0.5}, {0.25, 0.5}};
    const std::size_t both = path_points(svg(tile)).size();
    tile.whole_sides = {4, 4};
    EXPECT_EQ(path_points(svg(tile)).size(), both - 1);
}

TEST(Svg, TheSeamOfEachTranslationHasOneColour) {
    Tile tile = grid_tile(Lattice({1, 0}, {0.37, 0.81}), 3, 2);
    for (std::size_t k = 0; k < tile.edge_pairs.size(); k += 2) {
        const EdgePair pair = tile.edge_pairs[k];
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
    const std::string regular = svg(triangle_grid_tile(Lattice::rectangle(1, 1), 3, 2));
    EXPECT_THAT(regular, HasSubstr("valence 6: 6<"));
    EXPECT_THAT(regular, Not(HasSubstr("stroke=\"" + hex(side_colour(6)))));
    Tile tile = triangle_grid_tile(Lattice::rectangle(1, 1), 3, 3);
    // Flip the diagonal of the first square.
    tile.faces.corners[2] = 4;
    tile.faces.corners[3] = 1;
    const std::string picture = svg(tile);
    EXPECT_THAT(picture, HasSubstr("valence 5: 2<"));
    EXPECT_THAT(picture, HasSubstr("valence 7: 2<"));
    EXPECT_THAT(picture, HasSubstr("stroke=\"" + hex(side_colour(5)) + "\""));
}

TEST(Svg, ALongBasisIsDrawnByItsReducedDomain) {
    EXPECT_THAT(svg(grid_tile(Lattice({1, 0}, {0.4, 1}), 3, 2)), HasSubstr(">domain<"));
    EXPECT_THAT(svg(grid_tile(Lattice({1, 0}, {7, 1}), 3, 2)), HasSubstr(">reduced domain<"));
}

TEST(Svg, NoElementIsTooLongForParsers) {
    std::istringstream lines(svg(grid_tile(Lattice::rectangle(1, 1), 250, 200)));
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
    for (const Lattice& lattice : testing::awkward_lattices()) {
        const std::string picture = svg(grid_tile(lattice, 3, 2));
        EXPECT_THAT(picture, StartsWith("<svg xmlns"));
        EXPECT_TRUE(all_matches(picture, R"((\d\.\d{4,}|\de[+-]?\d|nan|inf|-0[ "]))").empty());
        EXPECT_EQ(picture, svg(grid_tile(lattice, 3, 2)));
    }
}

/// A grid whose columns become wider to the right, by the ratio 1:3.
Tile graded_tile() {
    Tile tile = grid_tile(Lattice::rectangle(1, 1), 8, 8);
    for (Vec2& p : tile.points) p.x() = (p.x() + p.x() * p.x()) / 2;
    return tile;
}

TEST(Svg, GradedPicturesShowSizesFromBlueToYellow) {
    const std::string picture = encode_graded_svg(graded_tile(), "t.svg").at(0).bytes;
    EXPECT_THAT(picture, HasSubstr("64 cells by size; h = sqrt(area / n)"));
    EXPECT_THAT(picture, Not(HasSubstr("sides")));
    EXPECT_THAT(picture, HasSubstr("fill=\"" + hex(size_colour(0)) + "\""));
    EXPECT_THAT(picture, HasSubstr("fill=\"" + hex(size_colour(1)) + "\""));
    int n_cells = 0;
    for (const std::string& count : all_matches(picture, R"( h: (\d+)<)"))
        n_cells += std::stoi(count);
    EXPECT_EQ(n_cells, 64);
    const auto classes = all_matches(picture, R"(>[\d.]+ to ([\d.]+) h: )");
    EXPECT_THAT(classes.size(), Ge(4u));
    EXPECT_THAT(classes.size(), Le(9u));
}

TEST(Svg, GradedPicturesOfEqualCellsHaveOneClass) {
    const std::string picture =
        encode_graded_svg(grid_tile(Lattice::rectangle(1, 1), 4, 4), "t.svg").at(0).bytes;
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
