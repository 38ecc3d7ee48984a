#include "io/page/html_writer.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "io/colours/site_classes.hpp"
#include "io/page/page_parts.hpp"
#include "mesher/base/error.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using testing::grain_grid_tile;
using testing::grid_tile;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using testing::triangle_grid_tile;

constexpr std::string_view kDataBegin = R"(<script type="application/json" id="data">)";

std::string html(const plane::Tile& tile, const std::string& path = "t.html") {
    return encode_html(tile, {}, path).at(0).bytes;
}

/// Returns the text of the element `data` as a browser sees it: up to the first end of a script.
std::string data_text(const std::string& page) {
    const std::size_t begin = page.find(kDataBegin) + kDataBegin.size();
    return page.substr(begin, page.find("</script", begin) - begin);
}

nlohmann::json parsed_data(const std::string& page) {
    return nlohmann::json::parse(data_text(page));
}

std::vector<double> flat(const std::vector<plane::Vec2>& points) {
    std::vector<double> numbers;
    for (const plane::Vec2& p : points) numbers.insert(numbers.end(), {p.x(), p.y()});
    return numbers;
}

std::vector<plane::Tile> tiles_of(const plane::Lattice& lattice) {
    return {grid_tile(lattice, 1, 1), grid_tile(lattice, 5, 3), triangle_grid_tile(lattice, 4, 3),
            grain_grid_tile(lattice, 3, 4)};
}

void expect_same_tile(const nlohmann::json& json, const plane::Tile& tile) {
    EXPECT_EQ(json["points"].get<std::vector<double>>(), flat(tile.points));
    EXPECT_EQ(json["site_points"].get<std::vector<double>>(), flat(tile.site_points));
    ASSERT_EQ(json["faces"].size(), static_cast<std::size_t>(tile.n_faces()));
    for (int f = 0; f < tile.n_faces(); ++f) {
        const auto face = tile.faces[f];
        EXPECT_EQ(json["faces"][static_cast<std::size_t>(f)].get<std::vector<int>>(),
                  std::vector<int>(face.begin(), face.end()));
    }
    const bool owned = faces_have_sites(tile.kind);
    EXPECT_EQ(json["sites"].get<std::vector<int>>(), owned ? tile.face_site : tile.vertex_site);
    std::vector<plane::VertexPair> vertex_pairs;
    for (const nlohmann::json& p : json["vertex_pairs"]) {
        vertex_pairs.push_back({p[0], p[1], {p[2], p[3]}});
    }
    EXPECT_EQ(vertex_pairs, tile.vertex_pairs);
    std::vector<plane::EdgePair> edge_pairs;
    for (const nlohmann::json& p : json["edge_pairs"]) {
        edge_pairs.push_back(
            {.v0 = p[0], .v1 = p[1], .w0 = p[2], .w1 = p[3], .offset = {p[4], p[5]}});
    }
    EXPECT_EQ(edge_pairs, tile.edge_pairs);
}

TEST(HtmlPage, Law1TheDataGivesTheTileBackExactly) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const plane::Tile& tile : tiles_of(lattice)) {
            SCOPED_TRACE(name);
            const nlohmann::json json = parsed_data(html(tile));
            EXPECT_EQ(json["lattice"][0].get<std::vector<double>>(), flat({lattice.a()}));
            EXPECT_EQ(json["lattice"][1].get<std::vector<double>>(), flat({lattice.b()}));
            expect_same_tile(json, tile);
        }
    }
}

TEST(HtmlPage, EdgesOnWallsNameTheirWall) {
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        for (const plane::Tile& tile : testing::walled_tiles(walls)) {
            const nlohmann::json json = parsed_data(html(tile));
            expect_same_tile(json, tile);
            EXPECT_EQ(json["walls"][0] == 1, has_walls_across(walls, 0));
            EXPECT_EQ(json["walls"][1] == 1, has_walls_across(walls, 1));
            ASSERT_EQ(json["wall_edges"].size(), tile.wall_edges.size());
            for (std::size_t k = 0; k < tile.wall_edges.size(); ++k) {
                const plane::WallEdge& edge = tile.wall_edges[k];
                const nlohmann::json wanted{edge.v0, edge.v1, wall_side_row(edge.wall.side()).word};
                EXPECT_EQ(json["wall_edges"][k], wanted);
            }
        }
    }
    EXPECT_FALSE(
        parsed_data(html(grid_tile(plane::Lattice::rectangle(1, 1), 2, 2))).contains("walls"));
}

TEST(HtmlPage, OrbitsHaveNumbersOfSitesAndColoursOfFaces) {
    const std::vector<int> orbits{0, 1, 1, 0};
    const FileOptions options{.site_orbits = orbits, .colouring = Colouring::kOrbit};
    const auto data = [&](const plane::Tile& tile, const FileOptions& given) {
        return parsed_data(encode_html(tile, given, "t.html").at(0).bytes);
    };
    for (const plane::Tile& tile : {grid_tile(plane::Lattice::rectangle(1, 1), 2, 2),
                                    grain_grid_tile(plane::Lattice::rectangle(1, 1), 2, 2)}) {
        const nlohmann::json json = data(tile, options);
        EXPECT_EQ(json["colouring"], "orbit");
        EXPECT_EQ(json["orbits"].get<std::vector<int>>(), orbits);
        EXPECT_EQ(json["orbit_classes"].get<std::vector<int>>(), site_classes(tile, orbits));
        EXPECT_THAT(data(tile, {})["orbit_classes"], IsEmpty());
    }
    const plane::Tile triangles = triangle_grid_tile(plane::Lattice::rectangle(1, 1), 2, 2);
    EXPECT_THAT(data(triangles, options)["orbit_classes"], IsEmpty());
}

TEST(HtmlPage, Law2NoNameEndsTheData) {
    const std::string name = "</script><!--\"&\\\x01\n.html";
    const std::string page = html(grid_tile(plane::Lattice::rectangle(1, 1), 2, 2), "a/x" + name);
    // A slash separates folders: the name of the file begins after it.
    EXPECT_EQ(parsed_data(page)["name"], name.substr(2));
    EXPECT_THAT(data_text(page), Not(HasSubstr("<")));
    EXPECT_THAT(page, HasSubstr("<title>script&gt;&lt;!--&quot;&amp;\\"));
}

TEST(HtmlPage, Law2MarksOfThePageInANameAreLeftAlone) {
    const std::string page =
        html(grid_tile(plane::Lattice::rectangle(1, 1), 2, 2), "@DATA@@SCRIPT@.html");
    EXPECT_EQ(parsed_data(page)["name"], "@DATA@@SCRIPT@.html");
    EXPECT_THAT(page, HasSubstr("<title>@DATA@@SCRIPT@.html</title>"));
}

TEST(HtmlPage, Law3ThePageIsSmallAndNeedsNoNetwork) {
    const std::string page = html(grid_tile(plane::Lattice::rectangle(1, 1), 30, 30));
    EXPECT_LT(page.size() - data_text(page).size(), 300'000u);
    EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
    EXPECT_THAT(page, HasSubstr("Content-Security-Policy"));
    EXPECT_THAT(page, Not(HasSubstr("https:")));
    for (const char* mark : {"@TITLE@", "@STYLE@", "@DATA@", "@SCRIPT@"}) {
        EXPECT_THAT(page, Not(HasSubstr(mark)));
    }
}

TEST(HtmlPage, NoScriptOrStyleEndsItsOwnElement) {
    EXPECT_THAT(std::string(kPageScript), Not(HasSubstr("</script")));
    EXPECT_THAT(std::string(kPageScript), Not(HasSubstr("<!--")));
    EXPECT_THAT(std::string(kPageStyle), Not(HasSubstr("<")));
}

TEST(HtmlPage, DensitiesAreThereWhenTheMeshIsGraded) {
    const plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 2, 1);
    const std::vector<double> densities{0.1, 1e-300};
    const nlohmann::json graded =
        parsed_data(encode_html(tile, {.site_densities = densities}, "t.html").at(0).bytes);
    EXPECT_EQ(graded["colouring"], "size");
    EXPECT_EQ(graded["densities"].get<std::vector<double>>(), densities);
    const nlohmann::json uniform = parsed_data(html(tile));
    EXPECT_EQ(uniform["colouring"], "sides");
    EXPECT_THAT(uniform["densities"], IsEmpty());
}

TEST(HtmlPage, SidesAreThoseOfTheFacesOrTheValencesOfTheVertices) {
    const plane::Lattice square = plane::Lattice::rectangle(1, 1);
    EXPECT_THAT(parsed_data(html(grid_tile(square, 2, 1)))["sides"], ElementsAre(4, 4));
    const plane::Tile triangles = triangle_grid_tile(square, 3, 3);
    const nlohmann::json valences = parsed_data(html(triangles))["sides"];
    EXPECT_EQ(valences, nlohmann::json(std::vector<int>(triangles.points.size(), 6)));
}

TEST(HtmlPage, CoordinatesThatAreNotFiniteAreRefused) {
    plane::Tile tile = grid_tile(plane::Lattice::rectangle(1, 1), 2, 1);
    tile.points[2].x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(encode_html(tile, {}, "t.html"), InternalError);
}

}  // namespace
}  // namespace pcvt
