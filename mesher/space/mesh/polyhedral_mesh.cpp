#include "mesher/space/mesh/polyhedral_mesh.hpp"

#include <algorithm>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/cell_choice.hpp"

namespace pcvt::space {
namespace {

/// A face of the tile: face `face` of the complex translated by `shift`, reversed where its owner
/// is the cell in front of it.
struct PlacedFace {
    int face;
    Offset shift;
    bool reversed;
    int owner;
    /// The cell on the other side, in the tile or in the copy of it.
    int other;
    /// From this face to its partner, in the reduced basis and in that of the user; zero for inner
    /// faces.
    Offset translation;
    Offset to_partner;
};

struct PlacedFaces {
    std::vector<PlacedFace> inner;
    /// One face of each pair.
    std::vector<PlacedFace> masters;
};

/// The same face of the complex, seen from the other cell, at the other end of the translation.
PlacedFace partner_of(const PlacedFace& face) {
    return {.face = face.face,
            .shift = face.shift + face.translation,
            .reversed = !face.reversed,
            .owner = face.other,
            .other = face.owner,
            .translation = -face.translation,
            .to_partner = -face.to_partner};
}

PlacedFaces placed_faces(const CellComplex& complex, const std::vector<Offset>& images,
                         const Reduction& reduction) {
    PlacedFaces placed;
    for (int f = 0; f < complex.n_faces(); ++f) {
        checkpoint_each(f);
        const CellFace& face = complex.faces[f];
        const Offset shift = images[face.cell];
        const Offset translation = images[face.neighbour] - (shift + face.offset);
        PlacedFace here{.face = f,
                        .shift = shift,
                        .reversed = false,
                        .owner = face.cell,
                        .other = face.neighbour,
                        .translation = translation,
                        .to_partner = reduction.to_original(translation)};
        if (translation == Offset{}) {
            if (here.other < here.owner) {
                std::swap(here.owner, here.other);
                here.reversed = true;
            }
            placed.inner.push_back(here);
        } else {
            if (here.to_partner < Offset{}) here = partner_of(here);
            placed.masters.push_back(here);
        }
    }
    std::sort(placed.inner.begin(), placed.inner.end(), [](const auto& s, const auto& t) {
        return std::tie(s.owner, s.other, s.face) < std::tie(t.owner, t.other, t.face);
    });
    std::sort(placed.masters.begin(), placed.masters.end(), [](const auto& s, const auto& t) {
        return std::tie(s.to_partner, s.owner, s.other, s.face) <
               std::tie(t.to_partner, t.owner, t.other, t.face);
    });
    return placed;
}

/// Appends faces on vertex images, which become numbered points at the end.
class MeshBuilder {
   public:
    MeshBuilder(const CellComplex& complex, const Reduction& reduction, PolyhedralMesh& mesh)
        : complex_(complex),
          reduction_(reduction),
          is_box_(!complex.piece_cell.empty()),
          mesh_(mesh) {}

    void add_inner(const PlacedFace& face) {
        add(face);
        mesh_.neighbour.push_back(face.other);
    }

    /// Adds the two patches of masters that share a translation.
    void add_seam(std::span<const PlacedFace> masters) {
        add_seam_patches(masters[0].to_partner, static_cast<int>(masters.size()), mesh_);
        for (const PlacedFace& face : masters) add(face);
        for (const PlacedFace& face : masters) add(partner_of(face));
    }

    /// Numbers the images of vertices by vertex and offset.
    void number_points() {
        std::vector<VertexImage> images = corners_;
        std::sort(images.begin(), images.end());
        images.erase(std::unique(images.begin(), images.end()), images.end());
        std::size_t first = 0;
        for (std::size_t k = 0; k < images.size(); ++k) {
            checkpoint_each(static_cast<long>(k));
            if (images[k].vertex != images[first].vertex) first = k;
            const Offset offset = to_original(images[k].offset - images[first].offset);
            mesh_.point_orbit.push_back(static_cast<int>(first));
            mesh_.point_offset.push_back(offset);
            mesh_.points.push_back(first == k
                                       ? position(images[k])
                                       : mesh_.points[first] + mesh_.lattice.translation(offset));
        }
        for (std::size_t k = 0; k < corners_.size(); ++k) {
            checkpoint_each(static_cast<long>(k));
            const auto found = std::lower_bound(images.begin(), images.end(), corners_[k]);
            mesh_.faces.corners.push_back(static_cast<int>(found - images.begin()));
        }
    }

   private:
    /// Images of vertices of a box are sorted by offsets in the basis of the user, so that the
    /// first one lies on the lower sides.
    Offset sorted_offset(const Offset& reduced) const {
        return is_box_ ? reduction_.to_original(reduced) : reduced;
    }
    Offset to_original(const Offset& sorted) const {
        return is_box_ ? sorted : reduction_.to_original(sorted);
    }
    Vec3 position(const VertexImage& sorted) const {
        if (!is_box_) return complex_.position(sorted);
        return complex_.vertices[sorted.vertex] + mesh_.lattice.translation(sorted.offset);
    }

    void add(const PlacedFace& face) {
        const auto corners = complex_.corners_of(face.face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            // A reversed face begins at the same corner, so that partners match.
            const auto& corner = corners[face.reversed ? (corners.size() - k) % corners.size() : k];
            corners_.push_back({corner.vertex, sorted_offset(corner.offset + face.shift)});
        }
        mesh_.faces.begin.push_back(static_cast<int>(corners_.size()));
        mesh_.owner.push_back(face.owner);
    }

    const CellComplex& complex_;
    const Reduction& reduction_;
    bool is_box_;
    PolyhedralMesh& mesh_;
    std::vector<VertexImage> corners_;
};

}  // namespace

void add_seam_patches(const Offset& offset, int n, PolyhedralMesh& mesh) {
    pcvt::add_seam_patches({offset.i, offset.j, offset.k}, mesh.lattice.translation(offset),
                           mesh.lattice.translation(-offset), n, mesh);
}

PolyhedralMesh polyhedral_mesh(const Sites& sites, const CellComplex& complex, const Vec3& origin,
                               std::vector<Offset>* images_of_cells) {
    const Reduction& reduction = sites.reduction();
    const std::vector<Offset> images = chosen_images(
        complex, cell_bodies(complex), domain_corner(sites.lattice(), reduction, origin));
    if (images_of_cells != nullptr) *images_of_cells = images;
    const PlacedFaces placed = placed_faces(complex, images, reduction);
    PolyhedralMesh mesh{{.n_cells = complex.n_cells}, sites.lattice()};
    mesh.piece_cell = complex.piece_cell;
    mesh.short_edges = complex.short_edges;
    MeshBuilder builder(complex, reduction, mesh);
    for (const PlacedFace& face : placed.inner) builder.add_inner(face);
    const std::span<const PlacedFace> masters(placed.masters);
    for (std::size_t begin = 0; begin < masters.size();) {
        std::size_t end = begin;
        while (end < masters.size() && masters[end].to_partner == masters[begin].to_partner) ++end;
        builder.add_seam(masters.subspan(begin, end - begin));
        begin = end;
    }
    builder.number_points();
    return mesh;
}

}  // namespace pcvt::space
