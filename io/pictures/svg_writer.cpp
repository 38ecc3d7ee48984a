#include "io/pictures/svg_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "io/colours/colouring.hpp"
#include "io/colours/palette.hpp"
#include "io/forms/finite.hpp"
#include "io/pictures/svg_canvas.hpp"
#include "io/pictures/svg_domain.hpp"
#include "io/pictures/svg_legend.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt {
namespace {

constexpr const char* kEdgeColour = "#565c68";
constexpr const char* kGradedEdgeColour = "#262a33";
constexpr const char* kTriangleEdgeColour = "#8b919c";
constexpr const char* kPaleColour = "#f3efe4";
constexpr const char* kDotColour = "#30343c";
constexpr const char* kDomainColour = "#1c1f26";
constexpr const char* kWallColour = "#4a4f5c";
/// Lies under the dashes, so that they are visible on cells and pages of every lightness.
constexpr const char* kDomainCasing = "#ffffff";
/// Below this spacing in pixels, dots would merge into grey.
constexpr double kLeastDottedSpacing = 9;

/// A tile with its colours, its position on the canvas, and the spacing h of its sites in pixels.
struct Drawing {
    const plane::Tile& tile;
    const TileColours& colours;
    SvgFrame frame;
    double spacing;

    /// Returns a width of `fraction` of the spacing, limited so that lines remain visible and do
    /// not cover the cells.
    double width(double fraction, double least, double most) const {
        return std::clamp(fraction * spacing, least, most);
    }
};

/// Returns the number of sites; all pieces of one cell or grain count once.
int count_drawn_sites(const plane::Tile& tile) {
    if (tile.kind == plane::MeshKind::kDelaunay) {
        return tile.n_vertices() - static_cast<int>(tile.vertex_pairs.size());
    }
    if (tile.whole_sides.empty()) return tile.n_faces();
    return static_cast<int>(std::set<SiteId>(tile.face_site.begin(), tile.face_site.end()).size());
}

/// Returns the same offset for (i, j) and (-i, -j), which belong to one translation class.
plane::Offset translation_class(plane::Offset offset) {
    return offset < plane::Offset{} ? -offset : offset;
}

/// Returns the translation classes with their colours. (1, 0) and (0, 1) come first, so that they
/// have the same colours in every picture.
std::vector<std::pair<plane::Offset, std::string>> seam_colours(const plane::Tile& tile) {
    std::set<std::tuple<int, plane::Offset>> classes;
    for (const plane::EdgePair& pair : tile.edge_pairs) {
        const plane::Offset offset = translation_class(pair.offset);
        classes.emplace(std::abs(offset.i) + std::abs(offset.j), -offset);
    }
    std::vector<std::pair<plane::Offset, std::string>> colours;
    for (const auto& [length, negative] : classes) {
        colours.emplace_back(-negative, hex(seam_colour(colours.size())));
    }
    return colours;
}

std::string fill(const std::string& colour) { return " fill=\"" + colour + "\""; }

void add_face(const plane::Tile& tile, int face, SvgPath& path) {
    path.move(tile.points[tile.faces[face].front()]);
    for (const int v : tile.faces[face].subspan(1)) path.line(tile.points[v]);
    path.close();
}

/// Returns whether a face contains its site; some pieces of a cut cell do not.
bool holds_site(const plane::Tile& tile, int face) {
    if (tile.whole_sides.empty()) return true;
    const plane::Vec2& site = tile.site_points[face];
    const plane::Vec2* from = &tile.points[tile.faces[face].back()];
    for (const int v : tile.faces[face]) {
        const plane::Vec2& to = tile.points[v];
        if (plane::cross(to - *from, site - *from) < 0) return false;
        from = &to;
    }
    return true;
}

/// Draws the faces, one path per colour, with edges of these attributes.
std::string draw_coloured(const Drawing& drawing, const std::string& edge) {
    const plane::Tile& tile = drawing.tile;
    std::vector<SvgPath> by_class(drawing.colours.classes.size(), SvgPath(drawing.frame));
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        add_face(tile, f, by_class[drawing.colours.class_of[f]]);
    }
    std::string svg;
    for (std::size_t k = 0; k < by_class.size(); ++k) {
        svg += by_class[k].element(fill(hex(drawing.colours.classes[k].colour)).append(edge));
    }
    return svg;
}

std::string draw_cells(const Drawing& drawing, bool graded) {
    const plane::Tile& tile = drawing.tile;
    const double edge_width = drawing.width(0.03, 0.06, 1.6);
    std::string svg =
        draw_coloured(drawing, svg_stroke(graded ? kGradedEdgeColour : kEdgeColour, edge_width));
    if (graded || drawing.spacing < kLeastDottedSpacing) return svg;
    // Dots lie over the cells.
    SvgPath dots(drawing.frame);
    for (int f = 0; f < tile.n_faces() && !tile.site_points.empty(); ++f) {
        if (holds_site(tile, f)) dots.dot(tile.site_points[f]);
    }
    return svg + dots.element(svg_stroke(kDotColour, drawing.width(0.09, 0.6, 6)));
}

/// Returns the edges between triangles of different sites.
SvgPath grain_boundaries(const Drawing& drawing) {
    const plane::Tile& tile = drawing.tile;
    std::map<std::pair<int, int>, SiteId> site_at;
    SvgPath path(drawing.frame);
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        int v = tile.faces[f].back();
        for (const int w : tile.faces[f]) {
            const int from = std::exchange(v, w);
            const auto [edge, is_new] =
                site_at.try_emplace(std::minmax(from, w), tile.face_site[f]);
            if (is_new || edge->second == tile.face_site[f]) continue;
            path.move(tile.points[from]).line(tile.points[w]);
        }
    }
    return path;
}

std::string draw_grains(const Drawing& drawing) {
    return draw_coloured(drawing, svg_stroke(kTriangleEdgeColour, drawing.width(0.01, 0.03, 0.8))) +
           grain_boundaries(drawing).element(svg_stroke(kEdgeColour, drawing.width(0.04, 0.08, 2)));
}

std::string draw_triangles(const Drawing& drawing) {
    const plane::Tile& tile = drawing.tile;
    SvgPath faces(drawing.frame);
    for (int f = 0; f < tile.n_faces(); ++f) add_face(tile, f, faces);
    return faces.element(fill(kPaleColour) +
                         svg_stroke(kTriangleEdgeColour, drawing.width(0.03, 0.05, 1.6)));
}

std::string draw_faces(const Drawing& drawing, bool graded) {
    const plane::MeshKindRow& kind = mesh_kind_row(drawing.tile.kind);
    if (!kind.faces_have_sites) return draw_triangles(drawing);
    return kind.grain_size ? draw_grains(drawing) : draw_cells(drawing, graded);
}

/// Draws the marks of sites, which lie over the seam so that none of them is partly hidden.
std::string draw_sites(const Drawing& drawing) {
    const plane::Tile& tile = drawing.tile;
    std::vector<SvgPath> by_class(drawing.colours.classes.size(), SvgPath(drawing.frame));
    for (int v = 0; v < tile.n_vertices(); ++v) {
        checkpoint_each(v);
        by_class[drawing.colours.class_of[v]].dot(tile.points[v]);
    }
    std::string svg;
    const bool dense = drawing.spacing < kLeastDottedSpacing;
    const double size = dense ? 0.7 * drawing.spacing : drawing.width(0.36, 3, 16);
    const double rim = drawing.width(0.06, 0.3, 2);
    const double dot = drawing.width(0.09, 0.6, 6);
    for (std::size_t k = 0; k < by_class.size(); ++k) {
        const ColourClass& mark = drawing.colours.classes[k];
        const bool regular = mark.name == kRegularClass;
        if (!dense) svg += by_class[k].element(svg_stroke(kDotColour, regular ? dot : size + rim));
        if (!regular) svg += by_class[k].element(svg_stroke(hex(mark.colour), size));
    }
    return svg;
}

std::string draw_domain(const std::vector<plane::Vec2>& corners, const Drawing& drawing) {
    SvgPath path(drawing.frame);
    path.move(corners[0]).line(corners[1]).line(corners[2]).line(corners[3]).close();
    const double width = drawing.width(0.04, 0.8, 1.4);
    return path.element(svg_stroke(kDomainCasing, width + 0.8) + " stroke-opacity=\"0.75\"") +
           path.element(" stroke-dasharray=\"6 4\"" + svg_stroke(kDomainColour, width));
}

std::string draw_seam(const Drawing& drawing) {
    const plane::Tile& tile = drawing.tile;
    std::string svg;
    for (const auto& [offset, colour] : seam_colours(tile)) {
        SvgPath path(drawing.frame);
        for (const plane::EdgePair& pair : tile.edge_pairs) {
            if (translation_class(pair.offset) != offset) continue;
            path.move(tile.points[pair.v0]).line(tile.points[pair.v1]);
            path.move(tile.points[pair.w0]).line(tile.points[pair.w1]);
        }
        svg += path.element(svg_stroke(colour, drawing.width(0.09, 1.1, 5)));
    }
    if (tile.wall_edges.empty()) return svg;
    SvgPath walls(drawing.frame);
    for (const plane::WallEdge& edge : tile.wall_edges) {
        walls.move(tile.points[edge.v0]).line(tile.points[edge.v1]);
    }
    return svg + walls.element(svg_stroke(kWallColour, drawing.width(0.13, 1.6, 7)));
}

/// The names of the walls without their prefix, and of the holes: "bottom, top, fibre".
std::string wall_names(const plane::Tile& tile) {
    constexpr std::size_t kPrefix = std::string_view("wall_").size();
    std::string names;
    for (const WallSideRow& row : kWallSides) {
        if (!has_walls_across(tile.walls, row.axis)) continue;
        names += (names.empty() ? "" : ", ") + std::string(row.word).substr(kPrefix);
    }
    for (const std::string& hole : tile.holes) names += (names.empty() ? "" : ", ") + hole;
    return names;
}

std::string counted(int n, const std::string& noun) {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

std::string caption(const plane::Tile& tile) {
    const int n = count_drawn_sites(tile);
    const std::string triangles = counted(tile.n_faces(), "triangle");
    const plane::MeshKindRow& kind = mesh_kind_row(tile.kind);
    const bool has_walls = tile.walls != Walls::kNone;
    const std::string tile_word = has_walls ? " tile between walls, " : " tile, ";
    const std::string periodic = has_walls ? "" : "Periodic ";
    if (!kind.faces_have_sites) {
        return periodic + "Delaunay" + tile_word + counted(n, "site") + ", " + triangles;
    }
    if (kind.grain_size) {
        return (has_walls ? "Grains between walls, " : "Periodic grains, ") + triangles;
    }
    // Walls cut cells in halves; each half is the only piece of its cell.
    const bool are_cells = tile.whole_sides.empty() || (has_walls && n == tile.n_faces());
    return periodic + "Voronoi" + tile_word +
           (are_cells ? counted(n, "cell") : counted(tile.n_faces(), "piece") + " of cells");
}

std::vector<LegendEntry> colour_entries(const plane::Tile& tile, const TileColours& colours) {
    const bool owned = faces_have_sites(tile.kind);
    std::vector<LegendEntry> entries;
    for (const ColourClass& shown : colours.classes) {
        if (shown.label.empty()) continue;
        const bool dotted = !owned && shown.name == kRegularClass;
        entries.push_back({owned ? LegendEntry::Mark::kPatch : LegendEntry::Mark::kDisc,
                           dotted ? kDotColour : hex(shown.colour), shown.label});
    }
    return entries;
}

Legend make_legend(const plane::Tile& tile, const SvgDomain& domain, const TileColours& colours) {
    Legend legend{caption(tile) + colours.explanation, colour_entries(tile, colours)};
    for (const auto& [offset, colour] : seam_colours(tile)) {
        const std::string pair = std::to_string(offset.i) + ", " + std::to_string(offset.j);
        legend.entries.push_back({LegendEntry::Mark::kStroke, colour, "seam (" + pair + ")"});
    }
    if (!tile.wall_edges.empty()) {
        legend.entries.push_back(
            {LegendEntry::Mark::kStroke, kWallColour, "walls: " + wall_names(tile)});
    }
    legend.entries.push_back({LegendEntry::Mark::kDashes, kDomainColour, domain.label});
    return legend;
}

std::string encode(const plane::Tile& tile, const FileOptions& options) {
    require_finite(tile);
    // The frame includes the tile and the fundamental domain.
    const SvgDomain domain = drawn_domain(tile);
    std::vector<plane::Vec2> drawn = tile.points;
    drawn.insert(drawn.end(), domain.corners.begin(), domain.corners.end());
    const SvgFrame frame(drawn);
    const double spacing = frame.scale() * std::sqrt(tile.lattice.area() / count_drawn_sites(tile));
    // The legend explains the colours and determines the size of the canvas.
    const Colouring colouring =
        options.colouring.value_or(default_picture_colouring(tile, options.quantities()));
    const TileColours colours = tile_colours(tile, colouring, options.quantities());
    const Drawing drawing{tile, colours, frame, spacing};
    const Legend legend = make_legend(tile, domain, colours);
    const PlacedLegend placed = place_legend(legend, frame);

    // Draw from the bottom to the top.
    std::string svg = svg_head(legend.caption, placed.width, placed.height, options.background);
    svg += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    svg += draw_faces(drawing, colouring_row(colouring).shows_values);
    svg += draw_domain(domain.corners, drawing);
    svg += draw_seam(drawing);
    if (tile.kind == plane::MeshKind::kDelaunay) svg += draw_sites(drawing);
    svg += "</g>\n" + svg_text_group();
    return svg + placed.svg + "</g>\n</svg>\n";
}

}  // namespace

std::vector<EncodedFile> encode_svg(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    return only_file(path, encode(tile, options));
}

}  // namespace pcvt
