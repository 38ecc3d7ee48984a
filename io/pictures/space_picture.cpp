#include "io/pictures/space_picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/colours/cell_colours.hpp"
#include "io/forms/surface_list.hpp"
#include "io/pictures/periodic_canvas.hpp"
#include "io/pictures/png_writer.hpp"
#include "io/pictures/svg_canvas.hpp"
#include "io/pictures/svg_legend.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/cell_faces.hpp"

namespace pcvt {
namespace {

constexpr PackedColour kEdge = 0x3a3f4a;
constexpr PackedColour kBackground = 0xffffff;
/// The light of a face that is turned away, and of one that the light meets straight.
constexpr double kAmbient = 0.56;
constexpr double kDirect = 0.5;
/// Pixels of PNG for one of SVG.
constexpr double kSharpness = 2;

/// The axes of the picture: to the right, upwards, and towards the viewer.
struct View {
    space::Vec3 right;
    space::Vec3 up;
    space::Vec3 towards;
    space::Vec3 light;

    plane::Vec2 place(const space::Vec3& p) const { return {p.dot(right), p.dot(up)}; }
};

/// Shows the faces of a box at x = most, y = least and z = most, with z upwards.
View view() {
    View view;
    view.towards = space::Vec3(0.5, -0.8, 0.46).normalized();
    view.right = space::Vec3::UnitZ().cross(view.towards).normalized();
    view.up = view.towards.cross(view.right);
    view.light = (0.75 * view.towards + 0.75 * view.up - 0.45 * view.right).normalized();
    return view;
}

Colour shaded(const Colour& colour, double light) {
    const double factor = std::min(1.0, kAmbient + kDirect * std::max(0.0, light));
    return {colour.r * factor, colour.g * factor, colour.b * factor};
}

space::Vec3 area_vector(const space::PolyhedralMesh& mesh, int face) {
    space::Vec3 area = space::Vec3::Zero();
    const auto corners = mesh.faces[face];
    const space::Vec3& first = mesh.points[corners[0]];
    for (std::size_t k = 2; k < corners.size(); ++k) {
        area += (mesh.points[corners[k - 1]] - first).cross(mesh.points[corners[k]] - first);
    }
    return area;
}

/// The numbers of faces of the cells.
std::vector<int> face_counts(const space::PolyhedralMesh& mesh) {
    const space::CellFaces cells(mesh);
    std::vector<int> counts;
    for (int s = 0; s < cells.n_cells(); ++s) counts.push_back(static_cast<int>(cells[s].size()));
    return counts;
}

/// The boundary faces, those of the cell farthest from the viewer first.
std::vector<int> painted_order(const SpaceTile& tile, const space::Vec3& towards) {
    const space::PolyhedralMesh& mesh = tile.mesh;
    std::vector<int> faces(static_cast<std::size_t>(mesh.n_faces() - mesh.n_inner_faces()));
    std::iota(faces.begin(), faces.end(), mesh.n_inner_faces());
    const Eigen::VectorXd depth = tile.sites.transpose() * towards;
    std::stable_sort(faces.begin(), faces.end(),
                     [&](int f, int g) { return depth[mesh.owner[f]] < depth[mesh.owner[g]]; });
    return faces;
}

/// A picture on its canvas.
struct SpacePicture {
    std::vector<ShownFace> faces;
    SvgFrame frame;
    /// The width of the edges, in pixels of SVG.
    double edge_width;
};

SpacePicture picture_of(const SpaceTile& tile, const TileColours& colours) {
    std::vector<ShownFace> faces = shown_faces(tile, colours);
    std::vector<plane::Vec2> points;
    for (const ShownFace& face : faces) {
        points.insert(points.end(), face.corners.begin(), face.corners.end());
    }
    const SvgFrame frame(points);
    const double spacing = portable_cbrt(tile.mesh.lattice.volume() / tile.mesh.n_sites());
    return {std::move(faces), frame, std::clamp(0.014 * spacing * frame.scale(), 0.1, 1.4)};
}

Legend legend_of(const TileColours& colours, Colouring colouring) {
    Legend legend{.caption = colouring == Colouring::kFaces
                                 ? "Cells by number of faces"
                                 : std::string("Cells by ") + colouring_row(colouring).word,
                  .entries = {}};
    for (const ColourClass& shown : colours.classes) {
        if (shown.label.empty()) continue;
        legend.entries.push_back({LegendEntry::Mark::kPatch, hex(shown.colour), shown.label});
    }
    if (colouring == Colouring::kOrientation) {
        legend.caption = "Axes of cubic crystals along z";
        legend.entries = {{LegendEntry::Mark::kPatch, "#ff0000", "001"},
                          {LegendEntry::Mark::kPatch, "#00ff00", "011"},
                          {LegendEntry::Mark::kPatch, "#0000ff", "111"}};
    }
    if (legend.entries.empty()) legend.caption = "";
    return legend;
}

}  // namespace

TileColours cell_colours(const SpaceTile& tile, Colouring colouring) {
    CellQuantities cells{.n_faces = face_counts(tile.mesh), .materials = &tile.materials};
    if (colouring == Colouring::kSize) {
        for (const space::CellBody& body : cell_bodies(tile.mesh)) {
            cells.volumes.push_back(body.volume);
        }
    }
    std::vector<int> classes;
    if (colouring == Colouring::kCells) classes = cells_apart(tile.mesh);
    cells.classes = classes;
    return cell_colours(colouring, cells);
}

std::vector<ShownFace> shown_faces(const SpaceTile& tile, const TileColours& colours) {
    const View shown = view();
    std::vector<ShownFace> faces;
    for (const int f : painted_order(tile, shown.towards)) {
        checkpoint_each(f);
        const space::Vec3 normal = area_vector(tile.mesh, f).stableNormalized();
        if (!(normal.dot(shown.towards) > 0)) continue;
        ShownFace& face = faces.emplace_back();
        for (const int v : tile.mesh.faces[f]) {
            face.corners.push_back(shown.place(tile.mesh.points[v]));
        }
        const Colour& colour = colours.classes[colours.class_of[tile.mesh.owner[f]]].colour;
        face.colour = shaded(colour, normal.dot(shown.light));
    }
    return faces;
}

std::vector<EncodedFile> encode_space_svg(const SpaceTile& tile, Colouring colouring,
                                          const std::string& path) {
    const TileColours colours = cell_colours(tile, colouring);
    const SpacePicture picture = picture_of(tile, colours);
    const PlacedLegend legend = place_legend(legend_of(colours, colouring), picture.frame);
    const std::string title =
        std::to_string(tile.mesh.n_sites()) + " periodic cells in space" + colours.explanation;
    std::string svg = svg_head(title, legend.width, legend.height);
    svg += "<g stroke=\"#3a3f4a\" stroke-linejoin=\"round\"" +
           svg_attribute("stroke-width", picture.edge_width) + ">\n";
    for (const ShownFace& face : picture.faces) {
        checkpoint();
        SvgPath outline(picture.frame);
        outline.move(face.corners.front());
        for (std::size_t k = 1; k < face.corners.size(); ++k) outline.line(face.corners[k]);
        svg += outline.close().element(" fill=\"" + hex(face.colour) + "\"");
    }
    svg += "</g>\n" + svg_text_group() + legend.svg + "</g>\n</svg>\n";
    return only_file(path, std::move(svg));
}

std::vector<EncodedFile> encode_space_png(const SpaceTile& tile, Colouring colouring,
                                          const std::string& path) {
    const SpacePicture picture = picture_of(tile, cell_colours(tile, colouring));
    const auto width = static_cast<int>(std::ceil(kSharpness * picture.frame.width()));
    const auto height = static_cast<int>(std::ceil(kSharpness * picture.frame.height()));
    PeriodicCanvas canvas(width, height, Walls::kNone);
    canvas.add_polygon(std::vector<plane::Vec2>{{0, 0}, {width, 0}, {width, height}, {0, height}},
                       kBackground);
    std::vector<plane::Vec2> corners;
    for (const ShownFace& face : picture.faces) {
        checkpoint();
        corners.clear();
        for (const plane::Vec2& corner : face.corners) {
            corners.push_back(kSharpness * picture.frame.pixel(corner));
        }
        canvas.add_polygon(corners, packed(face.colour));
        for (std::size_t k = 0; k < corners.size(); ++k) {
            canvas.add_stroke(corners[k], corners[(k + 1) % corners.size()],
                              kSharpness * picture.edge_width, kEdge);
        }
    }
    return only_file(path, encode_png(canvas.render()));
}

}  // namespace pcvt
