#include "mesher/finite_volume/mpas_grid_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/finite_volume/mpas_tables_proof.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt {
namespace {

using std::to_string;

const char* const kGeometry = "(2) of C-grids, geometry";
const char* const kAreas = "(3) of C-grids, areas";
const char* const kTrisk = "(4) of C-grids, TRiSK";
const char* const kDensity = "(5) of C-grids, density";
const char* const kCoriolis = "(6) of C-grids, Coriolis parameter";

constexpr double kTolerance = 1e-12;
constexpr double kGeometryTolerance = 1e-10;
/// Bounds the rounding errors of a coordinate that is wrapped, halved and subtracted, in ulps.
constexpr double kCoordinateUlps = 16;

void require_finite_numbers(const MpasGrid& g) {
    for (const auto* table :
         {&g.x_cell, &g.y_cell, &g.x_edge, &g.y_edge, &g.x_vertex, &g.y_vertex, &g.weights_on_edge,
          &g.kite_areas_on_vertex, &g.area_cell, &g.area_triangle, &g.dc_edge, &g.dv_edge,
          &g.angle_edge, &g.mesh_density}) {
        for (const double number : *table) {
            if (!std::isfinite(number)) throw_violation(kGeometry, "a number is not finite");
        }
    }
    if (!(g.x_period > 0 && g.y_period > 0 && std::isfinite(g.x_period * g.y_period))) {
        throw_violation(kGeometry, "a period is not positive");
    }
}

double angle_between(double a, double b) {
    return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

/// Returns the largest deviation of the stored geometry of edge e from its cells and vertices, a
/// length.
double edge_deviation(const MpasGrid& g, const MpasRows& rows, int e) {
    const plane::Vec2 here = rows.cell(rows.cell_of_edge(e, 0));
    const plane::Vec2 normal = rows.between(here, rows.cell(rows.cell_of_edge(e, 1)));
    const plane::Vec2 start = rows.vertex(rows.vertex_of_edge(e, 0));
    const plane::Vec2 tangent = rows.between(start, rows.vertex(rows.vertex_of_edge(e, 1)));
    const plane::Vec2 unit = normal.normalized();
    const double turned = plane::cross(unit, tangent);
    return std::max(
        {std::abs(normal.norm() - g.dc_edge[e]), std::abs(turned - g.dv_edge[e]),
         std::abs(unit.dot(tangent)),
         angle_between(std::atan2(normal.y(), normal.x()), g.angle_edge[e]) * normal.norm(),
         rows.between(plane::Vec2(here + normal / 2), rows.edge(e)).norm(),
         std::abs(unit.dot(rows.between(rows.edge(e), start)))});
}

double require_geometry(const MpasGrid& g, const MpasRows& rows, double h) {
    double largest = std::max(g.x_period, g.y_period);
    for (const auto* points : {&g.x_cell, &g.y_cell, &g.x_vertex, &g.y_vertex}) {
        for (const double x : *points) largest = std::max(largest, std::abs(x));
    }
    const double allowed =
        kGeometryTolerance + kCoordinateUlps * std::numeric_limits<double>::epsilon() * largest / h;
    double worst = 0;
    for (int e = 0; e < g.n_edges; ++e) {
        checkpoint_each(e);
        const double deviation = edge_deviation(g, rows, e) / h;
        if (!(deviation <= allowed)) {
            throw_violation(kGeometry, "edge " + to_string(e) + " is off by " +
                                           in_words(deviation) + " h from its cells and vertices");
        }
        worst = std::max(worst, deviation);
    }
    return worst;
}

double require_areas(const MpasGrid& g, const MpasRows& rows, double h) {
    std::vector<double> cells(g.area_cell.size(), 0);
    double worst = 0;
    // W. Kahan's compensated sum: equal cells round to the same side.
    double total = 0;
    double lost = 0;
    const auto compare = [&](double found, double stated, double unit, const std::string& what) {
        const double deviation = std::abs(found - stated) / unit;
        if (!(deviation <= kTolerance)) {
            throw_violation(
                kAreas, "the kites of " + what + " differ from its area by " + in_words(deviation));
        }
        worst = std::max(worst, deviation);
    };
    // Compare the kites of each vertex with its triangle, and sum them over the cells.
    for (int v = 0; v < g.n_vertices; ++v) {
        checkpoint_each(v);
        double sum = 0;
        for (int k = 0; k < 3; ++k) {
            const double kite = g.kite_areas_on_vertex[3 * std::size_t(v) + k];
            if (!(kite > 0))
                throw_violation(kAreas, "a kite of vertex " + to_string(v) + " is not positive");
            sum += kite;
            cells[rows.entry(g.cells_on_vertex, v, 3, k)] += kite;
        }
        compare(sum, g.area_triangle[v], h * h, "vertex " + to_string(v));
    }
    // Compare the sums with the areas of the cells and of the domain.
    for (int i = 0; i < g.n_cells; ++i) {
        checkpoint_each(i);
        compare(cells[i], g.area_cell[i], h * h, "cell " + to_string(i));
        const double term = cells[i] - lost;
        const double next = total + term;
        lost = (next - total) - term;
        total = next;
    }
    compare(total, g.x_period * g.y_period, g.x_period * g.y_period, "all cells");
    return worst;
}

/// Returns random normal velocities between -1 and 1, equal on every machine.
std::vector<double> random_velocities(int n) {
    std::mt19937 random(1);
    std::vector<double> u(static_cast<std::size_t>(n));
    for (double& speed : u) speed = static_cast<double>(random()) * 0x1p-31 - 1;
    return u;
}

double require_trisk(const MpasGrid& g, const MpasRows& rows, double h) {
    // Sum the divergence of u in the cells and the outflow of v from the triangles.
    const std::vector<double> u = random_velocities(g.n_edges);
    std::vector<double> divergence(static_cast<std::size_t>(g.n_cells), 0);
    std::vector<double> outflow(static_cast<std::size_t>(g.n_vertices), 0);
    for (int e = 0; e < g.n_edges; ++e) {
        checkpoint_each(e);
        divergence[rows.cell_of_edge(e, 0)] += g.dv_edge[e] * u[e];
        divergence[rows.cell_of_edge(e, 1)] -= g.dv_edge[e] * u[e];
        double v = 0;
        const std::size_t row = 2 * static_cast<std::size_t>(g.max_edges) * e;
        for (int k = 0; k < g.n_edges_on_edge[e]; ++k) {
            v += g.weights_on_edge[row + k] * u[g.edges_on_edge[row + k]];
        }
        outflow[rows.vertex_of_edge(e, 0)] += g.dc_edge[e] * v;
        outflow[rows.vertex_of_edge(e, 1)] -= g.dc_edge[e] * v;
    }
    // Compare both sides of the identity at each vertex.
    double worst = 0;
    for (int v = 0; v < g.n_vertices; ++v) {
        checkpoint_each(v);
        double wanted = 0;
        for (int k = 0; k < 3; ++k) {
            const int i = rows.entry(g.cells_on_vertex, v, 3, k);
            wanted +=
                g.kite_areas_on_vertex[3 * std::size_t(v) + k] / g.area_cell[i] * divergence[i];
        }
        const double deviation = std::abs(outflow[v] - wanted) / h;
        if (!(deviation <= kTolerance)) {
            throw_violation(kTrisk, "at vertex " + to_string(v) + " the identity fails by " +
                                        in_words(deviation));
        }
        worst = std::max(worst, deviation);
    }
    return worst;
}

void require_density(const MpasGrid& g) {
    const auto [least, largest] = std::minmax_element(g.mesh_density.begin(), g.mesh_density.end());
    if (!(*least > 0) || *largest != 1) {
        throw_violation(kDensity, "it lies between " + in_words(*least) + " and " +
                                      in_words(*largest) + ", not above 0 and up to 1");
    }
    const double mean = mean_density(g);
    if (!(std::abs(g.stated_mean_density.value_or(mean) - mean) <= kTolerance)) {
        throw_violation(kDensity, "its mean is " + in_words(mean) + ", not " +
                                      in_words(*g.stated_mean_density) + " as stated");
    }
}

/// Law (6).
void require_coriolis(const MpasGrid& g) {
    if (!g.coriolis) return;
    MpasGrid wanted{};
    wanted.y_cell = g.y_cell;
    wanted.y_edge = g.y_edge;
    wanted.y_vertex = g.y_vertex;
    fill_coriolis(*g.coriolis, wanted);
    if (g.f_cell == wanted.f_cell && g.f_edge == wanted.f_edge && g.f_vertex == wanted.f_vertex) {
        return;
    }
    throw_violation(kCoriolis, "it is not " + in_words(g.coriolis->f) + " + " +
                                   in_words(g.coriolis->beta) + " y everywhere");
}

}  // namespace

MpasGridProof prove_mpas_grid(const MpasGrid& grid) {
    const MpasRows rows(grid);
    require_finite_numbers(grid);
    prove_mpas_tables(grid, rows);
    const double h = std::sqrt(grid.x_period * grid.y_period / grid.n_cells);
    MpasGridProof proof{};
    proof.geometry = require_geometry(grid, rows, h);
    proof.areas = require_areas(grid, rows, h);
    proof.trisk = require_trisk(grid, rows, h);
    require_density(grid);
    require_coriolis(grid);
    return proof;
}

}  // namespace pcvt
