#include "io/svg_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>

#include "io/finite.hpp"
#include "io/palette.hpp"
#include "io/svg_canvas.hpp"
#include "io/svg_legend.hpp"
#include "mesher/polygon.hpp"
#include "mesher/quality.hpp"

namespace pcvt {
namespace {

constexpr const char* kEdgeColour = "#565c68";
constexpr const char* kGradedEdgeColour = "#262a33";
constexpr const char* kTriangleEdgeColour = "#8b919c";
constexpr const char* kDotColour = "#30343c";
constexpr const char* kDomainColour = "#1c1f26";
/// Hues that no cell has; one a translation class, whole outlines have four at most.
constexpr std::array kSeamColours{"#0a8f63", "#8a36b5", "#d9187f", "#6f7600", "#0099a8", "#5d4037"};
/// Below this spacing in pixels dots would only grey the picture.
constexpr double kLeastDottedSpacing = 9;
/// The domain is drawn in the typed basis unless its diagonal is longer than the reduced one times
/// this.
constexpr double kOblique = 1.5;
constexpr int kRegular = 6;

/// Pictures by size have at most so many classes; the finest is a sixteenth of an octave.
constexpr int kMostClasses = 9;
constexpr double kFinestClass = 1.0 / 16;
/// Stands for areas that rounding made zero.
constexpr double kLeastShare = 1e-12;

std::string counted(int n, const std::string& noun) {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

std::string two_digits(double value) {
    std::array<char, 32> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 2);
    return {text.data(), end.ptr};
}

/// One drawing: the tile, where it goes, and the spacing h of its sites in pixels.
struct Drawing {
    const FlatTile& tile;
    SvgFrame frame;
    double spacing;

    /// A width of `fraction` of the spacing, kept where it can be seen and does not smother the
    /// cells.
    double width(double fraction, double least, double most) const {
        return std::clamp(fraction * spacing, least, most);
    }
};

int count_sites(const FlatTile& tile) {
    return tile.kind == TileKind::kCells
               ? tile.n_faces()
               : tile.n_vertices() - static_cast<int>(tile.vertex_pairs.size());
}

double longest_diagonal(const Lattice& lattice) {
    return std::max((lattice.a() + lattice.b()).norm(), (lattice.a() - lattice.b()).norm());
}

struct Domain {
    std::vector<Vec2> corners;
    std::string label;
};

/// The parallelogram at the lattice point where it covers the tile best.
Domain choose_domain(const FlatTile& tile) {
    const Lattice reduced = reduce(tile.lattice).reduced;
    const bool oblique = longest_diagonal(tile.lattice) > kOblique * longest_diagonal(reduced);
    const Lattice& basis = oblique ? reduced : tile.lattice;
    Vec2 low = tile.points[0];
    Vec2 high = low;
    for (const Vec2& p : tile.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Vec2 middle = basis.to_lattice(low + (high - low) / 2);
    const Vec2 corner = basis.to_plane((middle - Vec2(0.5, 0.5)).array().round().matrix());
    return {{corner, corner + basis.a(), corner + basis.a() + basis.b(), corner + basis.b()},
            oblique ? "reduced domain" : "domain"};
}

/// (i, j) and (-i, -j) name the same translation class.
Offset translation_class(Offset offset) { return offset < Offset{} ? -offset : offset; }

/// Classes with their colours; (1, 0) and (0, 1) come first and so look the same in every picture.
std::vector<std::pair<Offset, std::string>> seam_colours(const FlatTile& tile) {
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

void add_face(const FlatTile& tile, int face, SvgPath& path) {
    for (int c = tile.face_begin[face]; c < tile.face_begin[face + 1]; ++c) {
        const Vec2& point = tile.points[tile.corners[c]];
        c == tile.face_begin[face] ? path.move(point) : path.line(point);
    }
    path.close();
}

/// The colour of each face and what the colours mean.
struct CellColours {
    std::vector<std::string> of_face;
    std::vector<LegendEntry> meaning;
};

CellColours colours_by_sides(const FlatTile& tile) {
    CellColours colours;
    const std::vector<int> sides = cell_sides(tile);
    for (const int n : sides) colours.of_face.push_back(hex(side_colour(n)));
    for (const auto& [n, count] : histogram(sides)) {
        colours.meaning.push_back({LegendEntry::Mark::kPatch, hex(side_colour(n)),
                                   counted(n, "side") + ": " + std::to_string(count)});
    }
    return colours;
}

double face_area(const FlatTile& tile, int face) {
    Polygon polygon;
    for (int c = tile.face_begin[face]; c < tile.face_begin[face + 1]; ++c) {
        polygon.push_back(tile.points[tile.corners[c]]);
    }
    return polygon_area(polygon);
}

/// Classes of sqrt(area) / h with equal ratios, 2^(1/16) or a power of it, so that there are few.
CellColours colours_by_size(const FlatTile& tile) {
    const double area = tile.lattice.area() / tile.n_faces();
    std::vector<double> octaves;
    for (int f = 0; f < tile.n_faces(); ++f) {
        octaves.push_back(std::log2(std::max(face_area(tile, f) / area, kLeastShare)) / 2);
    }
    const auto [least, most] = std::minmax_element(octaves.begin(), octaves.end());
    double width = kFinestClass;
    while (*most - *least > width * (kMostClasses - 1)) width *= 2;
    const int lowest = static_cast<int>(std::floor(*least / width));
    const int last = static_cast<int>(std::floor(*most / width)) - lowest;
    std::vector<int> count(static_cast<std::size_t>(last) + 1, 0);
    const auto colour = [&](int k) { return hex(size_colour(last == 0 ? 1 : double(k) / last)); };
    CellColours colours;
    for (const double octave : octaves) {
        const int k = static_cast<int>(std::floor(octave / width)) - lowest;
        colours.of_face.push_back(colour(k));
        ++count[k];
    }
    for (int k = 0; k <= last; ++k) {
        const std::string label = two_digits(std::exp2((lowest + k) * width)) + " to " +
                                  two_digits(std::exp2((lowest + k + 1) * width)) +
                                  " h: " + std::to_string(count[k]);
        colours.meaning.push_back({LegendEntry::Mark::kPatch, colour(k), label});
    }
    return colours;
}

std::string draw_cells(const Drawing& drawing, const CellColours& colours, bool dotted) {
    const FlatTile& tile = drawing.tile;
    std::map<std::string, SvgPath> by_colour;
    SvgPath dots(drawing.frame);
    for (int f = 0; f < tile.n_faces(); ++f) {
        add_face(tile, f, by_colour.try_emplace(colours.of_face[f], drawing.frame).first->second);
    }
    for (const Vec2& site : tile.site_points) dots.dot(site);
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

std::string draw_triangles(const Drawing& drawing) {
    const FlatTile& tile = drawing.tile;
    SvgPath faces(drawing.frame);
    for (int f = 0; f < tile.n_faces(); ++f) add_face(tile, f, faces);
    return faces.element(fill(hex(side_colour(kRegular))) +
                         stroke(kTriangleEdgeColour, drawing.width(0.03, 0.05, 1.6)));
}

/// Over the seam, so that a mark on the boundary is seen whole.
std::string draw_valences(const Drawing& drawing) {
    const FlatTile& tile = drawing.tile;
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
    const FlatTile& tile = drawing.tile;
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

/// Valences of the representatives only: one a site.
std::vector<int> site_valences(const FlatTile& tile) {
    std::vector<int> valences = vertex_valences(tile);
    std::vector<bool> is_copy(valences.size());
    for (const VertexPair& pair : tile.vertex_pairs) is_copy[pair.w] = true;
    std::vector<int> result;
    for (int v = 0; v < tile.n_vertices(); ++v) {
        if (!is_copy[v]) result.push_back(valences[v]);
    }
    return result;
}

std::string caption(const FlatTile& tile) {
    const int n = count_sites(tile);
    return tile.kind == TileKind::kCells ? "Periodic Voronoi tile, " + counted(n, "cell")
                                         : "Periodic Delaunay tile, " + counted(n, "site") + ", " +
                                               counted(tile.n_faces(), "triangle");
}

std::vector<LegendEntry> valence_entries(const FlatTile& tile) {
    std::vector<LegendEntry> entries;
    for (const auto& [valence, count] : histogram(site_valences(tile))) {
        const std::string label = "valence " + std::to_string(valence) + ": ";
        entries.push_back({LegendEntry::Mark::kDisc,
                           valence == kRegular ? kDotColour : hex(side_colour(valence)),
                           label + std::to_string(count)});
    }
    return entries;
}

Legend make_legend(const FlatTile& tile, const Domain& domain, std::vector<LegendEntry> entries) {
    Legend legend{caption(tile), std::move(entries)};
    for (const auto& [offset, colour] : seam_colours(tile)) {
        const std::string pair = std::to_string(offset.i) + ", " + std::to_string(offset.j);
        legend.entries.push_back({LegendEntry::Mark::kStroke, colour, "seam (" + pair + ")"});
    }
    legend.entries.push_back({LegendEntry::Mark::kDashes, kDomainColour, domain.label});
    return legend;
}

std::string head(const std::string& title, double width, double height) {
    const std::string size = svg_attribute("width", width) + svg_attribute("height", height);
    std::string text = R"(<svg xmlns="http://www.w3.org/2000/svg")" + size + " viewBox=\"0 0 ";
    append_pixels(text, width);
    text += ' ';
    append_pixels(text, height);
    return text + "\">\n<title>" + title + "</title>\n<rect" + size + " fill=\"#ffffff\"/>\n";
}

std::string encode(const FlatTile& tile, bool by_size) {
    require_finite(tile);
    const Domain domain = choose_domain(tile);
    std::vector<Vec2> drawn = tile.points;
    drawn.insert(drawn.end(), domain.corners.begin(), domain.corners.end());
    const SvgFrame frame(drawn);
    const double spacing = frame.scale() * std::sqrt(tile.lattice.area() / count_sites(tile));
    const Drawing drawing{tile, frame, spacing};
    const bool cells = tile.kind == TileKind::kCells;
    CellColours colours;
    if (cells) colours = by_size ? colours_by_size(tile) : colours_by_sides(tile);
    Legend legend = make_legend(tile, domain, cells ? colours.meaning : valence_entries(tile));
    if (cells && by_size) legend.caption += " by size; h = sqrt(area / n)";
    const PlacedLegend placed = place_legend(legend, frame);

    std::string svg = head(legend.caption, placed.width, placed.height);
    svg += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    svg += cells ? draw_cells(drawing, colours, !by_size) : draw_triangles(drawing);
    svg += draw_domain(domain.corners, drawing);
    svg += draw_seam(drawing);
    if (!cells) svg += draw_valences(drawing);
    svg += "</g>\n<g font-family=\"sans-serif\" font-size=\"13\" fill=\"#1c1f26\">\n";
    return svg + placed.svg + "</g>\n</svg>\n";
}

}  // namespace

std::vector<EncodedFile> encode_svg(const FlatTile& tile, const std::string& path) {
    return {{path, encode(tile, false)}};
}

std::vector<EncodedFile> encode_svg(const AnyTile& tile, const std::string& path) {
    return encode_svg(flatten(tile), path);
}

std::vector<EncodedFile> encode_graded_svg(const FlatTile& tile, const std::string& path) {
    return {{path, encode(tile, true)}};
}

std::vector<EncodedFile> encode_graded_svg(const AnyTile& tile, const std::string& path) {
    return encode_graded_svg(flatten(tile), path);
}

}  // namespace pcvt
