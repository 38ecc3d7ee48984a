#include "mesher/plane/mesh/area_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/cells/laplacian_solver.hpp"
#include "mesher/cells/weight_orbits.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/geometry/dual_mean.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {
namespace {

/// The areas are fitted to this share of the tolerance of the run that computed the weights.
constexpr double kShareOfTolerance = 0.1;
/// The linear equations are solved to this relative residual.
constexpr double kLinearAccuracy = 1e-4;
/// The number of earlier steps that a step takes into account.
constexpr int kRemembered = 12;
/// The iteration ends after this number of steps.
constexpr int kMostSteps = 100;
/// The iteration ends after this number of steps in a row that do not lower the error.
constexpr int kMostVainSteps = 15;
/// The cells are cut along the box at most this number of times.
constexpr int kMostCuts = 6;
/// The factor by which the snapping distance is reduced where no weights give the areas.
constexpr double kLessSnapForAreas = 4;
/// Rounding adds at most this many times the error of the cells without a box.
constexpr double kOverRounding = 4;
/// Corners that move less far, in units of h, do not change the areas.
constexpr double kLeastSnap = 1e-9;

PeriodicMesh to_round(PeriodicMesh mesh, const Metric& metric) {
    mesh.lattice = metric.to_round(mesh.lattice);
    for (Vec2& p : mesh.vertices) p = metric.to_round(p);
    for (Vec2& p : mesh.site_points) p = metric.to_round(p);
    return mesh;
}

/// The adjacency of the sites' cells.
CellGraph cell_graph(const PeriodicMesh& cells) {
    std::vector<double> conductance(static_cast<std::size_t>(cells.n_corners()));
    for (int c = 0; c < cells.n_corners(); ++c) {
        checkpoint_each(c);
        const int o = cells.opposite[c];
        if (o < c || cells.site[cells.corner_face[o]] == cells.site[cells.corner_face[c]]) continue;
        const Vec2 across = cells.site_points[cells.corner_face[o]] +
                            cells.lattice.translation(cells.frame_across(c));
        const double distance = (across - cells.site_points[cells.corner_face[c]]).norm();
        const double length = (cells.point(cells.next(c)) - cells.point(c)).norm();
        conductance[c] = conductance[o] = length / (2 * distance);
    }
    CellGraph graph{{0}, {}, {}};
    for (int f = 0; f < cells.n_faces(); ++f) {
        for (int c = cells.face_begin[f]; c < cells.face_begin[f + 1]; ++c) {
            const int g = cells.corner_face[cells.opposite[c]];
            if (g == f) continue;
            graph.neighbour.push_back(g);
            graph.conductance.push_back(conductance[c]);
        }
        graph.row_begin.push_back(static_cast<int>(graph.neighbour.size()));
    }
    return WeightOrbits({cells.site.begin(), cells.site.end()}).merged(std::move(graph));
}

/// The vertices of cells as functions of the weights of the sites.
class DualCorners {
   public:
    DualCorners(const PeriodicMesh& plane, const Metric& metric)
        : metric_(metric),
          cells_(to_round(plane, metric)),
          same_point_(kSameVertex * std::sqrt(cells_.lattice.area() / cells_.n_faces())) {
        std::vector<int> first(static_cast<std::size_t>(plane.n_vertices()), -1);
        for (int c = plane.n_corners(); c-- > 0;) first[plane.corner_vertex[c]] = c;
        for (const int c : first) add_ring(c);
    }

    /// Returns the vertices in the plane; nothing if a corner has no place.
    std::optional<std::vector<Vec2>> vertices(const Eigen::VectorXd& weights) const {
        std::vector<Vec2> result = cells_.vertices;
        std::vector<DualSite> polygon;
        for (std::size_t v = 0; v < result.size(); ++v) {
            checkpoint_each(v);
            if (n_sites(v) < 3) continue;
            polygon.clear();
            for (int k = ring_begin_[v]; k < ring_begin_[v + 1]; ++k) {
                polygon.push_back({sites_[k].point, weights[sites_[k].site]});
            }
            const auto mean = dual_mean(polygon, 0);
            if (!mean || !mean->point.allFinite()) return std::nullopt;
            result[v] = mean->point;
        }
        // Where an edge of a cell crosses a wall on which its sites lie, its ends are images of
        // each other. In a corner of walls on which a site lies, the vertex stays.
        for (std::size_t v = 0; v < result.size(); ++v) {
            if (n_sites(v) != 2) continue;
            const int k = ring_begin_[v];
            result[v] = (end_of(sites_[k], result) + end_of(sites_[k + 1], result)) / 2;
        }
        for (Vec2& p : result) p = metric_.from_round(p);
        return result;
    }

   private:
    /// A site whose cell meets a vertex, and the edge at which the cell begins counter-clockwise,
    /// as the frame of the vertex has them.
    struct SiteAtVertex {
        SiteId site;
        Vec2 point;
        int end;
        Offset end_offset;
    };

    int n_sites(std::size_t v) const { return ring_begin_[v + 1] - ring_begin_[v]; }

    Vec2 end_of(const SiteAtVertex& site, const std::vector<Vec2>& vertices) const {
        return vertices[site.end] + cells_.lattice.translation(site.end_offset);
    }

    bool same(const SiteAtVertex& a, const SiteAtVertex& b) const {
        return a.site == b.site && (a.point - b.point).norm() <= same_point_;
    }

    SiteAtVertex site_at(int c) const {
        const int f = cells_.corner_face[c];
        const int next = cells_.next(c);
        return {cells_.site[f],
                cells_.site_points[f] - cells_.lattice.translation(cells_.corner_offset[c]),
                cells_.corner_vertex[next], cells_.corner_offset[next] - cells_.corner_offset[c]};
    }

    /// Adds the sites of the cells round the vertex of a corner, counter-clockwise. The parts of a
    /// cell on both sides of a wall count as one.
    void add_ring(int first) {
        const int begin = ring_begin_.back();
        int c = first;
        do {
            const SiteAtVertex site = site_at(c);
            if (std::ssize(sites_) == begin || !same(sites_.back(), site)) sites_.push_back(site);
            const int f = cells_.corner_face[c];
            const int before = c == cells_.face_begin[f] ? cells_.face_begin[f + 1] - 1 : c - 1;
            c = cells_.opposite[before];
        } while (c != first);
        // The first cell may begin before the first corner.
        if (std::ssize(sites_) > begin + 1 && same(sites_[begin], sites_.back())) {
            sites_[begin] = sites_.back();
            sites_.pop_back();
        }
        ring_begin_.push_back(static_cast<int>(sites_.size()));
    }

    Metric metric_;
    PeriodicMesh cells_;
    double same_point_;
    /// For each vertex, its sites.
    std::vector<int> ring_begin_{0};
    std::vector<SiteAtVertex> sites_;
};

/// Steps for the root of a residual, each the best combination of the last ones (Anderson's
/// method).
class CombinedSteps {
   public:
    /// Returns the next place.
    /// @param step  from x towards the root.
    Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
        if (last_x_.size() > 0) {
            push(changes_, x - last_x_);
            push(step_changes_, step - last_step_);
        }
        last_x_ = x;
        last_step_ = step;
        if (changes_.cols() == 0) return x + step;
        const Eigen::VectorXd share = step_changes_.colPivHouseholderQr().solve(step);
        return x + step - (changes_ + step_changes_) * share;
    }

   private:
    static void push(Eigen::MatrixXd& columns, const Eigen::VectorXd& column) {
        const Eigen::Index kept = std::min<Eigen::Index>(columns.cols(), kRemembered - 1);
        Eigen::MatrixXd pushed(column.size(), kept + 1);
        pushed.col(0) = column;
        if (kept > 0) pushed.rightCols(kept) = columns.leftCols(kept);
        columns = std::move(pushed);
    }

    Eigen::VectorXd last_x_;
    Eigen::VectorXd last_step_;
    /// The latest first.
    Eigen::MatrixXd changes_;
    Eigen::MatrixXd step_changes_;
};

double largest_error(const Eigen::VectorXd& areas, const Eigen::VectorXd& wanted) {
    return ((areas - wanted).array().abs() / wanted.array()).maxCoeff();
}

bool are_simple(const PeriodicMesh& mesh) {
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        const Polygon polygon = face_polygon(mesh, f);
        if (!(polygon_area(polygon) > 0) || crosses_itself(polygon, 0)) return false;
    }
    return true;
}

/// @pre `joined` has areas in the measure.
FittedCells fit_measured(const PeriodicMesh& cells, PeriodicMesh joined, const Metric& metric,
                         const Eigen::VectorXd& weights, const AreaMeasure& measure) {
    const Eigen::VectorXd wanted = areas_by_site(cells, static_cast<int>(weights.size()));
    const double enough = kShareOfTolerance * area_tolerance(cells.n_faces());
    Eigen::VectorXd areas = measure(joined).value();
    FittedCells best{joined, weights, largest_error(areas, wanted)};
    if (best.largest_relative_error <= enough) return best;
    // Find the weights.
    const DualCorners corners(joined, metric);
    LaplacianSolver laplacian(cell_graph(to_round(cells, metric)));
    CombinedSteps steps;
    Eigen::VectorXd here = weights;
    for (int k = 0, vain = 0; k < kMostSteps && vain < kMostVainSteps; ++k, ++vain) {
        Eigen::VectorXd step;
        laplacian.solve(wanted - areas, kLinearAccuracy, step);
        here = steps.next(here, step);
        auto vertices = corners.vertices(here);
        if (!vertices) break;
        joined.vertices = std::move(*vertices);
        if (!are_simple(joined)) break;
        auto measured = measure(joined);
        if (!measured) break;
        areas = std::move(*measured);
        const double error = largest_error(areas, wanted);
        if (!(error < best.largest_relative_error)) continue;
        best = {joined, here, error};
        if (error <= enough) break;
        vain = 0;
    }
    return best;
}

/// Returns the pieces of the copies of the cells in a box; their areas may still be others.
FittedCells fit_with_snap(const PeriodicMesh& cells, const PeriodicMesh& joined,
                          const Metric& metric, const Eigen::VectorXd& weights,
                          const BoxOfCopies& box) {
    const int n = cells.n_faces();
    const auto copies = [&](const PeriodicMesh& mesh) {
        return repeated(mesh, box.columns, box.rows);
    };
    const auto areas = [&](const BoxCut& cut) -> Eigen::VectorXd {
        return areas_by_site(cut.pieces, n) / (box.columns * box.rows);
    };
    FittedCells fitted{joined, weights, 0};
    BoxCut cut = cut_along_box(copies(joined), box.corner, box.snap);
    for (int k = 1; k < kMostCuts; ++k) {
        const auto measure = [&](const PeriodicMesh& mesh) -> std::optional<Eigen::VectorXd> {
            const auto trial = cut_along_box_as_before(copies(mesh), box.corner, cut.snaps);
            if (!trial) return std::nullopt;
            return areas(*trial);
        };
        fitted = fit_measured(cells, std::move(fitted.cells), metric, fitted.weights, measure);
        BoxCut next = cut_along_box(copies(fitted.cells), box.corner, box.snap, cut.snaps);
        const bool is_settled = next.snaps == cut.snaps;
        cut = std::move(next);
        if (is_settled) break;
    }
    fitted.largest_relative_error = largest_error(areas(cut), areas_by_site(cells, n));
    fitted.cut = std::move(cut);
    return fitted;
}

}  // namespace

Eigen::VectorXd areas_by_site(const PeriodicMesh& mesh, int n_sites) {
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(n_sites);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        areas[mesh.site[f]] += polygon_area(face_polygon(mesh, f));
    }
    return areas;
}

FittedCells fit_areas(const PeriodicMesh& cells, PeriodicMesh joined, const Metric& metric,
                      const Eigen::VectorXd& weights) {
    const int n = cells.n_faces();
    return fit_measured(cells, std::move(joined), metric, weights,
                        [n](const PeriodicMesh& mesh) { return areas_by_site(mesh, n); });
}

FittedCells fit_areas(const PeriodicMesh& cells, PeriodicMesh joined, const Metric& metric,
                      const Eigen::VectorXd& weights, const AreaMeasure& measure) {
    return fit_measured(cells, std::move(joined), metric, weights, measure);
}

FittedCells fit_areas_in_box(const PeriodicMesh& cells, const PeriodicMesh& joined,
                             const Metric& metric, const Eigen::VectorXd& weights,
                             BoxOfCopies box) {
    FittedCells fitted = fit_with_snap(cells, joined, metric, weights, box);
    const double tolerance = area_tolerance(cells.n_faces());
    if (fitted.largest_relative_error <= tolerance) return fitted;
    // Rounding may prevent the tolerance for any snapping distance.
    const double without_box = fit_areas(cells, joined, metric, weights).largest_relative_error;
    const double enough = std::max(tolerance, kOverRounding * without_box);
    const double least_snap = kLeastSnap * std::sqrt(cells.lattice.area() / cells.n_faces());
    while (fitted.largest_relative_error > enough && box.snap > least_snap) {
        box.snap /= kLessSnapForAreas;
        fitted = fit_with_snap(cells, joined, metric, weights, box);
    }
    return fitted;
}

}  // namespace pcvt::plane
