#include "mesher/proof/moved_cells.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/lattice/offset_disjoint_sets.hpp"
#include "mesher/lattice/polygon.hpp"
#include "mesher/proof/dual_mean.hpp"
#include "mesher/proof/glued_faces.hpp"
#include "mesher/proof/law_violation.hpp"

namespace pcvt {
namespace {

using std::to_string;

const char* const kSiteLaw = "of the sites";

/// Corners agree with the mean of their Voronoi vertices within this, in units of h.
constexpr double kOffMean = 1e-7;
/// ... and within this many tolerances of positions.
constexpr double kRoundings = 8;
/// A corner at which k cells meet lies within k - 3 removed edges of each of its Voronoi vertices;
/// more cells than this meet nowhere, but for special lattices, whose corners are not moved.
constexpr int kMostCells = 8;

/// Some faces of one site, joined by edges.
struct Part {
    /// The image of the first face to which more than half of the area belongs, and how much more.
    Offset image = {};
    double lead = 0;
    bool goes_round = false;
};

/// The cell of a face at a corner, as the frame of the corner has it.
struct CellAtCorner {
    SiteId site;
    Offset image;
    /// From the corner to the site.
    Vec2 way;
    /// The halfedge at which the cell begins.
    int halfedge;

    bool same(const CellAtCorner& other) const {
        return site == other.site && image == other.image;
    }
};

/// All faces round an orbit of vertices.
struct Corner {
    int vertex = 0;
    std::vector<CellAtCorner> cells;
    /// The offsets of the tile at which the orbit has a vertex.
    std::vector<Offset> images;
    /// Whether the image of a face is not clear.
    bool is_unclear = false;

    /// Whether the orbit lies on the sides of the box that are translated by a (0) or b (1).
    bool on_line(int axis) const {
        return std::any_of(images.begin(), images.end(), [&](const Offset& image) {
            const Offset way = image - images.front();
            return axis == 0 ? way.i != 0 : way.j != 0;
        });
    }
};

class MovedCells {
   public:
    MovedCells(const Tile& tile, const TileProof& proof, const SiteImages& images,
               const CornerMoves& moves)
        : tile_(tile),
          images_(images),
          moves_(moves),
          orbits_(proven_orbits(proof)),
          faces_(glue_faces(tile, orbits_, Precision::kSingle)),
          rounding_(proof.tolerance),
          tolerance_(kOffMean * std::sqrt(images.cell_area()) + kRoundings * rounding_),
          skew_(tile.lattice.a().norm() * tile.lattice.b().norm() / tile.lattice.area()),
          part_(static_cast<std::size_t>(faces_.n_faces())),
          unclear_(static_cast<std::size_t>(faces_.n_faces()), false) {}

    FaceImages prove() {
        is_box_ = has_box_outline();
        join_faces();
        find_images();
        require_first_faces();
        require_corners();
        // A file of single precision may hold faces without area.
        FaceImages result{{}, are_clear_};
        for (int f = 0; f < tile_.n_faces(); ++f) {
            result.of_face.push_back(images_.nearest(tile_.face_site[f], middle_of(f)));
        }
        for (int f = 0; f < faces_.n_faces(); ++f) result.of_face[faces_.file_face[f]] = image_[f];
        return result;
    }

   private:
    SiteId site(int f) const { return tile_.face_site[faces_.file_face[f]]; }
    const Vec2& point(int h) const { return tile_.points[faces_.corners[h]]; }
    int face_across(int h) const { return faces_.face_of[faces_.opposite[h]]; }
    /// The image that the face across h names, as the face of h sees it.
    Offset seen_across(int h, Offset image) const {
        return image - images_.of_tile(faces_.across[h]);
    }

    Vec2 middle_of(int file_face) const {
        Vec2 sum(0, 0);
        for (const int v : tile_.faces[file_face]) sum += tile_.points[v];
        return sum / tile_.face_size(file_face);
    }

    /// Joins the faces of each site across the edges between them. A whole cell has no seam inside.
    void join_faces() {
        OffsetDisjointSets joined(faces_.n_faces());
        const auto within = [&](int h) {
            return faces_.opposite[h] > h && site(faces_.face_of[h]) == site(face_across(h)) &&
                   (is_box_ || !faces_.on_seam(h));
        };
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            checkpoint_each(h);
            if (within(h)) joined.join(faces_.face_of[h], face_across(h), seen_across(h, {}));
        }
        for (int f = 0; f < faces_.n_faces(); ++f) part_[f] = joined.root(f);
        parts_.resize(part_.size());
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            checkpoint_each(h);
            if (!within(h)) continue;
            const auto& here = part_[faces_.face_of[h]];
            const auto& there = part_[face_across(h)];
            if (here.offset != seen_across(h, there.offset)) parts_[here.orbit].goes_round = true;
        }
    }

    /// @returns for each site, whether its cells touch each other.
    std::vector<bool> sites_that_touch() const {
        const auto n = static_cast<std::size_t>(images_.n_sites());
        std::vector<int> n_parts(n, 0);
        std::vector<bool> touches(n, false);
        for (int f = 0; f < faces_.n_faces(); ++f) {
            if (part_[f].orbit != f) continue;
            ++n_parts[site(f)];
            if (parts_[f].goes_round) touches[site(f)] = true;
        }
        for (std::size_t s = 0; s < n; ++s) {
            if (n_parts[s] > images_.copies()) {
                throw_violation(kSiteLaw, "the faces of site " + to_string(s) + " form " +
                                              to_string(n_parts[s]) + " parts, more than the " +
                                              to_string(images_.copies()) + " periods of the tile");
            }
            if (n_parts[s] < images_.copies()) touches[s] = true;
        }
        return touches;
    }

    void find_images() {
        const std::vector<bool> touches = sites_that_touch();
        image_.resize(part_.size());
        for (int f = 0; f < faces_.n_faces(); ++f) {
            checkpoint_each(f);
            if (touches[site(f)]) {
                choose_side(f);
            } else {
                vote(f);
            }
        }
        for (int f = 0; f < faces_.n_faces(); ++f) {
            if (touches[site(f)]) continue;
            image_[f] = parts_[part_[f].orbit].image + part_[f].offset;
        }
        require_each_image(touches);
    }

    /// The side of the corner of a face, or of its middle, that is farthest from all bisectors.
    void choose_side(int f) {
        double deepest = -1;
        const auto compare = [&](const Vec2& p) {
            const SiteImages::Side side = images_.side_of(site(f), p);
            if (!(side.depth > deepest)) return;
            deepest = side.depth;
            image_[f] = side.offset;
        };
        compare(middle_of(faces_.file_face[f]));
        for (const int v : faces_[f]) compare(tile_.points[v]);
        unclear_[f] = deepest < kMostCells * moves_.removed + skew_ * moves_.snap;
    }

    /// Counts the area of a face for the nearest image of its site (Boyer and Moore's majority).
    void vote(int f) {
        Part& part = parts_[part_[f].orbit];
        const Offset image =
            images_.nearest(site(f), middle_of(faces_.file_face[f])) - part_[f].offset;
        Polygon polygon;
        for (const int v : faces_[f]) polygon.push_back(tile_.points[v]);
        const double area = polygon_area(polygon);
        if (part.image == image) {
            part.lead += area;
            return;
        }
        part.lead -= area;
        if (part.lead >= 0) return;
        part.image = image;
        part.lead = -part.lead;
    }

    void require_each_image(const std::vector<bool>& touches) const {
        const auto n_copies = static_cast<std::size_t>(images_.copies());
        std::vector<bool> found(touches.size() * n_copies, false);
        for (int f = 0; f < faces_.n_faces(); ++f) {
            found[std::size_t(site(f)) * n_copies + images_.copy_of(image_[f])] = true;
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
            if (found[k] || touches[k / n_copies]) continue;
            throw_violation(kSiteLaw, "site " + to_string(k / n_copies) +
                                          " has no cell in one of the periods of the tile");
        }
    }

    /// Law (4).
    void require_first_faces() const {
        std::vector<bool> seen(static_cast<std::size_t>(images_.n_sites()), false);
        for (int f = 0; f < faces_.n_faces(); ++f) {
            if (seen[site(f)]) continue;
            seen[site(f)] = true;
            if (image_[f] == Offset{} || unclear_[f]) continue;
            throw_violation(kSiteLaw, "face " + to_string(faces_.file_face[f]) +
                                          ", the first of site " + to_string(site(f)) +
                                          ", belongs to another image of the site");
        }
    }

    /// Whether the seam follows the sides of a parallelogram, as that of a box does.
    bool has_box_outline() const {
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            if (!faces_.on_seam(h)) continue;
            const Offset across = faces_.across[h];
            const bool along_a = across.i == 0;
            if (!along_a && across.j != 0) return false;
            const Vec2& side = along_a ? tile_.lattice.a() : tile_.lattice.b();
            const Vec2 edge = point(faces_.next(h)) - point(h);
            if (std::abs(cross(edge, side)) > tolerance_ * side.norm()) return false;
        }
        return true;
    }

    void require_corners() {
        std::vector<bool> seen(tile_.points.size(), false);
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            checkpoint_each(h);
            const int orbit = orbits_.representative[faces_.corners[h]];
            if (seen[orbit]) continue;
            seen[orbit] = true;
            const Corner corner = corner_at(h);
            const std::string fault = fault_of(corner);
            if (fault.empty()) continue;
            if (!corner.is_unclear) {
                throw_violation(kSiteLaw, "vertex " + to_string(corner.vertex) + fault);
            }
            are_clear_ = false;
        }
    }

    Corner corner_at(int first) const {
        Corner corner{.vertex = faces_.corners[first], .cells = {}, .images = {}};
        int h = first;
        do {
            const int f = faces_.face_of[h];
            const int v = faces_.corners[h];
            const Offset here = orbits_.offset[v];
            const CellAtCorner cell{site(f), image_[f] - images_.of_tile(here),
                                    images_.position(site(f), image_[f]) - tile_.points[v], h};
            if (corner.cells.empty() || !corner.cells.back().same(cell)) {
                corner.cells.push_back(cell);
            }
            if (std::find(corner.images.begin(), corner.images.end(), here) ==
                corner.images.end()) {
                corner.images.push_back(here);
            }
            corner.is_unclear = corner.is_unclear || unclear_[f];
            h = faces_.opposite[faces_.previous(h)];
        } while (h != first);
        // The first cell may begin before the first halfedge.
        if (corner.cells.size() > 1 && corner.cells.front().same(corner.cells.back())) {
            corner.cells.front().halfedge = corner.cells.back().halfedge;
            corner.cells.pop_back();
        }
        return corner;
    }

    /// @returns how the corner breaks a law; empty: it does not.
    std::string fault_of(const Corner& corner) const {
        const std::size_t n_cells = corner.cells.size();
        const bool at_box_corner = is_box_ && corner.on_line(0) && corner.on_line(1);
        if (n_cells < 2 || (n_cells == 2 && at_box_corner)) return "";
        if (n_cells == 2) return fault_of_edge(corner);
        for (std::size_t k = 0; k < n_cells; ++k) {
            for (std::size_t l = 0; l < k; ++l) {
                if (!corner.cells[k].same(corner.cells[l])) continue;
                return " meets the cell of site " + to_string(corner.cells[k].site) + " twice";
            }
        }
        return fault_of_mean(corner);
    }

    /// Law (8).
    std::string fault_of_edge(const Corner& corner) const {
        const auto way = [&](int k) {
            const int h = corner.cells[k].halfedge;
            return Vec2(point(faces_.next(h)) - point(h));
        };
        const Vec2 p = way(0);
        const Vec2 q = way(1);
        const double off = std::abs(cross(p, q)) / (p - q).norm();
        if (p.dot(q) < 0 && off <= tolerance_) return "";
        return " bends the edge between the cells of sites " + to_string(corner.cells[0].site) +
               " and " + to_string(corner.cells[1].site) + " by " + in_words(off);
    }

    /// Law (7).
    std::string fault_of_mean(const Corner& corner) const {
        std::vector<DualSite> polygon;
        std::string sites;
        for (const CellAtCorner& cell : corner.cells) {
            polygon.push_back({cell.way, images_.weight(cell.site)});
            sites += (sites.empty() ? "" : ", ") + to_string(cell.site);
        }
        const auto mean = dual_mean(polygon, rounding_);
        if (!mean) return " does not go round the sites of its faces, " + sites;
        const double off = mean->point.norm();
        const double tolerance = tolerance_ + mean->error;
        if (off <= tolerance || may_be_snapped(corner, mean->point, skew_ * tolerance)) return "";
        return " lies off the place that the sites of its faces, " + sites + ", give it, by " +
               in_words(off) + ", more than " + in_words(tolerance);
    }

    /// Whether grains in a box may have moved a corner by -way: along a period vector onto a side
    /// of the box, or to a corner of the box.
    bool may_be_snapped(const Corner& corner, const Vec2& way, double tolerance) const {
        if (!is_box_ || corner.images.size() < 2) return false;
        if (!(way.norm() <= skew_ * moves_.snap + tolerance)) return false;
        const bool on_a = corner.on_line(0);
        if (on_a && corner.on_line(1)) return true;
        const Vec2 u = tile_.lattice.to_lattice(way);
        const double off =
            on_a ? u.y() * tile_.lattice.b().norm() : u.x() * tile_.lattice.a().norm();
        return std::abs(off) <= tolerance;
    }

    const Tile& tile_;
    const SiteImages& images_;
    CornerMoves moves_;
    VertexOrbits orbits_;
    GluedFaces faces_;
    double rounding_;
    double tolerance_;
    /// How much farther a step along a period vector goes than across the other one.
    double skew_;
    /// For each face, the first face of its part, and the image of its site where that face has
    /// (0, 0).
    std::vector<OffsetDisjointSets::Root> part_;
    /// For each face that is the first of its part.
    std::vector<Part> parts_;
    std::vector<bool> unclear_;
    std::vector<Offset> image_;
    bool is_box_ = false;
    bool are_clear_ = true;
};

}  // namespace

FaceImages prove_moved_cells(const Tile& tile, const TileProof& proof, const SiteImages& images,
                             const CornerMoves& moves) {
    return MovedCells(tile, proof, images, moves).prove();
}

}  // namespace pcvt
