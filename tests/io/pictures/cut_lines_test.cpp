#include "io/pictures/cut_lines.hpp"

#include <gmock/gmock.h>

#include <set>
#include <sstream>
#include <tuple>

#include "io/pictures/dxf_writer.hpp"
#include "io/pictures/svg_cut_writer.hpp"
#include "mesher/plane/tile/build_tile.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

plane::Tile tile_to_cut(const plane::Lattice& lattice, plane::MeshKind kind,
                        plane::Outline outline) {
    const plane::PeriodicDelaunay delaunay(plane::Sites(lattice, uniform_points(lattice, 25, 5)));
    plane::TileOptions options;
    options.kind = kind;
    options.outline = outline;
    return build_tile(delaunay, options).tile;
}

std::vector<plane::Tile> tiles() {
    const plane::Lattice oblique({1, 0}, {0.37, 0.81});
    return {tile_to_cut(oblique, plane::MeshKind::kVoronoi, plane::Outline::kWhole),
            tile_to_cut(oblique, plane::MeshKind::kVoronoi, plane::Outline::kBox),
            tile_to_cut(oblique, plane::MeshKind::kDelaunay, plane::Outline::kWhole),
            tile_to_cut(oblique, plane::MeshKind::kGrains, plane::Outline::kWhole)};
}

using Ends = std::set<std::pair<double, double>>;

Ends ends(const plane::Vec2& from, const plane::Vec2& to) {
    return {{from.x(), from.y()}, {to.x(), to.y()}};
}

/// A line of a file with its layer.
struct FileLine {
    std::string layer;
    plane::Vec2 from;
    plane::Vec2 to;
};

/// Reads the LINE entities of a DXF, group by group.
std::vector<FileLine> dxf_lines(const std::string& text) {
    std::vector<FileLine> lines;
    std::istringstream stream(text);
    int code = 0;
    std::string value;
    bool in_line = false;
    while (stream >> code && std::getline(stream >> std::ws, value)) {
        if (code == 0) {
            in_line = value == "LINE";
            if (in_line) lines.push_back({"", plane::Vec2::Zero(), plane::Vec2::Zero()});
        }
        if (!in_line) continue;
        if (code == 8) lines.back().layer = value;
        if (code == 10) lines.back().from.x() = std::stod(value);
        if (code == 20) lines.back().from.y() = std::stod(value);
        if (code == 11) lines.back().to.x() = std::stod(value);
        if (code == 21) lines.back().to.y() = std::stod(value);
    }
    return lines;
}

/// Reads the paths of an SVG for cutters.
std::vector<FileLine> svg_lines(const std::string& text) {
    std::vector<FileLine> lines;
    std::istringstream stream(text);
    std::string layer;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("<g id=\"")) layer = line.substr(7, line.find('"', 7) - 7);
        if (!line.starts_with("<path d=\"M")) continue;
        std::istringstream numbers(line.substr(10));
        char separator = 0;
        FileLine found{layer, plane::Vec2::Zero(), plane::Vec2::Zero()};
        numbers >> found.from.x() >> found.from.y() >> separator >> found.to.x() >> found.to.y();
        EXPECT_EQ(separator, 'L');
        lines.push_back(found);
    }
    return lines;
}

void expect_each_edge_once(const std::vector<FileLine>& lines, const plane::Tile& tile) {
    std::set<Ends> distinct;
    std::size_t n_seam = 0;
    for (const FileLine& line : lines) {
        EXPECT_TRUE(distinct.insert(ends(line.from, line.to)).second);
        EXPECT_TRUE(line.layer == "CUT" || line.layer == "SEAM") << line.layer;
        n_seam += line.layer == "SEAM";
    }
    // Euler's formula of a disc.
    EXPECT_EQ(std::ssize(distinct), tile.n_vertices() + tile.n_faces() - 1);
    EXPECT_EQ(n_seam, 2 * tile.edge_pairs.size());
}

TEST(CutLines, HaveEachEdgeOnce) {
    for (const plane::Tile& tile : tiles()) {
        expect_each_edge_once(dxf_lines(encode_dxf(tile, {}, "t.dxf")[0].bytes), tile);
        expect_each_edge_once(svg_lines(encode_svg_cut(tile, 200, "t.svg")[0].bytes), tile);
    }
}

TEST(CutLines, HaveTheWidthInMillimetres) {
    for (const plane::Tile& tile : tiles()) {
        const CutLines lines = cut_lines(tile, 300);
        plane::Vec2 low = lines.seam.front().from;
        plane::Vec2 high = low;
        for (const CutLine& line : lines.seam) {
            low = low.cwiseMin(line.from).cwiseMin(line.to);
            high = high.cwiseMax(line.from).cwiseMax(line.to);
        }
        EXPECT_EQ(low, plane::Vec2::Zero());
        EXPECT_EQ(high, lines.size);
        EXPECT_NEAR(high.x(), 300, 1e-9);
        const std::string svg = encode_svg_cut(tile, 300, "t.svg")[0].bytes;
        EXPECT_THAT(svg, HasSubstr(" width=\"300"));
        EXPECT_THAT(svg, HasSubstr("mm\" viewBox=\"0 0 300"));
        EXPECT_THAT(svg, HasSubstr("fill=\"none\""));
    }
}

TEST(CutLines, KeepTheUnitWithoutAWidth) {
    const plane::Tile box = tile_to_cut(plane::Lattice::rectangle(3, 2), plane::MeshKind::kVoronoi,
                                        plane::Outline::kBox);
    double seam = 0;
    for (const FileLine& line : dxf_lines(encode_dxf(box, {}, "t.dxf")[0].bytes)) {
        if (line.layer == "SEAM") seam += (line.to - line.from).norm();
    }
    EXPECT_NEAR(seam, 10, 1e-9);
    const CutLines scaled = cut_lines(box, 30);
    EXPECT_NEAR(scaled.size.y(), 20, 1e-9);
}

}  // namespace
}  // namespace pcvt
