#include "mesher/plane/proof/site_labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/proof/round_tile.hpp"
#include "mesher/plane/proof/site_images.hpp"
#include "mesher/plane/proof/validate_walls.hpp"
#include "mesher/plane/proof/vertex_orbits.hpp"
#include "mesher/plane/tile/site_positions.hpp"

namespace pcvt::plane {
namespace {

using std::to_string;

/// The distances of a vertex from the sites of its cells agree within this, in units of h.
constexpr double kOffBisector = 1e-7;
/// ... and within this many tolerances of positions.
constexpr double kDistanceRoundings = 8;
/// The roundings of positions that are mapped to the round space of a metric and back.
constexpr double kMappings = 2;
/// The areas of the cells of an orbit agree within this, in units of their mean.
constexpr double kSameArea = 1e-6;
/// The ulps of each period vector's share.
constexpr double kShareUlps = 2;

/// In grains, edges shorter than this are removed from cells, and corners nearer to the box than
/// this are moved onto it, in units of h.
constexpr double kRemovedFromGrains = 0.02;
constexpr double kSnappedGrains = 0.04;

/// Law (1). @returns the number of sites.
int require_all_ids(const Tile& tile) {
    const std::vector<SiteId>& sites = tile.sites();
    const std::size_t stated = tile.site_positions.size();
    const std::size_t limit = stated > 0 ? stated : sites.size();
    std::vector<bool> occurs(limit, false);
    SiteId last = -1;
    for (std::size_t k = 0; k < sites.size(); ++k) {
        const SiteId site = sites[k];
        if (site < 0 || static_cast<std::size_t>(site) >= limit) {
            throw_violation(kSiteLaw, (faces_have_sites(tile.kind) ? "face " : "vertex ") +
                                          to_string(k) + " names site " + to_string(site) +
                                          "; there are at most " + to_string(limit));
        }
        occurs[static_cast<std::size_t>(site)] = true;
        last = std::max(last, site);
    }
    const int n = stated > 0 ? static_cast<int>(stated) : last + 1;
    for (int s = 0; s < n; ++s) {
        if (occurs[static_cast<std::size_t>(s)]) continue;
        throw_violation(kSiteLaw,
                        "no " + std::string(faces_have_sites(tile.kind) ? "face" : "vertex") +
                            " belongs to site " + to_string(s) + " of 0 to " + to_string(n - 1));
    }
    return n;
}

/// Checks that each site has the same number of owners.
void require_equal_shares(const std::vector<int>& owners, int share, const std::string& name) {
    for (std::size_t s = 0; s < owners.size(); ++s) {
        if (owners[s] == share) continue;
        throw_violation(kSiteLaw, "site " + to_string(s) + " has " + to_string(owners[s]) + " " +
                                      name + ", not " + to_string(share));
    }
}

/// Law (2).
void require_orbits(const Tile& tile, const TileProof& proof, int n_sites) {
    const VertexOrbits orbits = proven_orbits(proof);
    std::vector<int> n_orbits(static_cast<std::size_t>(n_sites), 0);
    for (int v = 0; v < tile.n_vertices(); ++v) {
        const int r = orbits.representative[v];
        if (r == v) ++n_orbits[tile.vertex_site[v]];
        if (tile.vertex_site[r] == tile.vertex_site[v]) continue;
        throw_violation(kSiteLaw, "vertex " + to_string(v) + " has site " +
                                      to_string(tile.vertex_site[v]) + ", but its image, vertex " +
                                      to_string(r) + ", has site " +
                                      to_string(tile.vertex_site[r]));
    }
    const int copies = tile.columns * tile.rows;
    require_equal_shares(n_orbits, copies > 0 ? copies : proof.n_orbits / n_sites, "orbits");
}

/// Law (5) of Delaunay triangles, and law (4).
void require_sites_at_vertices(const Tile& tile, const SiteImages& images, double tolerance) {
    std::vector<bool> seen(static_cast<std::size_t>(images.n_sites()), false);
    for (int v = 0; v < tile.n_vertices(); ++v) {
        const SiteId site = tile.vertex_site[v];
        const Offset offset = seen[site] ? images.nearest(site, tile.points[v]) : Offset{};
        seen[site] = true;
        const double off = (tile.points[v] - images.position(site, offset)).norm();
        if (off <= tolerance) continue;
        throw_violation(kSiteLaw, "site " + to_string(site) + " lies off vertex " + to_string(v) +
                                      ", which names it, by " + in_words(off));
    }
}

/// The mean of the corners of a face, which lies inside of a convex one.
Vec2 face_middle(const Tile& tile, int f) {
    Vec2 sum(0, 0);
    for (const int v : tile.faces[f]) sum += tile.points[v];
    return sum / tile.face_size(f);
}

/// Laws (4) and (5) of cells and grains. @returns the image of its site for each face.
std::vector<Offset> images_of_faces(const Tile& tile, const SiteImages& images) {
    std::vector<bool> seen(static_cast<std::size_t>(images.n_sites()), false);
    const auto n_copies = static_cast<std::size_t>(images.copies());
    if (seen.size() * n_copies > static_cast<std::size_t>(tile.n_faces())) {
        throw_violation(kSiteLaw, "the tile has fewer faces than images of its sites");
    }
    std::vector<bool> has_face(seen.size() * n_copies, false);
    std::vector<Offset> offsets;
    offsets.reserve(static_cast<std::size_t>(tile.n_faces()));
    for (int f = 0; f < tile.n_faces(); ++f) {
        const SiteId site = tile.face_site[f];
        offsets.push_back(images.nearest(site, face_middle(tile, f)));
        if (!seen[site] && offsets.back() != Offset{}) {
            throw_violation(kSiteLaw, "face " + to_string(f) + ", the first of site " +
                                          to_string(site) +
                                          ", lies nearer to another image of the site");
        }
        seen[site] = true;
        has_face[std::size_t(site) * n_copies + images.copy_of(offsets.back())] = true;
    }
    for (std::size_t k = 0; k < has_face.size(); ++k) {
        if (has_face[k]) continue;
        throw_violation(kSiteLaw, "site " + to_string(k / n_copies) +
                                      " has no cell in one of the periods of the tile");
    }
    return offsets;
}

/// The differences between the distances of an orbit from the sites of its faces.
struct Meeting {
    double first_distance = -1;
    double spread = 0;

    void add(double distance) {
        if (first_distance < 0) first_distance = distance;
        spread = std::max(spread, std::abs(distance - first_distance));
    }
};

/// Proves law (6).
class Equidistance {
   public:
    Equidistance(const Tile& tile, const TileProof& proof, const SiteImages& images,
                 std::vector<Offset> of_face)
        : tile_(tile),
          orbits_(proven_orbits(proof)),
          images_(images),
          of_face_(std::move(of_face)),
          rounding_(kDistanceRoundings * proof.tolerance),
          off_bisector_(kOffBisector * std::sqrt(images.cell_area())),
          meetings_(tile.points.size()) {}

    void require() {
        for (int f = 0; f < tile_.n_faces(); ++f) {
            checkpoint_each(f);
            for (const int v : tile_.faces[f]) {
                meetings_[orbits_.representative[v]].add(
                    images_.distance(tile_.points[v], tile_.face_site[f], of_face_[f]));
            }
        }
        for (int v = 0; v < tile_.n_vertices(); ++v) {
            if (!(meetings_[v].spread <= off_bisector_ + rounding_)) require_at(v);
        }
    }

   private:
    Vec2 site_of(int f) const { return images_.position(tile_.face_site[f], of_face_[f]); }

    /// The corners of faces at an orbit.
    std::vector<std::pair<int, int>> corners_at(int orbit) const {
        std::vector<std::pair<int, int>> corners;
        for (int f = 0; f < tile_.n_faces(); ++f) {
            for (const int v : tile_.faces[f]) {
                if (orbits_.representative[v] == orbit) corners.emplace_back(f, v);
            }
        }
        return corners;
    }

    /// The distance of a site from the nearest other one that does not coincide with it.
    double from_others(int f, const Vec2& site) const {
        double nearest = std::numeric_limits<double>::infinity();
        for (SiteId other = 0; other < images_.n_sites(); ++other) {
            if (other == tile_.face_site[f]) continue;
            const Offset offset = images_.nearest(other, site);
            const double between = (images_.position(other, offset) - site).norm();
            if (between > rounding_) nearest = std::min(nearest, between);
        }
        return nearest;
    }

    /// Compares the distances at one orbit again. Where two sites lie close together compared with
    /// their distance from a vertex, rounding moves the vertex farther, and with it the points at
    /// which a box cuts its edges.
    void require_at(int orbit) const {
        const auto corners = corners_at(orbit);
        double nearest = std::numeric_limits<double>::infinity();
        double farthest = 0;
        for (const auto& [f, v] : corners) {
            const Vec2 from_f = site_of(f) - tile_.points[v];
            farthest = std::max(farthest, from_f.norm());
            nearest = std::min(nearest, from_others(f, site_of(f)));
            for (const auto& [g, w] : corners) {
                const double between = (site_of(g) - tile_.points[w] - from_f).norm();
                if (between > rounding_) nearest = std::min(nearest, between);
            }
        }
        const double spread = meetings_[orbit].spread;
        const double tolerance = off_bisector_ + rounding_ * std::max(1.0, farthest / nearest);
        if (spread <= tolerance) return;
        std::string cells;
        for (const auto& [f, v] : corners) {
            cells += (cells.empty() ? "" : ", ") + to_string(tile_.face_site[f]);
        }
        throw_violation(kSiteLaw, "vertex " + to_string(orbit) +
                                      " is not equally far from the sites of its faces, " + cells +
                                      ": the distances differ by " + in_words(spread) +
                                      ", more than " + in_words(tolerance));
    }

    const Tile& tile_;
    VertexOrbits orbits_;
    const SiteImages& images_;
    std::vector<Offset> of_face_;
    double rounding_;
    double off_bisector_;
    std::vector<Meeting> meetings_;
};

/// Law (3).
void require_faces(const Tile& tile, int n_sites) {
    if (tile.columns == 0) return;
    std::vector<int> n_faces(static_cast<std::size_t>(n_sites), 0);
    for (const SiteId site : tile.face_site) ++n_faces[site];
    const int share = tile.columns * tile.rows;
    for (int s = 0; s < n_sites; ++s) {
        if (n_faces[s] >= share) continue;
        throw_violation(kSiteLaw, "site " + to_string(s) + " has " + to_string(n_faces[s]) +
                                      " faces, fewer than the " + to_string(share) +
                                      " periods of the tile");
    }
}

/// The roundings of the period vectors in a translation of the tile: where the vectors are not
/// reduced, the multiples that make up a short translation are long.
double translation_rounding(const Lattice& lattice) {
    double multiple = 1;
    for (const int entry : reduce(lattice).m) {
        multiple = std::max(multiple, std::abs(double(entry)));
    }
    return kShareUlps * std::numeric_limits<double>::epsilon() * multiple *
           (lattice.a().norm() + lattice.b().norm());
}

/// Proves a tile in its round space.
/// @param stretch  by which lengths of the file may have grown in the tile.
/// @param walls    those whose mirror images the tile contains.
FaceImages prove_round_sites(const Tile& tile, const TileProof& proof, double stretch,
                             Walls walls = Walls::kNone) {
    if (tile.sites().empty()) return {};
    const int n_sites = require_all_ids(tile);
    const bool owned = faces_have_sites(tile.kind);
    if (!owned) require_orbits(tile, proof, n_sites);
    if (!tile.site_weights.empty() && std::ssize(tile.site_weights) != n_sites) {
        throw_violation(kSiteLaw, "there are " + to_string(tile.site_weights.size()) +
                                      " weights for " + to_string(n_sites) + " sites");
    }
    std::vector<Vec2> positions = site_positions(tile);
    if (positions.empty()) {
        if (owned) require_faces(tile, n_sites);
        return {};
    }
    const SiteImages images(tile, std::move(positions));
    const bool is_grains = tile.kind == MeshKind::kGrains;
    if (is_grains || (owned && tile.short_edges > 0)) {
        require_faces(tile, n_sites);
        const double h = stretch * std::sqrt(images.cell_area());
        const double removed =
            is_grains ? std::max(kRemovedFromGrains, tile.short_edges) : tile.short_edges;
        return prove_moved_cells(tile, proof, images,
                                 {removed * h, (is_grains ? kSnappedGrains : 0) * h, walls});
    }
    if (owned) {
        Equidistance(tile, proof, images, images_of_faces(tile, images)).require();
    } else {
        require_sites_at_vertices(tile, images, kDistanceRoundings * proof.tolerance);
    }
    return {};
}

}  // namespace

FaceImages prove_sites(const Tile& tile, const TileProof& proof) {
    if (tile.walls != Walls::kNone) {
        const Tile torus = mirrored_tile(with_exact_walls(tile, proof.tolerance));
        FaceImages images =
            prove_round_sites(torus, prove_cover(torus, proof.precision), 1, tile.walls);
        const auto n_faces = static_cast<std::size_t>(tile.n_faces());
        if (images.of_face.size() > n_faces) images.of_face.resize(n_faces);
        return images;
    }
    if (tile.metric.is_round()) return prove_round_sites(tile, proof, 1);
    const double stretch = tile.metric.largest_stretch();
    TileProof round = proof;
    round.tolerance = kMappings * stretch * (proof.tolerance + translation_rounding(tile.lattice));
    return prove_round_sites(round_tile(tile), round, stretch);
}

void prove_orbit_areas(const Tile& tile, const TileProof& proof, std::span<const int> site_orbits) {
    if (tile.kind != MeshKind::kVoronoi || tile.short_edges > 0) return;
    std::vector<double> area(site_orbits.size(), 0);
    for (int f = 0; f < tile.n_faces(); ++f) {
        area[tile.face_site[f]] += polygon_area(face_polygon(tile.points, tile.faces[f]));
    }
    const double mean = tile.lattice.area() / static_cast<double>(area.size());
    const double tolerance = kSameArea * mean + std::sqrt(mean) * proof.tolerance;
    std::vector<std::size_t> first;
    for (std::size_t s = 0; s < area.size(); ++s) {
        const auto orbit = static_cast<std::size_t>(site_orbits[s]);
        if (orbit == first.size()) first.push_back(s);
        const std::size_t other = first[orbit];
        if (std::abs(area[s] - area[other]) <= tolerance) continue;
        throw_violation("of the orbits", "the cells of sites " + to_string(other) + " and " +
                                             to_string(s) + " are on orbit " + to_string(orbit) +
                                             ", but their areas differ by " +
                                             in_words(area[s] - area[other]));
    }
}

}  // namespace pcvt::plane
