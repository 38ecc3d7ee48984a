#include "io/pictures/svg_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "io/pictures/cell_colours.hpp"
#include "io/pictures/svg_canvas.hpp"
#include "io/pictures/svg_domain.hpp"
#include "io/pictures/svg_legend.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/palette.hpp"
#include "mesher/lattice/polygon.hpp"
#include "mesher/mesh/valence.hpp"
#include "mesher/tile/tile_valence.hpp"

namespace pcvt {
namespace {

constexpr const char* kEdgeColour = "#565c68";
constexpr const char* kGradedEdgeColour = "#262a33";
constexpr const char* kTriangleEdgeColour = "#8b919c";
constexpr const char* kDotColour = "#30343c";
constexpr const char* kDomainColour = "#1c1f26";
/// Hues that no cell has, one per translation class; a whole outline has at most four classes.
constexpr std::array kSeamColours{"#0a8f63", "#8a36b5", "#d9187f", "#6f7600", "#0099a8", "#5d4037"};
/// Below this spacing in pixels, dots would merge into grey.
constexpr double kLeastDottedSpacing = 9;
constexpr int kRegular = 6;

/// A tile, its position on the canvas, and the spacing h of its sites in pixels.
struct Drawing {
    const Tile& tile;
    SvgFrame frame;
    double spacing;

    /// Returns a width of `fraction` of the spacing, limited so that lines remain visible and do
    /// not cover the cells.
    double width(double fraction, double least, double most) const {
        return std::clamp(fraction * spacing, least, most);
    }
};

/// Returns the number of sites; all pieces of one cell or grain count once.
int count_sites(const Tile& tile) {
    if (tile.kind == MeshKind::kDelaunay) {
        return tile.n_vertices() - static_cast<int>(tile.vertex_pairs.size());
    }
    if (tile.whole_sides.empty()) return tile.n_faces();
    return static_cast<int>(std::set<SiteId>(tile.face_site.begin(), tile.face_site.end()).size());
}

/// Returns the same offset for (i, j) and (-i, -j), which belong to one translation class.
Offset translation_class(Offset offset) { return offset < Offset{} ? -offset : offset; }

/// Returns the translation classes with their colours. (1, 0) and (0, 1) come first, so that they
/// have the same colours in every picture.
std::vector<std::pair<Offset, std::string>> seam_colours(const Tile& tile) {
    std::set<std::tuple<int, Offset>> classes;
    for (const EdgePair& pair : tile.edge_pairs) {
        const Offset offset = translation_class(pair.offset);
        classes.emplace(std::abs(offset.i) + std::abs(offset.j), -offset);
    }
    std::vector<std::pair<Offset, std::string>> colours;
    for (const auto& [length, negative] : classes) {
        colours.emplace_back(-negative, kSeamColours[colours.size() % kSeamColours.size()]);
    }
    return colours;
}

std::string stroke(const std::string& colour, double width) {
    return " stroke=\"" + colour + "\"" + svg_attribute("stroke-width", width);
}

std::string fill(const std::string& colour) { return " fill=\"" + colour + "\""; }

void add_face(const Tile& tile, int face, SvgPath& path) {
    path.move(tile.points[tile.faces[face].front()]);
    for (const int v : tile.faces[face].subspan(1)) path.line(tile.points[v]);
    path.close();
}

/// Returns whether a face contains its site; some pieces of a cut cell do not.
bool holds_site(const Tile& tile, int face) {
    if (tile.whole_sides.empty()) return true;
    const Vec2& site = tile.site_points[face];
    const Vec2* from = &tile.points[tile.faces[face].back()];
    for (const int v : tile.faces[face]) {
        const Vec2& to = tile.points[v];
        if (cross(to - *from, site - *from) < 0) return false;
        from = &to;
    }
    return true;
}

std::string draw_cells(const Drawing& drawing, const CellColours& colours, bool dotted) {
    // One path per colour, and one for all dots.
    const Tile& tile = drawing.tile;
    std::map<std::string, SvgPath> by_colour;
    SvgPath dots(drawing.frame);
    for (int f = 0; f < tile.n_faces(); ++f) {
        add_face(tile, f, by_colour.try_emplace(colours.of_face[f], drawing.frame).first->second);
    }
    for (int f = 0; f < tile.n_faces() && !tile.site_points.empty(); ++f) {
        if (holds_site(tile, f)) dots.dot(tile.site_points[f]);
    }
    // Dots lie over the cells.
    std::string svg;
    const std::string edge =
        stroke(dotted ? kEdgeColour : kGradedEdgeColour, drawing.width(0.03, 0.06, 1.6));
    for (const auto& [colour, path] : by_colour) {
        svg += path.element(fill(colour).append(edge));
    }
    if (dotted && drawing.spacing >= kLeastDottedSpacing) {
        svg += dots.element(stroke(kDotColour, drawing.width(0.09, 0.6, 6)));
    }
    return svg;
}

/// Returns the edges between triangles of different sites.
SvgPath grain_boundaries(const Drawing& drawing) {
    const Tile& tile = drawing.tile;
    std::map<std::pair<int, int>, SiteId> site_at;
    SvgPath path(drawing.frame);
    for (int f = 0; f < tile.n_faces(); ++f) {
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

std::string draw_grains(const Drawing& drawing, const CellColours& colours) {
    const Tile& tile = drawing.tile;
    std::map<std::string, SvgPath> by_colour;
    for (int f = 0; f < tile.n_faces(); ++f) {
        add_face(tile, f, by_colour.try_emplace(colours.of_face[f], drawing.frame).first->second);
    }
    std::string svg;
    const std::string edge = stroke(kTriangleEdgeColour, drawing.width(0.01, 0.03, 0.8));
    for (const auto& [colour, path] : by_colour) svg += path.element(fill(colour).append(edge));
    return svg +
           grain_boundaries(drawing).element(stroke(kEdgeColour, drawing.width(0.04, 0.08, 2)));
}

std::string draw_triangles(const Drawing& drawing) {
    const Tile& tile = drawing.tile;
    SvgPath faces(drawing.frame);
    for (int f = 0; f < tile.n_faces(); ++f) add_face(tile, f, faces);
    return faces.element(fill(hex(side_colour(kRegular))) +
                         stroke(kTriangleEdgeColour, drawing.width(0.03, 0.05, 1.6)));
}

std::string draw_faces(const Drawing& drawing, const CellColours& colours, bool dotted) {
    const MeshKindRow& kind = mesh_kind_row(drawing.tile.kind);
    if (!kind.faces_have_sites) return draw_triangles(drawing);
    return kind.grain_size ? draw_grains(drawing, colours) : draw_cells(drawing, colours, dotted);
}

/// Draws the marks of valences, which lie over the seam so that none of them is partly hidden.
std::string draw_valences(const Drawing& drawing) {
    const Tile& tile = drawing.tile;
    const std::vector<int> valences = vertex_valences(tile);
    std::map<int, SvgPath> by_valence;
    for (int v = 0; v < tile.n_vertices(); ++v) {
        by_valence.try_emplace(valences[v], drawing.frame).first->second.dot(tile.points[v]);
    }
    std::string svg;
    const bool dense = drawing.spacing < kLeastDottedSpacing;
    const double size = dense ? 0.7 * drawing.spacing : drawing.width(0.36, 3, 16);
    for (const auto& [valence, path] : by_valence) {
        const bool regular = valence == kRegular;
        const double rim = drawing.width(0.06, 0.3, 2);
        const double dot = drawing.width(0.09, 0.6, 6);
        if (!dense) svg += path.element(stroke(kDotColour, regular ? dot : size + rim));
        if (!regular) svg += path.element(stroke(hex(side_colour(valence)), size));
    }
    return svg;
}

std::string draw_domain(const std::vector<Vec2>& corners, const Drawing& drawing) {
    SvgPath path(drawing.frame);
    path.move(corners[0]).line(corners[1]).line(corners[2]).line(corners[3]).close();
    return path.element(" stroke-dasharray=\"6 4\"" +
                        stroke(kDomainColour, drawing.width(0.04, 0.8, 1.4)));
}

std::string draw_seam(const Drawing& drawing) {
    const Tile& tile = drawing.tile;
    std::string svg;
    for (const auto& [offset, colour] : seam_colours(tile)) {
        SvgPath path(drawing.frame);
        for (const EdgePair& pair : tile.edge_pairs) {
            if (translation_class(pair.offset) != offset) continue;
            path.move(tile.points[pair.v0]).line(tile.points[pair.v1]);
            path.move(tile.points[pair.w0]).line(tile.points[pair.w1]);
        }
        svg += path.element(stroke(colour, drawing.width(0.09, 1.1, 5)));
    }
    return svg;
}

std::string counted(int n, const std::string& noun) {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

/// Returns the valences of the representatives, one per site.
std::vector<int> site_valences(const Tile& tile) {
    std::vector<int> valences = vertex_valences(tile);
    std::vector<bool> is_copy(valences.size());
    for (const VertexPair& pair : tile.vertex_pairs) is_copy[pair.w] = true;
    std::vector<int> result;
    for (int v = 0; v < tile.n_vertices(); ++v) {
        if (!is_copy[v]) result.push_back(valences[v]);
    }
    return result;
}

std::string caption(const Tile& tile) {
    const int n = count_sites(tile);
    const std::string triangles = counted(tile.n_faces(), "triangle");
    const MeshKindRow& kind = mesh_kind_row(tile.kind);
    if (!kind.faces_have_sites) {
        return "Periodic Delaunay tile, " + counted(n, "site") + ", " + triangles;
    }
    if (kind.grain_size) return "Periodic grains, " + triangles;
    return "Periodic Voronoi tile, " + (tile.whole_sides.empty()
                                            ? counted(n, "cell")
                                            : counted(tile.n_faces(), "piece") + " of cells");
}

std::vector<LegendEntry> valence_entries(const Tile& tile) {
    std::vector<LegendEntry> entries;
    for (const auto& [valence, count] : histogram(site_valences(tile))) {
        const std::string label = "valence " + std::to_string(valence) + ": ";
        entries.push_back({LegendEntry::Mark::kDisc,
                           valence == kRegular ? kDotColour : hex(side_colour(valence)),
                           label + std::to_string(count)});
    }
    return entries;
}

Legend make_legend(const Tile& tile, const SvgDomain& domain, std::vector<LegendEntry> entries) {
    Legend legend{caption(tile), std::move(entries)};
    for (const auto& [offset, colour] : seam_colours(tile)) {
        const std::string pair = std::to_string(offset.i) + ", " + std::to_string(offset.j);
        legend.entries.push_back({LegendEntry::Mark::kStroke, colour, "seam (" + pair + ")"});
    }
    legend.entries.push_back({LegendEntry::Mark::kDashes, kDomainColour, domain.label});
    return legend;
}

std::string encode(const Tile& tile, bool by_size) {
    require_finite(tile);
    // The frame includes the tile and the fundamental domain.
    const SvgDomain domain = drawn_domain(tile);
    std::vector<Vec2> drawn = tile.points;
    drawn.insert(drawn.end(), domain.corners.begin(), domain.corners.end());
    const SvgFrame frame(drawn);
    const double spacing = frame.scale() * std::sqrt(tile.lattice.area() / count_sites(tile));
    const Drawing drawing{tile, frame, spacing};
    // The legend explains the colours and determines the size of the canvas.
    const bool coloured = faces_have_sites(tile.kind);
    CellColours colours;
    if (coloured) colours = by_size ? colours_by_size(tile) : colours_by_sides(tile);
    Legend legend = make_legend(tile, domain, coloured ? colours.meaning : valence_entries(tile));
    if (coloured && by_size) legend.caption += " by size; h = sqrt(area / n)";
    const PlacedLegend placed = place_legend(legend, frame);

    // Draw from the bottom to the top.
    std::string svg = svg_head(legend.caption, placed.width, placed.height);
    svg += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    svg += draw_faces(drawing, colours, !by_size);
    svg += draw_domain(domain.corners, drawing);
    svg += draw_seam(drawing);
    if (tile.kind == MeshKind::kDelaunay) svg += draw_valences(drawing);
    svg += "</g>\n<g font-family=\"sans-serif\" font-size=\"13\" fill=\"#1c1f26\">\n";
    return svg + placed.svg + "</g>\n</svg>\n";
}

}  // namespace

std::vector<EncodedFile> encode_svg(const Tile& tile, const std::string& path) {
    return only_file(path, encode(tile, false));
}

std::vector<EncodedFile> encode_graded_svg(const Tile& tile, const std::string& path) {
    return only_file(path, encode(tile, true));
}

}  // namespace pcvt
