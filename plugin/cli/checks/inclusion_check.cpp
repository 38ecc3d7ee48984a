#include "plugin/cli/checks/inclusion_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "mesher/interfaces/inclusion_set.hpp"
#include "plugin/cli/terminal/console.hpp"

namespace pcvt::cli {
namespace {

/// In units of the area of the domain.
constexpr double kSameArea = 1e-12;
/// Nodes come from the corners of cells, whose rounding errors add up.
constexpr double kRoundings = 8;

/// A directed edge with the inclusion on its left, in the frame of its shape.
struct OutlineEdge {
    Vec2 from;
    Vec2 to;
    /// Edges are sorted by this: their order along the outline.
    double place;
};

/// The shapes of all copies of the domain: shape k of copy c is inclusion k + c n.
InclusionSet set_of(const TileFile& file, const InclusionFile& shapes) {
    const Tile& tile = file.tile;
    const Lattice domain(tile.lattice.a() / tile.columns, tile.lattice.b() / tile.rows);
    std::vector<Inclusion> all;
    for (int j = 0; j < tile.rows; ++j) {
        for (int i = 0; i < tile.columns; ++i) {
            for (Inclusion copy : shapes.inclusions) {
                copy.shape = translated(copy.shape, domain.translation({i, j}));
                all.push_back(std::move(copy));
            }
        }
    }
    try {
        // Faults are those of the shapes of one domain.
        const InclusionSet one(domain, shapes.inclusions, tile.walls);
        return {tile.lattice, std::move(all), tile.walls};
    } catch (const InvalidInput& error) {
        throw BadFile(shapes.name + ": " + error.what());
    }
}

class InclusionCheck {
   public:
    InclusionCheck(const TileFile& file, const TileProof& proof, const InclusionFile& shapes)
        : file_(file),
          tile_(file.tile),
          proof_(proof),
          shapes_(shapes),
          set_(set_of(file, shapes)),
          n_shapes_(static_cast<int>(shapes.inclusions.size())),
          copies_(tile_.columns * tile_.rows),
          domain_area_(tile_.lattice.area() / copies_) {
        const double n = static_cast<double>(tile_.site_positions.size());
        near_ = std::max(kSameVertex * std::sqrt(domain_area_ / n), kRoundings * proof.tolerance);
    }

    std::string prove() {
        for (const Vec2& site : tile_.site_positions) {
            const int k = set_.containing(site);
            shape_.push_back(k < 0 ? -1 : k % n_shapes_);
        }
        require_tags();
        require_areas();
        collect_edges();
        int n_edges = 0;
        for (int k = 0; k < set_.n_given(); ++k) n_edges += prove_outline(k);
        return ", " + std::to_string(n_shapes_) + " inclusions of " + shapes_.name + " with " +
               std::to_string(n_edges) + " edges on their outlines, areas within " +
               figure(area_error_) + " of the domain (tolerance " + figure(area_tolerance_) + ")";
    }

   private:
    [[noreturn]] void refute(int k, const std::string& what) const {
        throw NotATile("law of the inclusions: " + shapes_.name + ":" +
                       std::to_string(set_[k].line) + ": " + what);
    }

    std::string tag_of(int inclusion) const {
        if (inclusion < 0) return kMatrixTag;
        return shapes_.tags[static_cast<std::size_t>(set_[inclusion].tag - 1)];
    }

    /// Law (1).
    void require_tags() const {
        const CellMaterials& stated = file_.materials;
        for (std::size_t s = 0; s < stated.site_phase.size(); ++s) {
            const std::string& tag = stated.phase_names[stated.site_phase[s]];
            const std::string wanted = tag_of(shape_[s]);
            if (tag == wanted) continue;
            throw NotATile("law of the inclusions: the cell of site " + std::to_string(s) +
                           " has the tag " + tag + ", but its site lies in " + wanted);
        }
    }

    int shape_of_face(int f) const { return shape_[tile_.face_site[f]]; }

    /// Law (3).
    void require_areas() {
        std::vector<double> area(static_cast<std::size_t>(n_shapes_), 0);
        std::vector<double> perimeter = area;
        for (int f = 0; f < tile_.n_faces(); ++f) {
            const int k = shape_of_face(f);
            if (k < 0) continue;
            const Polygon polygon = face_polygon(tile_.points, tile_.faces[f]);
            area[k] += polygon_area(polygon) / copies_;
            perimeter[k] += polygon_perimeter(polygon) / copies_;
        }
        for (int k = 0; k < n_shapes_; ++k) {
            const double error = std::abs(area[k] - shape_area(set_[k].shape)) / domain_area_;
            const double tolerance = kSameArea + perimeter[k] * proof_.tolerance / domain_area_;
            area_error_ = std::max(area_error_, error);
            area_tolerance_ = std::max(area_tolerance_, tolerance);
            if (error <= tolerance) continue;
            refute(k, "the cells inside have the area " + figure(area[k]) + ", not " +
                          figure(shape_area(set_[k].shape)) + ": off by " + figure(error) +
                          " of the domain (tolerance " + figure(tolerance) + ")");
        }
    }

    /// The inclusion on the other side of each directed edge: -1 in the matrix and on walls.
    std::map<std::pair<int, int>, int> inclusions_beside_edges() const {
        std::map<std::pair<int, int>, int> left;
        for (int f = 0; f < tile_.n_faces(); ++f) {
            for (int c = 0; c < tile_.face_size(f); ++c) left[edge(f, c)] = shape_of_face(f);
        }
        std::map<std::pair<int, int>, int> right;
        for (const auto& [vertices, inclusion] : left) {
            right[{vertices.second, vertices.first}] = inclusion;
        }
        for (const EdgePair& pair : proof_.edge_pairs) {
            right[{pair.v0, pair.v1}] = left[{pair.w1, pair.w0}];
            right[{pair.w1, pair.w0}] = left[{pair.v0, pair.v1}];
        }
        return right;
    }
    std::pair<int, int> edge(int f, int c) const {
        const auto corners = tile_.faces[f];
        const int next = c + 1 == tile_.face_size(f) ? 0 : c + 1;
        return {proof_.first_copy[corners[c]], proof_.first_copy[corners[next]]};
    }

    void collect_edges() {
        const auto beside = inclusions_beside_edges();
        edges_.resize(static_cast<std::size_t>(set_.n_given()));
        for (int f = 0; f < tile_.n_faces(); ++f) {
            const int k = shape_of_face(f);
            if (k < 0) continue;
            for (int c = 0; c < tile_.face_size(f); ++c) {
                const auto [v, w] = edge(f, c);
                const auto other = beside.find({v, w});
                // Merged vertices leave edges of length 0.
                if (v == w || (other != beside.end() && other->second == k)) continue;
                const Vec2& p = tile_.points[v];
                const Vec2& q = tile_.points[w];
                add_edge(k, p, q);
            }
        }
    }
    /// Adds an edge to the copy of the shape whose outline is nearest.
    void add_edge(int k, const Vec2& p, const Vec2& q) {
        const Vec2 middle = (p + q) / 2;
        int copy = -1;
        Vec2 way(0, 0);
        double least = std::numeric_limits<double>::infinity();
        for (int m = k; m < set_.n_given(); m += n_shapes_) {
            const auto moved = set_.in_frame_of(m, middle);
            if (!moved) continue;
            const double distance = std::abs(signed_distance(set_[m].shape, *moved));
            if (distance >= least) continue;
            least = distance;
            copy = m;
            way = *moved - middle;
        }
        if (copy < 0) refute(k, "an edge beside it lies off its outline" + at(p));
        edges_[copy].push_back({p + way, q + way, 0});
    }
    static std::string at(const Vec2& p) {
        return " at (" + figure(p.x()) + ", " + figure(p.y()) + ")";
    }

    /// Law (2). @returns the number of edges.
    int prove_outline(int k) {
        std::vector<OutlineEdge>& edges = edges_[k];
        const auto* polygon = std::get_if<Polygon>(&set_[k].shape);
        for (OutlineEdge& outline : edges) {
            outline.place = polygon != nullptr ? place_on_polygon(k, *polygon, outline)
                                               : place_on_ellipse(k, outline);
        }
        std::sort(edges.begin(), edges.end(),
                  [](const OutlineEdge& x, const OutlineEdge& y) { return x.place < y.place; });
        if (edges.size() < 3) refute(k, "its outline is not closed by edges of cells");
        for (std::size_t m = 0; m < edges.size(); ++m) {
            const Vec2& next = edges[(m + 1) % edges.size()].from;
            if ((next - edges[m].to).norm() > near_) {
                refute(k, "its outline is not closed by edges of cells" + at(edges[m].to));
            }
        }
        if (polygon != nullptr) {
            require_corners(k, *polygon);
        } else {
            require_nodes(k);
        }
        return static_cast<int>(edges.size());
    }

    /// The side of the polygon on which an edge lies, and the fraction of that side.
    double place_on_polygon(int k, const Polygon& polygon, const OutlineEdge& outline) const {
        for (std::size_t m = 0; m < polygon.size(); ++m) {
            const Vec2 side = polygon[(m + 1) % polygon.size()] - polygon[m];
            const Vec2 along = side.normalized();
            const Vec2 p = outline.from - polygon[m];
            const Vec2 q = outline.to - polygon[m];
            const bool is_on = std::abs(cross(along, p)) <= near_ &&
                               std::abs(cross(along, q)) <= near_ && along.dot(p) >= -near_ &&
                               along.dot(q) <= side.norm() + near_ && along.dot(q - p) > 0;
            const double share = along.dot(p + q) / 2 / side.norm();
            if (is_on) return static_cast<double>(m) + std::clamp(share, 0.0, 1.0);
        }
        refute(k, "an edge lies off its sides" + at(outline.from));
    }

    /// Each corner of the polygon is the begin of an edge.
    void require_corners(int k, const Polygon& polygon) const {
        for (const Vec2& corner : polygon) {
            const bool found =
                std::any_of(edges_[k].begin(), edges_[k].end(), [&](const OutlineEdge& outline) {
                    return (outline.from - corner).norm() <= near_;
                });
            if (!found) refute(k, "its corner" + at(corner) + " is no vertex");
        }
    }

    EllipseAxes axes_of(int k) const {
        const auto* circle = std::get_if<Circle>(&set_[k].shape);
        return circle != nullptr ? ellipse_axes(*circle)
                                 : ellipse_axes(std::get<Ellipse>(set_[k].shape));
    }
    /// The ellipse becomes the unit circle.
    static Vec2 in_disc(const EllipseAxes& ellipse, const Vec2& p) {
        const Vec2 d = p - ellipse.centre;
        return {d.dot(ellipse.along) / ellipse.a, cross(ellipse.along, d) / ellipse.b};
    }

    /// The angle of the edge's middle.
    double place_on_ellipse(int k, const OutlineEdge& outline) const {
        const EllipseAxes ellipse = axes_of(k);
        const Vec2 p = in_disc(ellipse, outline.from);
        const Vec2 q = in_disc(ellipse, outline.to);
        if (!(cross(p, q) > 0)) refute(k, "an edge lies across its outline" + at(outline.from));
        return std::atan2((p + q).y(), (p + q).x());
    }

    /// All points where the outline turns have one distance from the centre, in units of the axes.
    void require_nodes(int k) const {
        const EllipseAxes ellipse = axes_of(k);
        const std::vector<OutlineEdge>& edges = edges_[k];
        double radius = 0;
        for (const OutlineEdge& outline : edges) {
            radius = std::max(radius, in_disc(ellipse, outline.from).norm());
        }
        for (std::size_t m = 0; m < edges.size(); ++m) {
            const Vec2& before = edges[(m + edges.size() - 1) % edges.size()].from;
            const Vec2& here = edges[m].from;
            const Vec2 chord = edges[m].to - before;
            const double turn = cross(chord, before - here) / chord.norm();
            const double off = (radius - in_disc(ellipse, here).norm()) * ellipse.b;
            if (off <= near_ || std::abs(turn) <= near_) continue;
            refute(k, "a node of its outline" + at(here) + " lies " + figure(off) +
                          " inside of the others");
        }
    }

    const TileFile& file_;
    const Tile& tile_;
    const TileProof& proof_;
    const InclusionFile& shapes_;
    InclusionSet set_;
    int n_shapes_;
    int copies_;
    double domain_area_;
    /// Length units.
    double near_ = 0;
    /// Of each site: its shape, or -1.
    std::vector<int> shape_;
    std::vector<std::vector<OutlineEdge>> edges_;
    double area_error_ = 0;
    double area_tolerance_ = 0;
};

}  // namespace

std::string prove_inclusions(const std::string& path, const TileFile& file, const TileProof& proof,
                             const InclusionFile& shapes) {
    if (!faces_have_sites(file.tile.kind)) {
        throw BadFile(path +
                      ": Delaunay triangles cross the outlines of inclusions; check a tile of "
                      "cells or grains of the same run");
    }
    if (file.tile.site_positions.empty() || file.tile.columns < 1) {
        throw BadFile(path + ": states no positions of its sites; check a format that holds them");
    }
    return InclusionCheck(file, proof, shapes).prove();
}

}  // namespace pcvt::cli
