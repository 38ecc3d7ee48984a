#include "mesher/finite_volume/mpas_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt {
namespace {

using std::to_string;

/// Rounding may make the cosine of a right angle this large.
constexpr double kRightAngle = 1e-9;

/// The cells of the domain as halfedges in the frames of their faces.
class Halfedges {
   public:
    explicit Halfedges(const plane::PeriodicMesh& cells)
        : cells_(cells), edge_(static_cast<std::size_t>(cells.n_corners())) {
        for (int h = 0; h < cells.n_corners(); ++h) {
            checkpoint_each(h);
            edge_[h] = h < cells.opposite[h] ? n_edges_++ : edge_[cells.opposite[h]];
        }
    }
    int n_edges() const { return n_edges_; }
    int edge(int h) const { return edge_[h]; }
    /// Whether the face of h is cell 1 of its edge.
    bool first(int h) const { return h < cells_.opposite[h]; }
    int cell(int h) const { return cells_.corner_face[h]; }
    int next(int h) const { return cells_.next(h); }
    int previous(int h) const {
        const int f = cells_.corner_face[h];
        return h == cells_.face_begin[f] ? cells_.face_begin[f + 1] - 1 : h - 1;
    }
    int opposite(int h) const { return cells_.opposite[h]; }
    int vertex(int h) const { return cells_.corner_vertex[h]; }

    plane::Vec2 site(int h) const { return cells_.site_points[cell(h)]; }
    /// Returns the vector from the site of the cell of h to the site of the cell across.
    plane::Vec2 to_neighbour(int h) const {
        return cells_.site_points[cell(opposite(h))] +
               cells_.lattice.translation(cells_.frame_across(h)) - site(h);
    }
    /// Returns the vector from the site of the cell of h to the vertex that h leaves.
    plane::Vec2 to_vertex(int h) const { return cells_.point(h) - site(h); }
    plane::Vec2 along(int h) const { return to_vertex(next(h)) - to_vertex(h); }

   private:
    const plane::PeriodicMesh& cells_;
    std::vector<int> edge_;
    int n_edges_ = 0;
};

std::string degrees(double cosine) {
    const long tenths = std::lround(portable_acos(cosine) * 1800 / std::numbers::pi);
    return to_string(tenths / 10) + "." + to_string(tenths % 10);
}

/// Returns the cosine of the angle at the site of h's cell in the triangle dual to the vertex that
/// h leaves.
double triangle_cosine(const Halfedges& edges, int h) {
    return edges.to_neighbour(h).normalized().dot(
        edges.to_neighbour(edges.previous(h)).normalized());
}

void require_acute(const plane::PeriodicMesh& cells, const Halfedges& edges) {
    int worst = -1;
    double smallest = kRightAngle;
    for (int h = 0; h < cells.n_corners(); ++h) {
        checkpoint_each(h);
        const double cosine = triangle_cosine(edges, h);
        if (cosine >= smallest) continue;
        smallest = cosine;
        worst = h;
    }
    if (worst < 0) return;
    const auto site = [&](int h) { return to_string(cells.site[edges.cell(h)]); };
    throw UnsuitableCells(
        "the Delaunay triangle of sites " + site(worst) + ", " + site(edges.opposite(worst)) +
        " and " + site(edges.opposite(edges.previous(worst))) + " has an angle of " +
        degrees(smallest) + " degrees at the first, and MPAS needs acute triangles");
}

void require_near_neighbours(const plane::PeriodicMesh& cells, const Halfedges& edges,
                             const plane::Vec2& periods) {
    for (int h = 0; h < cells.n_corners(); ++h) {
        checkpoint_each(h);
        const plane::Vec2 part = edges.to_neighbour(h).cwiseAbs().cwiseQuotient(periods);
        if (part.maxCoeff() < 0.5) continue;
        throw InvalidInput("the cells of sites " + to_string(cells.site[edges.cell(h)]) + " and " +
                           to_string(cells.site[edges.cell(edges.opposite(h))]) +
                           " lie half a period apart; MPAS expects each neighbour at its nearest "
                           "image: use more sites or repeat the tile");
    }
}

/// Moves points into the domain at `origin`.
class Wrapping {
   public:
    Wrapping(const plane::Vec2& origin, const plane::Vec2& periods)
        : origin_(origin), periods_(periods) {}
    void append(const plane::Vec2& p, std::vector<double>& x, std::vector<double>& y) const {
        x.push_back(wrapped(p.x(), origin_.x(), periods_.x()));
        y.push_back(wrapped(p.y(), origin_.y(), periods_.y()));
    }

   private:
    static double wrapped(double x, double origin, double period) {
        const double moved = x - std::floor((x - origin) / period) * period;
        // Rounding may leave the coordinate on or beyond the far side.
        return moved >= origin + period ? moved - period : std::max(moved, origin);
    }
    plane::Vec2 origin_;
    plane::Vec2 periods_;
};

void place_points(const plane::PeriodicMesh& cells, const Halfedges& edges,
                  const Wrapping& wrapping, MpasGrid& grid) {
    for (const plane::Vec2& site : cells.site_points)
        wrapping.append(site, grid.x_cell, grid.y_cell);
    for (const plane::Vec2& v : cells.vertices) wrapping.append(v, grid.x_vertex, grid.y_vertex);
    for (int h = 0; h < cells.n_corners(); ++h) {
        checkpoint_each(h);
        if (!edges.first(h)) continue;
        wrapping.append(edges.site(h) + edges.to_neighbour(h) / 2, grid.x_edge, grid.y_edge);
    }
}

void fill_cells(const plane::PeriodicMesh& cells, const Halfedges& edges, MpasGrid& grid) {
    const std::size_t size = static_cast<std::size_t>(grid.n_cells) * grid.max_edges;
    for (auto* table : {&grid.cells_on_cell, &grid.edges_on_cell, &grid.vertices_on_cell}) {
        table->assign(size, -1);
    }
    for (int f = 0; f < grid.n_cells; ++f) {
        checkpoint_each(f);
        grid.n_edges_on_cell.push_back(cells.face_begin[f + 1] - cells.face_begin[f]);
        std::size_t entry = static_cast<std::size_t>(f) * grid.max_edges;
        for (int h = cells.face_begin[f]; h < cells.face_begin[f + 1]; ++h, ++entry) {
            grid.cells_on_cell[entry] = edges.cell(edges.opposite(h));
            grid.edges_on_cell[entry] = edges.edge(h);
            grid.vertices_on_cell[entry] = edges.vertex(edges.next(h));
        }
    }
}

void fill_edges(const plane::PeriodicMesh& cells, const Halfedges& edges, MpasGrid& grid) {
    for (int h = 0; h < cells.n_corners(); ++h) {
        checkpoint_each(h);
        if (!edges.first(h)) continue;
        const int across = edges.opposite(h);
        const plane::Vec2 normal = edges.to_neighbour(h);
        grid.cells_on_edge.insert(grid.cells_on_edge.end(), {edges.cell(h), edges.cell(across)});
        grid.vertices_on_edge.insert(grid.vertices_on_edge.end(),
                                     {edges.vertex(h), edges.vertex(across)});
        grid.dc_edge.push_back(normal.norm());
        grid.dv_edge.push_back(edges.along(h).norm());
        grid.angle_edge.push_back(portable_atan2(normal.y(), normal.x()));
    }
}

/// Returns for each halfedge the area of the kite between its vertex, the site of its cell and the
/// midpoints of the two dual edges at the vertex.
std::vector<double> kite_areas(const plane::PeriodicMesh& cells, const Halfedges& edges) {
    std::vector<double> kites;
    kites.reserve(cells.corner_vertex.size());
    for (int h = 0; h < cells.n_corners(); ++h) {
        checkpoint_each(h);
        const plane::Vec2 vertex = edges.to_vertex(h);
        const plane::Vec2 before = edges.to_neighbour(edges.previous(h)) / 2;
        const plane::Vec2 after = edges.to_neighbour(h) / 2;
        kites.push_back((plane::cross(before, vertex) + plane::cross(vertex, after)) / 2);
    }
    return kites;
}

void fill_vertices(const plane::PeriodicMesh& cells, const Halfedges& edges,
                   const std::vector<double>& kites, MpasGrid& grid) {
    std::vector<int> leaving(static_cast<std::size_t>(grid.n_vertices), -1);
    for (int h = cells.n_corners(); h-- > 0;) leaving[edges.vertex(h)] = h;
    for (int h : leaving) {
        double area = 0;
        for (int k = 0; k < 3; ++k) {
            grid.edges_on_vertex.push_back(edges.edge(h));
            grid.cells_on_vertex.push_back(edges.cell(h));
            grid.kite_areas_on_vertex.push_back(kites[h]);
            area += kites[h];
            h = edges.opposite(edges.previous(h));
        }
        grid.area_triangle.push_back(area);
    }
    for (int f = 0; f < grid.n_cells; ++f) {
        checkpoint_each(f);
        grid.area_cell.push_back(std::accumulate(kites.begin() + cells.face_begin[f],
                                                 kites.begin() + cells.face_begin[f + 1], 0.0));
    }
}

/// Appends the weights of the edges of h's cell for v on h's edge (Thuburn et al., Eq. 33).
void append_weights(const Halfedges& edges, int h, const std::vector<double>& kites,
                    std::size_t& entry, MpasGrid& grid) {
    const double side = edges.first(h) ? 1 : -1;
    const double area = grid.area_cell[edges.cell(h)];
    double passed = 0;
    for (int k = edges.next(h); k != h; k = edges.next(k), ++entry) {
        passed += kites[k] / area;
        const int e = edges.edge(k);
        const double outwards = edges.first(k) ? 1 : -1;
        grid.edges_on_edge[entry] = e;
        grid.weights_on_edge[entry] =
            side * outwards * (0.5 - passed) * grid.dv_edge[e] / grid.dc_edge[edges.edge(h)];
    }
}

void fill_weights(const plane::PeriodicMesh& cells, const Halfedges& edges,
                  const std::vector<double>& kites, MpasGrid& grid) {
    const std::size_t row = 2 * static_cast<std::size_t>(grid.max_edges);
    grid.edges_on_edge.assign(row * grid.n_edges, -1);
    grid.weights_on_edge.assign(row * grid.n_edges, 0);
    for (int h = 0; h < cells.n_corners(); ++h) {
        checkpoint_each(h);
        if (!edges.first(h)) continue;
        const std::size_t begin = row * edges.edge(h);
        std::size_t entry = begin;
        append_weights(edges, h, kites, entry, grid);
        append_weights(edges, edges.opposite(h), kites, entry, grid);
        grid.n_edges_on_edge.push_back(static_cast<int>(entry - begin));
    }
}

}  // namespace

plane::Vec2 rectangular_periods(const plane::Lattice& lattice) {
    const plane::Lattice reduced = reduce(lattice).reduced;
    const plane::Vec2 a = reduced.a().cwiseAbs();
    const plane::Vec2 b = reduced.b().cwiseAbs();
    if (a.y() <= kRightAngle * a.x() && b.x() <= kRightAngle * b.y()) return {a.x(), b.y()};
    if (a.x() <= kRightAngle * a.y() && b.y() <= kRightAngle * b.x()) return {b.x(), a.y()};
    throw InvalidInput(
        "MPAS supports only periods along x and y; use a rectangular lattice or a repetition that "
        "is "
        "rectangular");
}

MpasGrid mpas_grid(const plane::PeriodicMesh& cells, const plane::Vec2& origin) {
    // Check that MPAS supports the mesh.
    const plane::Vec2 periods = rectangular_periods(cells.lattice);
    const Halfedges edges(cells);
    require_acute(cells, edges);
    require_near_neighbours(cells, edges, periods);
    // Set periods and counts.
    MpasGrid grid{};
    grid.x_period = periods.x();
    grid.y_period = periods.y();
    grid.n_cells = cells.n_faces();
    grid.n_edges = edges.n_edges();
    grid.n_vertices = cells.n_vertices();
    for (int f = 0; f < cells.n_faces(); ++f) {
        checkpoint_each(f);
        grid.max_edges = std::max(grid.max_edges, cells.face_begin[f + 1] - cells.face_begin[f]);
    }
    // Fill the tables.
    const std::vector<double> kites = kite_areas(cells, edges);
    place_points(cells, edges, Wrapping(origin, periods), grid);
    fill_cells(cells, edges, grid);
    fill_edges(cells, edges, grid);
    fill_vertices(cells, edges, kites, grid);
    fill_weights(cells, edges, kites, grid);
    grid.mesh_density.assign(static_cast<std::size_t>(grid.n_cells), 1);
    return grid;
}

double mean_density(const MpasGrid& grid) {
    return std::inner_product(grid.mesh_density.begin(), grid.mesh_density.end(),
                              grid.area_cell.begin(), 0.0) /
           (grid.x_period * grid.y_period);
}

void fill_coriolis(const Coriolis& coriolis, MpasGrid& grid) {
    grid.coriolis = coriolis;
    const auto parameters = [&](const std::vector<double>& y) {
        std::vector<double> values;
        values.reserve(y.size());
        for (const double at : y) values.push_back(coriolis.at(at));
        return values;
    };
    grid.f_cell = parameters(grid.y_cell);
    grid.f_edge = parameters(grid.y_edge);
    grid.f_vertex = parameters(grid.y_vertex);
}

void fill_mesh_density(std::span<const double> site_densities, MpasGrid& grid) {
    const double largest = *std::max_element(site_densities.begin(), site_densities.end());
    for (std::size_t f = 0; f < grid.mesh_density.size(); ++f) {
        grid.mesh_density[f] = site_densities[f % site_densities.size()] / largest;
    }
}

}  // namespace pcvt
