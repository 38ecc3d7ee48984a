#include "mesher/plane/proof/moved_cells.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/geometry/dual_mean.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/face_images.hpp"
#include "mesher/plane/proof/glued_faces.hpp"

namespace pcvt::plane {
namespace {

using std::to_string;

/// Corners agree with the mean of their Voronoi vertices within this, in units of h.
constexpr double kOffMean = 1e-7;
/// ... and within this many tolerances of positions.
constexpr double kCornerRoundings = 8;
/// A corner at which k cells meet lies within k - 3 removed edges of each of its Voronoi vertices;
/// more cells than this meet nowhere, but for special lattices, whose corners are not moved.
constexpr int kMostCells = 8;
/// The Voronoi vertices of such a corner lie within k - 2 removed edges of it, times this factor,
/// because joined corners move. The one of power cells is larger, because their weights change so
/// that the cells keep their areas.
constexpr double kMostSpread = 2;
constexpr double kMostSpreadOfPowerCells = 8;

/// The cell of a face at a corner, as the frame of the corner has it.
struct CellAtCorner {
    SiteId site;
    Offset image;
    /// The vector from the corner to the site.
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
    /// Whether the orbit lies on the edge of a hole.
    bool is_at_hole = false;

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
          tolerance_(kOffMean * std::sqrt(images.cell_area()) + kCornerRoundings * rounding_),
          skew_(tile.lattice.a().norm() * tile.lattice.b().norm() / tile.lattice.area()) {}

    FaceImages prove() {
        is_box_ = has_box_outline();
        const double reach = kMostCells * moves_.removed + skew_ * moves_.snap;
        found_ = find_face_images(tile_, faces_, images_,
                                  {.is_box = is_box_, .reach = reach, .walls = moves_.walls});
        require_corners();
        // Only a file of single precision holds faces without area, which have no cell.
        FaceImages result{std::vector<Offset>(static_cast<std::size_t>(tile_.n_faces())),
                          are_clear_};
        for (int f = 0; f < faces_.n_faces(); ++f) {
            result.of_face[faces_.file_face[f]] = found_.image[f];
        }
        return result;
    }

   private:
    SiteId site(int f) const { return tile_.face_site[faces_.file_face[f]]; }
    const Vec2& point(int h) const { return tile_.points[faces_.corners[h]]; }

    /// Whether the seam follows the sides of a parallelogram, as that of a box does.
    bool has_box_outline() const {
        for (int h = 0; h < faces_.n_halfedges(); ++h) {
            if (!faces_.on_seam(h) || faces_.on_wall(h)) continue;
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

    /// The halfedge at the corner of h from which a walk round the corner meets all faces.
    int first_at_corner(int h) const {
        // Back, until the halfedge before lies on a wall or is met again.
        for (int g = h; !faces_.on_wall(g);) {
            g = faces_.next(faces_.opposite[g]);
            if (g == h || faces_.on_wall(g)) return g;
        }
        return h;
    }

    Corner corner_at(int at) const {
        const int first = first_at_corner(at);
        Corner corner{.vertex = faces_.corners[first], .cells = {}, .images = {}};
        corner.is_at_hole = faces_.on_wall(first);
        int h = first;
        do {
            const int f = faces_.face_of[h];
            const int v = faces_.corners[h];
            const Offset here = orbits_.offset[v];
            const CellAtCorner cell{site(f), found_.image[f] - images_.of_tile(here),
                                    images_.position(site(f), found_.image[f]) - tile_.points[v],
                                    h};
            if (corner.cells.empty() || !corner.cells.back().same(cell)) {
                corner.cells.push_back(cell);
            }
            if (std::find(corner.images.begin(), corner.images.end(), here) ==
                corner.images.end()) {
                corner.images.push_back(here);
            }
            corner.is_unclear = corner.is_unclear || found_.is_unclear[f];
            h = faces_.opposite[faces_.previous(h)];
        } while (h != first && !faces_.on_wall(h));
        // The first cell may begin before the first halfedge.
        if (!corner.is_at_hole && corner.cells.size() > 1 &&
            corner.cells.front().same(corner.cells.back())) {
            corner.cells.front().halfedge = corner.cells.back().halfedge;
            corner.cells.pop_back();
        }
        return corner;
    }

    /// @returns the law that the corner breaks, in words; empty: none.
    std::string fault_of(const Corner& corner) const {
        if (corner.is_at_hole) return fault_of_distances(corner);
        const std::size_t n_cells = corner.cells.size();
        // Between walls, the corners of the outline lie on walls, at which no edge is bent.
        const bool at_box_corner =
            is_box_ && moves_.walls == Walls::kNone && corner.on_line(0) && corner.on_line(1);
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

    /// Law (6), of corners on the edges of holes, which are not moved.
    std::string fault_of_distances(const Corner& corner) const {
        for (const CellAtCorner& cell : corner.cells) {
            const double off = std::abs(cell.way.norm() - corner.cells.front().way.norm());
            if (off <= tolerance_) continue;
            return ", on the edge of a hole, is not equally far from sites " +
                   to_string(corner.cells.front().site) + " and " + to_string(cell.site) +
                   ": the distances differ by " + in_words(off);
        }
        return "";
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

    /// Whether rounding may have turned a triangle of three sites round, or made it a line, as it
    /// does where single precision makes two sites one.
    bool may_be_flat(const std::vector<DualSite>& polygon) const {
        for (std::size_t k = 2; k < polygon.size(); ++k) {
            for (std::size_t j = 1; j < k; ++j) {
                for (std::size_t i = 0; i < j; ++i) {
                    const Vec2 e = polygon[j].point - polygon[i].point;
                    const Vec2 f = polygon[k].point - polygon[i].point;
                    const double rounding_of_cross = 2 * rounding_ * (e.norm() + f.norm());
                    if (std::abs(cross(e, f)) <= rounding_of_cross) return true;
                }
            }
        }
        return false;
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
        if (!mean && may_be_flat(polygon)) return "";
        if (!mean) return " does not go round the sites of its faces, " + sites;
        const double off = mean->point.norm();
        const double tolerance = tolerance_ + mean->error;
        const double n_corners = static_cast<double>(corner.cells.size()) - 2;
        const double factor = tile_.site_weights.empty() ? kMostSpread : kMostSpreadOfPowerCells;
        const double reach = n_corners * (factor * moves_.removed + tolerance);
        if (mean->spread > reach) {
            return " joins corners of the cells of sites " + sites + ", which lie " +
                   in_words(mean->spread) + " apart, more than " + in_words(reach);
        }
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
    GluedImages found_;
    bool is_box_ = false;
    bool are_clear_ = true;
};

}  // namespace

FaceImages prove_moved_cells(const Tile& tile, const TileProof& proof, const SiteImages& images,
                             const CornerMoves& moves) {
    return MovedCells(tile, proof, images, moves).prove();
}

}  // namespace pcvt::plane
