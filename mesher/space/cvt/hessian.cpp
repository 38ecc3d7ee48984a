#include "mesher/space/cvt/hessian.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/delaunay/predicates.hpp"

namespace pcvt::space {
namespace {

using Eigen::Matrix3d;

/// Tetrahedra whose six-fold volume is below this part of the cube of their longest edge get their
/// circumcentre from the exact predicates.
constexpr double kThin = 1e-5;

/// The positions of the corners of a tetrahedron relative to corner 0, and its circumcentre.
struct TetrahedronShape {
    std::array<Vec3, 4> corner;
    Vec3 centre;

    TetrahedronShape(const Tetrahedron& corners, const Points& coordinates, const Frame& frame) {
        const Vec3 origin = image(coordinates, corners[0]).at;
        std::array<Vec3, 3> d;
        corner[0].setZero();
        for (int c = 0; c < 3; ++c) {
            d[c] = image(coordinates, corners[c + 1]).at - origin;
            corner[c + 1] = frame.to_position(d[c]);
        }
        Matrix3d edges;
        edges << corner[1].transpose(), corner[2].transpose(), corner[3].transpose();
        const Vec3 squares = edges.rowwise().squaredNorm();
        const double longest = std::sqrt(squares.maxCoeff());
        if (edges.determinant() > kThin * longest * longest * longest) {
            centre = edges.partialPivLu().solve(squares / 2);
        } else {
            centre = frame.to_position(exact_circumcentre(frame.gram, d));
        }
    }
};

/// The blocks beside the diagonal in the row of a site, one for each neighbour.
struct Row {
    std::vector<std::pair<SiteId, Matrix3d>> blocks;

    void add(SiteId neighbour, const Matrix3d& block) {
        const auto found = std::find_if(blocks.begin(), blocks.end(), [neighbour](const auto& b) {
            return b.first == neighbour;
        });
        if (found == blocks.end()) {
            blocks.emplace_back(neighbour, block);
        } else {
            found->second += block;
        }
    }
};

/// The contribution of one triangle of a facet to H_ij, divided by its weight.
Matrix3d triangle_term(const Vec3& d, const Vec3& u, const Vec3& v) {
    const Vec3 s = u + v;
    return (u * u.transpose() + v * v.transpose() + s * s.transpose()) / 12 +
           (d * s.transpose() - s * d.transpose()) / 6 - d * d.transpose() / 4;
}

/// Adds the three triangles of facets that lie beside face f of a tetrahedron.
void add_face(const Tetrahedron& corners, const TetrahedronShape& shape, int f,
              std::vector<Row>& rows) {
    const std::array<int, 3>& face = TorusTetrahedra::kFacetCorners[f];
    const auto& p = shape.corner;
    const Vec3 normal = (p[face[1]] - p[face[0]]).cross(p[face[2]] - p[face[0]]);
    const double height = (shape.centre - p[face[0]]).dot(normal) / normal.squaredNorm();
    const Vec3 face_centre = shape.centre - height * normal;
    for (int e = 0; e < 3; ++e) {
        const int i = face[e];
        const int j = face[(e + 1) % 3];
        const int k = face[(e + 2) % 3];
        const SiteId here = corners[i].site;
        const SiteId there = corners[j].site;
        if (here == there) continue;
        const Vec3 middle = (p[i] + p[j]) / 2;
        const double weight = (p[i] - p[k]).dot(p[j] - p[k]) * height / 2;
        const Matrix3d block =
            weight * triangle_term(p[j] - p[i], face_centre - middle, shape.centre - middle);
        rows[here].add(there, block);
        rows[there].add(here, block.transpose());
    }
}

/// Part r, c of a matrix with a row and a column of zeros added.
BlockMatrix::Block part(const Matrix3d& matrix, int r, int c) {
    BlockMatrix::Block block{};
    for (int k = 0; k < 4; ++k) {
        const int row = 2 * r + k % 2;
        const int column = 2 * c + k / 2;
        if (row < 3 && column < 3) block[k] = static_cast<float>(matrix(row, column));
    }
    return block;
}

/// Fills the two rows of a site.
void fill_rows(SiteId site, const Row& row, double unused, BlockMatrix& hessian) {
    Matrix3d diagonal = Matrix3d::Zero();
    for (const auto& [neighbour, block] : row.blocks) {
        diagonal -= block.cast<float>().cast<double>();
    }
    diagonal = (0.5 * (diagonal + diagonal.transpose())).eval();
    for (int r = 0; r < 2; ++r) {
        int entry = hessian.row_begin[2 * site + r];
        hessian.column[entry] = 2 * site + 1 - r;
        hessian.block[entry++] = part(diagonal, r, 1 - r);
        for (const auto& [neighbour, block] : row.blocks) {
            for (int c = 0; c < 2; ++c) {
                hessian.column[entry] = 2 * neighbour + c;
                hessian.block[entry++] = part(block, r, c);
            }
        }
    }
    hessian.diagonal[2 * site] = {diagonal(0, 0), diagonal(1, 0), diagonal(0, 1), diagonal(1, 1)};
    hessian.diagonal[2 * site + 1] = {diagonal(2, 2), 0, 0, unused};
}

}  // namespace

void assemble_hessian(const TorusTetrahedra& tetrahedra, const Points& coordinates,
                      const Frame& frame, BlockMatrix& hessian) {
    // Sum up the blocks of each pair of neighbours.
    std::vector<Row> rows(static_cast<std::size_t>(coordinates.cols()));
    for (int t = 0; t < tetrahedra.n_tetrahedra(); ++t) {
        checkpoint_each(t);
        const Tetrahedron corners = tetrahedra.tetrahedron(t);
        const TetrahedronShape shape(corners, coordinates, frame);
        for (int f = 0; f < 4; ++f) add_face(corners, shape, f, rows);
    }
    // Lay them out.
    std::vector<int> n_entries;
    for (const Row& row : rows)
        n_entries.insert(n_entries.end(), 2, 1 + 2 * int(row.blocks.size()));
    hessian.resize(n_entries);
    hessian.annihilates_translations = false;
    const double unused = 2 * frame.volume() / static_cast<double>(rows.size());
    for (SiteId s = 0; s < tetrahedra.n_sites(); ++s) fill_rows(s, rows[s], unused, hessian);
}

}  // namespace pcvt::space
