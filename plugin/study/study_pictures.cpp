#include "plugin/study/study_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "io/colours/palette.hpp"
#include "mesher/plane/mesh/valence.hpp"
#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt {
namespace {

constexpr int kRegular = 6;
/// Colours differ between these numbers of sides.
constexpr int kFewestSides = 3;
constexpr int kMostSides = 9;
/// Parts of cells below this area are not drawn: such cells only touch the domain.
constexpr double kSliver = 1e-12;
/// In periods: a site this near to the border is drawn on both sides.
constexpr double kOnBorder = 1e-9;

plane::Polygon domain_outline(const plane::Lattice& lattice) {
    return {plane::Vec2::Zero(), lattice.a(), lattice.a() + lattice.b(), lattice.b()};
}

/// The part of a polygon inside the domain, both in lattice coordinates.
plane::Polygon inside_unit_square(plane::Polygon polygon) {
    for (const int axis : {0, 1}) {
        for (const double sign : {1.0, -1.0}) {
            const double level = sign > 0 ? 1 : 0;
            plane::Vec2 normal = plane::Vec2::Zero();
            normal[axis] = sign;
            polygon = plane::clipped(polygon, normal, level);
        }
    }
    return polygon;
}

plane::Polygon mapped(const plane::Polygon& polygon, const auto& map) {
    plane::Polygon result;
    for (const plane::Vec2& corner : polygon) result.push_back(map(corner));
    return result;
}

/// The images of a cell that meet the domain, each cut along it; length units.
std::vector<plane::Polygon> pieces_in_domain(const plane::Lattice& lattice,
                                             const plane::Polygon& cell) {
    const plane::Polygon u =
        mapped(cell, [&](const plane::Vec2& p) { return lattice.to_lattice(p); });
    plane::Vec2 low = u[0];
    plane::Vec2 high = u[0];
    for (const plane::Vec2& corner : u) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    std::vector<plane::Polygon> pieces;
    for (double i = std::floor(low.x()); i <= std::floor(high.x()); ++i) {
        for (double j = std::floor(low.y()); j <= std::floor(high.y()); ++j) {
            const plane::Polygon piece = inside_unit_square(mapped(
                u, [&](const plane::Vec2& p) { return plane::Vec2(p - plane::Vec2(i, j)); }));
            if (piece.size() < 3 || std::abs(plane::polygon_area(piece)) < kSliver) continue;
            pieces.push_back(
                mapped(piece, [&](const plane::Vec2& p) { return lattice.to_position(p); }));
        }
    }
    return pieces;
}

/// The images of a site in the closed domain: one, but more for a site on the border.
void add_dots(const plane::Lattice& lattice, const plane::Vec2& site,
              std::vector<plane::Vec2>& dots) {
    const plane::Vec2 u = lattice.to_lattice(site);
    const plane::Vec2 inside = u.array() - (u.array() + kOnBorder).floor();
    for (const double i : {0.0, 1.0}) {
        for (const double j : {0.0, 1.0}) {
            const plane::Vec2 image = inside + plane::Vec2(i, j);
            if (image.maxCoeff() <= 1 + kOnBorder) dots.push_back(lattice.to_position(image));
        }
    }
}

/// The domain with its cells and sites.
/// @param colour  of a face that the border cuts into a number of pieces.
CellPanel panel_of(const plane::PeriodicMesh& mesh,
                   const std::function<std::string(int face, std::size_t n_pieces)>& colour) {
    CellPanel panel;
    panel.outline = domain_outline(mesh.lattice);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const std::vector<plane::Polygon> pieces =
            pieces_in_domain(mesh.lattice, face_polygon(mesh, f));
        for (const plane::Polygon& piece : pieces)
            panel.cells.push_back({piece, colour(f, pieces.size())});
        add_dots(mesh.lattice, mesh.site_points[f], panel.sites);
    }
    return panel;
}

/// The sides of a clipped cell that are longer than kShortEdge h.
int count_sides(const plane::Polygon& polygon, double h) {
    int sides = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        sides +=
            (polygon[(k + 1) % polygon.size()] - polygon[k]).norm() > plane::kShortEdge * h ? 1 : 0;
    }
    return sides;
}

}  // namespace

CellPanel periodic_panel(const plane::CvtResult& result) {
    const plane::PeriodicMesh mesh = periodic_mesh(result.delaunay, plane::MeshKind::kVoronoi);
    const std::vector<int> sides = cell_sides(mesh);
    return panel_of(mesh, [&sides](int face, std::size_t n_pieces) -> std::string {
        const bool shaded = n_pieces > 1 && sides[face] == kRegular;
        return shaded ? kCutHexagon : hex(side_colour(sides[face]));
    });
}

CellPanel orbit_panel(const plane::CvtResult& result, const std::vector<int>& orbit) {
    const plane::PeriodicMesh mesh = periodic_mesh(result.delaunay, plane::MeshKind::kVoronoi);
    return panel_of(mesh, [&](int face, std::size_t) {
        return hex(cell_colour(orbit[mesh.site[face]] % kCellColours));
    });
}

CellPanel clipped_panel(const plane::Lattice& lattice, const plane::Points& sites) {
    const double h = std::sqrt(lattice.area() / static_cast<double>(sites.cols()));
    CellPanel panel;
    panel.outline = domain_outline(lattice);
    for (const plane::ClippedCell& cell : clipped_cells(lattice, sites)) {
        const std::string colour =
            cell.meets_border ? kBorderCell : hex(side_colour(count_sides(cell.polygon, h)));
        panel.cells.push_back({cell.polygon, colour});
    }
    for (Eigen::Index s = 0; s < sites.cols(); ++s) panel.sites.emplace_back(sites.col(s));
    return panel;
}

std::vector<LegendEntry> panel_legend(const std::vector<CellPanel>& panels) {
    std::set<std::string> used;
    for (const CellPanel& panel : panels) {
        for (const CellPanel::Cell& cell : panel.cells) used.insert(cell.colour);
    }
    std::vector<LegendEntry> entries;
    const auto add = [&](const std::string& colour, const std::string& label) {
        if (used.erase(colour) > 0) {
            entries.push_back({LegendEntry::Mark::kPatch, colour, label});
        }
    };
    add(hex(side_colour(kFewestSides)), "3 sides");
    for (int sides = kFewestSides + 1; sides < kMostSides; ++sides) {
        add(hex(side_colour(sides)), std::to_string(sides) + " sides");
        if (sides == kRegular) add(kCutHexagon, "6 sides, across the border");
    }
    add(hex(side_colour(kMostSides)), "9 and more");
    add(kBorderCell, "clipped at the border");
    return entries;
}

StudyPicture plot_picture(const std::string& title, const std::vector<Plot>& plots) {
    StudyPicture picture;
    picture.svg = encode_plots(title, plots);
    picture.points = plot_points(plots);
    return picture;
}

}  // namespace pcvt
