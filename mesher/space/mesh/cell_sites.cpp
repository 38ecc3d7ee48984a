#include "mesher/space/mesh/cell_sites.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/mesh/elongated_cells.hpp"

namespace pcvt::space {
namespace {

/// Returns the image of p that is nearest to q. Each step goes to the best of the 26 neighbours;
/// they contain all facets of the Voronoi cell of a reduced lattice, so that no step is left only
/// at the nearest image.
Vec3 nearest_image(const Lattice& reduced, const Vec3& p, const Vec3& q) {
    const Vec3 whole = reduced.to_lattice(q - p).array().round();
    Vec3 best = p + reduced.to_position(whole);
    for (bool moved = true; moved;) {
        moved = false;
        const Vec3 centre = best;
        for (int k = 0; k < 27; ++k) {
            const Offset offset{k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1};
            const Vec3 image = centre + reduced.translation(offset);
            if (!((image - q).squaredNorm() < (best - q).squaredNorm())) continue;
            best = image;
            moved = true;
        }
    }
    return best;
}

[[noreturn]] void refuse_cell(int cell, const std::string& what) {
    throw_violation("of Voronoi cells", "cell " + std::to_string(cell) + " " + what);
}

/// Roundings of a coordinate on its way into a tile and into a plane.
constexpr double kRoundings = 4;

/// Images of one site differ by no more in each coordinate, and those of two sites by more.
template <class Positions>
double same_site_distance(double spacing, const Positions& sites) {
    constexpr double kPartOfSpacing = 1e-10;
    constexpr double kUlps = 8;
    return kPartOfSpacing * spacing +
           kUlps * std::numeric_limits<double>::epsilon() * sites.cwiseAbs().maxCoeff();
}

/// The centroid of each cell; of each piece that of its cell, in the frame of the piece.
std::vector<Vec3> cell_centroids(const PolyhedralMesh& mesh, const Points& sites) {
    const std::vector<CellBody> bodies = cell_bodies(mesh);
    std::vector<Vec3> centroids;
    if (mesh.piece_cell.empty()) {
        for (const CellBody& body : bodies) centroids.push_back(body.centroid);
        return centroids;
    }
    const auto n = static_cast<std::size_t>(mesh.n_sites());
    std::vector<double> volumes(n, 0);
    std::vector<Vec3> from_site(n, Vec3::Zero());
    for (int p = 0; p < mesh.n_cells; ++p) {
        volumes[mesh.piece_cell[p]] += bodies[p].volume;
        from_site[mesh.piece_cell[p]] += bodies[p].volume * (bodies[p].centroid - sites.col(p));
    }
    for (int p = 0; p < mesh.n_cells; ++p) {
        const SiteId cell = mesh.piece_cell[p];
        centroids.push_back(sites.col(p) + from_site[cell] / volumes[cell]);
    }
    return centroids;
}

/// Examines the faces of a tile against the planes between sites.
class BisectorProof {
   public:
    BisectorProof(const PolyhedralMesh& mesh, const Points& sites, const Eigen::VectorXd& weights,
                  double spacing)
        : mesh_(mesh),
          sites_(sites),
          weights_(weights),
          centroids_(cell_centroids(mesh, sites)),
          spacing_(spacing) {}

    /// @param other  the image of the site on the other side of the face, that of cell `across`.
    void prove_face(int face, int across, const Vec3& other) {
        const int cell = mesh_.owner[face];
        const Vec3 site = sites_.col(cell);
        const auto [middle, direction, distance] =
            plane_between(cell, across, other, sites_, weights_);
        for (const int v : mesh_.faces[face]) {
            const Vec3 from_middle = mesh_.points[v] - middle;
            const double off = std::abs(from_middle.dot(direction)) / spacing_;
            // The plane between near sites turns with the rounding of their positions.
            const double turn = kRoundings * std::numeric_limits<double>::epsilon() *
                                std::max(site.cwiseAbs().maxCoeff(), other.cwiseAbs().maxCoeff()) /
                                distance;
            const double turned = turn * from_middle.norm() / spacing_;
            if (!(off <= kBisectorTolerance + mesh_.short_edges + turned)) {
                refuse_cell(cell,
                            "has a corner off the plane between its site and a neighbour by " +
                                in_words(off) + " h");
            }
            figures_.from_bisector = std::max(figures_.from_bisector, off);
        }
        if (!((centroids_[cell] - middle).dot(direction) < 0)) {
            refuse_cell(cell, "lies on the side of the site of a neighbour");
        }
    }

    CellSiteFigures figures() {
        for (int p = 0; p < mesh_.n_cells; ++p) {
            const double off = (centroids_[p] - sites_.col(p)).norm() / spacing_;
            figures_.from_centroid = std::max(figures_.from_centroid, off);
        }
        return figures_;
    }

   private:
    const PolyhedralMesh& mesh_;
    const Points& sites_;
    const Eigen::VectorXd& weights_;
    std::vector<Vec3> centroids_;
    double spacing_;
    CellSiteFigures figures_;
};

}  // namespace

Points sites_in_cells(const Sites& sites, const PolyhedralMesh& mesh) {
    const std::vector<CellBody> bodies = cell_bodies(mesh);
    Points images(3, sites.n_sites());
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        checkpoint_each(s);
        // The centroid lies inside of the cell, where the image in the cell is the nearest one.
        images.col(s) =
            nearest_image(sites.reduction().reduced, sites.position(s), bodies[s].centroid);
    }
    return images;
}

Points sites_of_cells(const CellComplex& complex, const std::vector<Offset>& images) {
    Points sites(3, complex.n_cells);
    for (int s = 0; s < complex.n_cells; ++s) {
        sites.col(s) = complex.sites[s] + complex.reduced.translation(images[s]);
    }
    return sites;
}

std::vector<SiteId> cells_of_pieces(const Lattice& lattice, const Points& sites) {
    std::vector<SiteId> cells;
    const auto n = static_cast<int>(sites.cols());
    if (n == 0) return {};
    const double near = same_site_distance(lattice.spacing(n), sites);
    for (int p = 0; p < n; ++p) {
        checkpoint_each(p);
        if (p == 0) {
            cells.push_back(0);
            continue;
        }
        const Vec3 step = sites.col(p) - sites.col(p - 1);
        const Vec3 whole = lattice.to_lattice(step).array().round();
        const bool is_same = (step - lattice.to_position(whole)).cwiseAbs().maxCoeff() <= near;
        cells.push_back(cells.back() + (is_same ? 0 : 1));
    }
    if (cells.back() == n - 1) return {};
    return cells;
}

bool is_cut(const PolyhedralMesh& mesh, int cell, int across, const Vec3& site, const Vec3& other) {
    if (mesh.piece_cell.empty() || mesh.site_of(cell) != mesh.site_of(across)) return false;
    const double spacing = mesh.lattice.spacing(mesh.n_cells);
    return (other - site).cwiseAbs().maxCoeff() <= same_site_distance(spacing, site);
}

SitePlane plane_between(int cell, int across, const Vec3& other, const Points& sites,
                        const Eigen::VectorXd& weights) {
    const Vec3 site = sites.col(cell);
    const double distance = (other - site).norm();
    const Vec3 direction = (other - site) / distance;
    Vec3 middle = (site + other) / 2;
    if (weights.size() > 0) {
        middle += (weights[cell] - weights[across]) / (2 * distance) * direction;
    }
    return {middle, direction, distance};
}

CellSiteFigures prove_cell_sites(const PolyhedralMesh& mesh, const Points& sites,
                                 const Eigen::VectorXd& weights) {
    if (sites.cols() != mesh.n_cells) {
        throw_violation(kSiteLaw, "there are " + std::to_string(sites.cols()) + " sites of " +
                                      std::to_string(mesh.n_cells) + " cells");
    }
    if (!mesh.metric.is_round()) {
        return prove_cell_sites(to_round(mesh), mesh.metric.to_round(sites), weights);
    }
    const double spacing = portable_cbrt(mesh.lattice.volume() / mesh.n_sites());
    BisectorProof proof(mesh, sites, weights, spacing);
    for_each_side(mesh, sites, [&](int face, int across, const Vec3& other) {
        proof.prove_face(face, across, other);
    });
    return proof.figures();
}

}  // namespace pcvt::space
