#include "plugin/checks/inclusion_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "io/bytes/readable_number.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/interfaces/inclusion_set.hpp"
#include "mesher/plane/interfaces/listed_images.hpp"
#include "plugin/checks/outline_proof.hpp"

namespace pcvt::checks {
namespace {

/// In units of the area of the domain.
constexpr double kSameArea = 1e-12;
/// Nodes come from the corners of cells, whose rounding errors add up.
constexpr double kRoundings = 8;

/// Calls `work`, whose refusals name the file of the shapes.
template <class Work>
auto naming_shapes(const InclusionFile& shapes, const Work& work) {
    try {
        return work();
    } catch (const plane::BadInclusion& error) {
        throw UnusableFile(error.in_file(shapes.name));
    } catch (const InvalidInput& error) {
        throw UnusableFile(shapes.name + ": " + error.what());
    }
}

/// The lattice of a tile that has `columns` x `rows` copies of its domain.
plane::Lattice domain_of(const plane::Tile& tile) {
    return {tile.lattice.a() / tile.columns, tile.lattice.b() / tile.rows};
}

/// The file without shapes that are images of others.
InclusionFile distinct_shapes(const plane::Tile& tile, InclusionFile file) {
    file.inclusions = naming_shapes(file, [&] {
        return plane::without_listed_images(domain_of(tile), tile.walls, file.inclusions);
    });
    return file;
}

/// The shapes of all copies of the domain: shape k of copy c is inclusion k + c n.
plane::InclusionSet set_of(const plane::Tile& tile, const InclusionFile& shapes) {
    const plane::Lattice domain = domain_of(tile);
    std::vector<plane::Inclusion> all;
    for (int j = 0; j < tile.rows; ++j) {
        for (int i = 0; i < tile.columns; ++i) {
            for (plane::Inclusion copy : shapes.inclusions) {
                copy.shape = translated(copy.shape, domain.translation({i, j}));
                all.push_back(std::move(copy));
            }
        }
    }
    return naming_shapes(shapes, [&] {
        // Faults are those of the shapes of one domain.
        const plane::InclusionSet one(domain, shapes.inclusions, tile.walls);
        return plane::InclusionSet(tile.lattice, std::move(all), tile.walls);
    });
}

class InclusionCheck {
   public:
    InclusionCheck(const TileFile& file, const plane::TileProof& proof, const InclusionFile& shapes)
        : file_(file),
          tile_(file.tile),
          proof_(proof),
          shapes_(distinct_shapes(tile_, shapes)),
          set_(set_of(tile_, shapes_)),
          n_shapes_(static_cast<int>(shapes_.inclusions.size())),
          n_images_(static_cast<int>(shapes.inclusions.size()) - n_shapes_),
          copies_(tile_.columns * tile_.rows),
          domain_area_(tile_.lattice.area() / copies_) {
        const double n = static_cast<double>(tile_.site_positions.size());
        near_ = std::max(plane::kSameVertex * std::sqrt(domain_area_ / n),
                         kRoundings * proof.tolerance);
    }

    std::string prove() {
        for (const plane::Vec2& site : tile_.site_positions) {
            const int k = set_.containing(site);
            shape_.push_back(k < 0 ? -1 : k % n_shapes_);
        }
        require_holes();
        require_tags();
        edges_.resize(static_cast<std::size_t>(set_.n_given()));
        collect_hole_edges();
        require_areas();
        collect_edges();
        int n_edges = 0;
        for (int k = 0; k < set_.n_given(); ++k) {
            prove_outline(set_[k].shape, edges_[k], near_, law_at(k));
            n_edges += static_cast<int>(edges_[k].size());
        }
        const auto n_holes = std::count(is_hole_.begin(), is_hole_.end(), true);
        return ", " + std::to_string(n_shapes_) + " inclusions of " + shapes_.name +
               (n_images_ > 0 ? " (" + counted(n_images_, "listed image") + " left out)" : "") +
               (n_holes > 0 ? ", " + std::to_string(n_holes) + " of them holes," : "") + " with " +
               std::to_string(n_edges) + " edges on their outlines, areas within " +
               figure(area_error_) + " of the domain (tolerance " + figure(area_tolerance_) + ")" +
               (tags().empty() ? ", no tags stored" : ", tags agree");
    }

   private:
    [[noreturn]] void refute(int k, const std::string& what) const {
        throw NotATile(law_at(k) + what);
    }
    /// The beginning of a message about a shape.
    std::string law_at(int k) const {
        return "law of the inclusions: " + shapes_.name + ":" + std::to_string(set_[k].line) + ": ";
    }

    std::string tag_of(int inclusion) const {
        if (inclusion < 0) return kMatrixTag;
        return shapes_.tags[static_cast<std::size_t>(set_[inclusion].tag - 1)];
    }

    /// Finds the shapes whose cells are left out: those with the tag of a hole. No site lies there.
    void require_holes() {
        for (int k = 0; k < n_shapes_; ++k) {
            const std::string tag = tag_of(k);
            is_hole_.push_back(std::find(tile_.holes.begin(), tile_.holes.end(), tag) !=
                               tile_.holes.end());
        }
        for (std::size_t s = 0; s < shape_.size(); ++s) {
            if (shape_[s] < 0 || !is_hole_[shape_[s]]) continue;
            refute(shape_[s], "site " + std::to_string(s) +
                                  " lies inside, but the cells with the " + "tag " +
                                  tag_of(shape_[s]) + " are left out");
        }
        for (const std::string& hole : tile_.holes) {
            const auto found = std::find(shapes_.tags.begin(), shapes_.tags.end(), hole);
            if (found != shapes_.tags.end()) continue;
            throw NotATile("law of the inclusions: the cells with the tag " + hole +
                           " are left out, which no shape of " + shapes_.name + " has");
        }
    }

    /// The tags that the file states, or shows by the materials of its faces.
    const CellMaterials& tags() const {
        return file_.materials.site_phase.empty() ? file_.shown : file_.materials;
    }

    /// Law (1).
    void require_tags() const {
        const CellMaterials& stated = tags();
        for (std::size_t s = 0; s < stated.site_phase.size(); ++s) {
            const std::string& tag = stated.phase_names[stated.site_phase[s]];
            const std::string wanted = tag_of(shape_[s]);
            if (tag == wanted) continue;
            throw NotATile("law of the inclusions: the cell of site " + std::to_string(s) +
                           " has the tag " + tag + ", but its site lies in " + wanted);
        }
    }

    int shape_of_face(int f) const { return shape_[tile_.face_site[f]]; }

    /// Law (3). The area of a hole is that of the polygon of its outline.
    void require_areas() {
        std::vector<double> area(static_cast<std::size_t>(n_shapes_), 0);
        std::vector<double> perimeter = area;
        for (int k = 0; k < set_.n_given(); ++k) {
            if (!is_hole_[k % n_shapes_]) continue;
            for (const OutlineEdge& outline : edges_[k]) {
                // From the first node, so that a place far from the origin costs no digits.
                const plane::Vec2& base = edges_[k].front().from;
                area[k % n_shapes_] +=
                    plane::cross(outline.from - base, outline.to - base) / 2 / copies_;
                perimeter[k % n_shapes_] += (outline.to - outline.from).norm() / copies_;
            }
        }
        for (int f = 0; f < tile_.n_faces(); ++f) {
            const int k = shape_of_face(f);
            if (k < 0) continue;
            const plane::Polygon polygon = plane::face_polygon(tile_.points, tile_.faces[f]);
            area[k] += plane::polygon_area(polygon) / copies_;
            perimeter[k] += plane::polygon_perimeter(polygon) / copies_;
        }
        std::vector<double> wanted(area.size(), 0);
        for (int k = 0; k < n_shapes_; ++k) {
            const double of_shape = shape_area(set_[k].shape);
            wanted[k] += of_shape;
            if (parent_of(k) >= 0) wanted[parent_of(k)] -= of_shape;
        }
        for (int k = 0; k < n_shapes_; ++k) {
            const double error = std::abs(area[k] - wanted[k]) / domain_area_;
            const double tolerance = kSameArea + perimeter[k] * proof_.tolerance / domain_area_;
            area_error_ = std::max(area_error_, error);
            area_tolerance_ = std::max(area_tolerance_, tolerance);
            if (error <= tolerance) continue;
            refute(k, std::string(is_hole_[k] ? "the hole has" : "the cells inside have") +
                          " the area " + figure(area[k]) + ", not " + figure(wanted[k]) +
                          ": off by " + figure(error) + " of the domain (tolerance " +
                          figure(tolerance) + ")");
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
        for (const plane::EdgePair& pair : proof_.edge_pairs) {
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

    /// The shape with a shape of one domain right inside, or -1.
    int parent_of(int k) const {
        const int parent = set_.parent(k);
        return parent < 0 ? -1 : parent % n_shapes_;
    }
    /// Whether an edge between shape k and another one is none of its outline: the other one is the
    /// same, or lies right inside, so that the edge is of its outline.
    bool is_within(int other, int k) const {
        return other == k || (other >= 0 && parent_of(other) == k);
    }

    void collect_edges() {
        const auto beside = inclusions_beside_edges();
        std::set<std::pair<int, int>> at_holes;
        for (const auto& [wall, v, w] : proof_.wall_edges) {
            if (wall.is_hole()) at_holes.insert({v, w});
        }
        for (int f = 0; f < tile_.n_faces(); ++f) {
            const int k = shape_of_face(f);
            if (k < 0) continue;
            for (int c = 0; c < tile_.face_size(f); ++c) {
                const auto [v, w] = edge(f, c);
                const auto other = beside.find({v, w});
                // Merged vertices leave edges of length 0.
                if (v == w || at_holes.contains({v, w})) continue;
                if (other != beside.end() && is_within(other->second, k)) continue;
                const plane::Vec2& p = tile_.points[v];
                const plane::Vec2& q = tile_.points[w];
                add_edge(k, p, q);
            }
        }
    }
    /// The edges of holes, which have a face of the tile on their left.
    void collect_hole_edges() {
        for (const auto& [wall, v, w] : proof_.wall_edges) {
            if (!wall.is_hole()) continue;
            const std::string& tag = tile_.holes[wall.hole()];
            const int first = static_cast<int>(
                std::find(shapes_.tags.begin(), shapes_.tags.end(), tag) - shapes_.tags.begin());
            add_edge([&](int k) { return set_[k].tag == first + 1; }, tile_.points[w],
                     tile_.points[v]);
        }
    }
    /// Adds an edge to the copy of the shape whose outline is nearest.
    void add_edge(int k, const plane::Vec2& p, const plane::Vec2& q) {
        if (add_edge([&](int m) { return m % n_shapes_ == k; }, p, q)) return;
        refute(k, "an edge beside it lies off its outline" + place_in_words(p));
    }
    /// The same among the shapes that `may_be` accepts. @returns whether there is one.
    template <class MayBe>
    bool add_edge(const MayBe& may_be, const plane::Vec2& p, const plane::Vec2& q) {
        const plane::Vec2 middle = (p + q) / 2;
        int copy = -1;
        plane::Vec2 way(0, 0);
        double least = std::numeric_limits<double>::infinity();
        for (int m = 0; m < set_.n_given(); ++m) {
            if (!may_be(m)) continue;
            const auto moved = set_.in_frame_of(m, middle);
            if (!moved) continue;
            const double distance = std::abs(signed_distance(set_[m].shape, *moved));
            if (distance >= least) continue;
            least = distance;
            copy = m;
            way = *moved - middle;
        }
        if (copy >= 0) edges_[copy].push_back({p + way, q + way, 0});
        return copy >= 0;
    }

    const TileFile& file_;
    const plane::Tile& tile_;
    const plane::TileProof& proof_;
    InclusionFile shapes_;
    plane::InclusionSet set_;
    int n_shapes_;
    /// Shapes of the file that are images of others.
    int n_images_;
    int copies_;
    double domain_area_;
    /// Length units.
    double near_ = 0;
    /// The shape of each site, or -1.
    std::vector<int> shape_;
    /// Whether the cells of each shape of one domain are left out.
    std::vector<bool> is_hole_;
    std::vector<std::vector<OutlineEdge>> edges_;
    double area_error_ = 0;
    double area_tolerance_ = 0;
};

}  // namespace

std::string prove_inclusions(const std::string& path, const TileFile& file,
                             const plane::TileProof& proof, const InclusionFile& shapes) {
    if (!faces_have_sites(file.tile.kind)) {
        throw UnusableFile(path +
                           ": Delaunay triangles cross the outlines of inclusions; check a tile of "
                           "cells or grains of the same run");
    }
    if (file.tile.site_positions.empty() || file.tile.columns < 1) {
        throw UnusableFile(path +
                           ": states no positions of its sites; check a format that holds them");
    }
    return InclusionCheck(file, proof, shapes).prove();
}

}  // namespace pcvt::checks
