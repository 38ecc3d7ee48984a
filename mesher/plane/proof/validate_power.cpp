#include "mesher/plane/proof/validate_power.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/base/law_violation.hpp"
#include "mesher/plane/proof/proven_faces.hpp"

namespace pcvt::plane {
namespace {

/// Returns the site of each cell.
/// @throws InvalidInput unless these are all sites, each once.
std::vector<SiteId> sites_of_cells(const Tile& tile, const ProvenFaces& faces, Eigen::Index n) {
    const int n_cells = faces.glued().n_faces();
    const bool whole = tile.kind == MeshKind::kVoronoi && n_cells == n &&
                       tile.face_site.size() == static_cast<std::size_t>(tile.n_faces());
    std::vector<SiteId> sites;
    std::vector<bool> found(static_cast<std::size_t>(n), false);
    for (int f = 0; whole && f < n_cells; ++f) {
        const SiteId s = tile.face_site[faces.file_face(f)];
        if (s < 0 || s >= n || found[s]) break;
        found[s] = true;
        sites.push_back(s);
    }
    if (std::ssize(sites) != n) {
        throw InvalidInput("the tile does not have one whole cell for each of the " +
                           std::to_string(n) +
                           " sites; ask for the power cells of a tile of whole cells");
    }
    return sites;
}

/// Returns the image of p that is nearest to `centre`.
Vec2 nearest_image(const Reduction& reduction, const Vec2& p, const Vec2& centre) {
    const Lattice& reduced = reduction.reduced;
    const Vec2 u = reduced.to_lattice(centre - p);
    const Offset near{static_cast<int>(std::floor(u.x())), static_cast<int>(std::floor(u.y()))};
    Vec2 nearest = p;
    double least = std::numeric_limits<double>::infinity();
    for (int i = -1; i <= 2; ++i) {
        for (int j = -1; j <= 2; ++j) {
            const Vec2 image = p + reduced.translation(near + Offset{i, j});
            const double squared = (image - centre).squaredNorm();
            if (!(squared < least)) continue;
            least = squared;
            nearest = image;
        }
    }
    return nearest;
}

/// A line of equal power distance, and the side of it on which the right site's cell lies.
struct PowerLine {
    Vec2 normal;
    Vec2 foot;

    PowerLine(const Vec2& left, double left_weight, const Vec2& right, double right_weight) {
        const Vec2 d = right - left;
        const double length = d.stableNorm();
        normal = d / length;
        foot = (left + right) / 2 + (left_weight - right_weight) / (2 * length) * normal;
    }
    double beyond(const Vec2& p) const { return normal.dot(p - foot); }
};

}  // namespace

double prove_power_cells(const Tile& tile, const TileProof& proof, const Points& points,
                         const Eigen::VectorXd& weights, double tolerance) {
    const ProvenFaces faces(tile, proof);
    const GluedFaces& glued = faces.glued();
    const std::vector<SiteId> site = sites_of_cells(tile, faces, points.cols());
    const double h = std::sqrt(tile.lattice.area() / glued.n_faces());
    // Find the image of the site of each cell.
    const std::vector<Vec2> centroid = require_convex_cells(faces, h, tolerance, polygon_centroid);
    const Reduction reduction = reduce(tile.lattice);
    std::vector<Vec2> position;
    for (int f = 0; f < glued.n_faces(); ++f) {
        position.push_back(nearest_image(reduction, points.col(site[f]), centroid[f]));
    }
    // Check each edge from both sides.
    double largest = 0;
    for (int side = 0; side < glued.n_halfedges(); ++side) {
        const int left = glued.face_of[side];
        const int right = faces.face_across(side);
        const PowerLine line(position[left], weights[site[left]],
                             position[right] + faces.back_across(side), weights[site[right]]);
        const double distance = std::max(std::abs(line.beyond(faces.from(side))),
                                         std::abs(line.beyond(faces.to(side)))) /
                                h;
        if (!(distance <= tolerance)) {
            throw_violation(kVoronoiLaw, "a corner of the " + faces.edge_name(side) +
                                             " lies off the line of equal power distance by " +
                                             against(distance, tolerance));
        }
        if (!(line.beyond(centroid[left]) < 0)) {
            throw_violation(kVoronoiLaw, faces.name(left) +
                                             " lies beyond the line of equal power distance at " +
                                             faces.edge_name(side));
        }
        largest = std::max(largest, distance);
    }
    return largest;
}

}  // namespace pcvt::plane
