#include "mesher/space/grains/grain_mesh.hpp"

#include <algorithm>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/cell_choice.hpp"
#include "mesher/space/mesh/cell_ties.hpp"

namespace pcvt::space {
namespace {

class GrainLayout {
   public:
    GrainLayout(const Sites& sites, const CellComplex& complex, const GrainSurface& surface,
                const std::vector<CellHull>& hulls, const std::vector<CellTetrahedra>& cells,
                const Vec3& origin)
        : complex_(complex),
          surface_(surface),
          hulls_(hulls),
          cells_(cells),
          reduction_(sites.reduction()),
          frames_(tied_images(
              complex, reduction_,
              chosen_images(complex, cell_bodies(complex),
                            domain_corner(sites.lattice(), sites.reduction(), origin)))),
          mesh_{.tetrahedra = {.lattice = sites.lattice()}} {}

    GrainMesh build() {
        number_nodes();
        add_points();
        for (int c = 0; c < complex_.n_cells; ++c) {
            checkpoint();
            add_tetrahedra(c);
        }
        for (int f = 0; f < complex_.n_faces(); ++f) {
            checkpoint_each(f);
            add_triangles(f);
        }
        return std::move(mesh_);
    }

   private:
    /// An image of a node with the offset in the given basis.
    NodeImage placed(const NodeImage& image, SiteId cell) const {
        return {image.vertex, reduction_.to_original(image.offset + frames_[cell])};
    }

    /// The image that a vertex of a cell is.
    NodeImage image_of(SiteId cell, int vertex) const {
        return vertex < cells_[cell].n_hull() ? placed(hulls_[cell].images[vertex], cell)
                                              : NodeImage{inner_[cell][vertex], {}};
    }

    /// Numbers the vertices inside of cells behind the nodes of faces; their only images are those
    /// in the tile.
    void number_nodes() {
        int n = static_cast<int>(surface_.nodes.size());
        for (const CellTetrahedra& cell : cells_) {
            std::vector<int>& numbers = inner_.emplace_back(cell.n_vertices(), -1);
            for (int v = cell.n_hull(); v < cell.n_vertices(); ++v) {
                if (cell.is_used(v)) numbers[v] = n++;
            }
        }
    }

    void add_point(const NodeImage& image, const Vec3& position, const Offset& from_first) {
        images_.push_back(image);
        mesh_.tetrahedra.points.push_back(position);
        mesh_.tetrahedra.point_site.push_back(image.vertex);
        mesh_.tetrahedra.point_offset.push_back(from_first);
    }

    /// Adds the points in the order of their images; the images of a node follow each other, and
    /// all but the first are the first one plus a translation.
    void add_points() {
        std::vector<NodeImage> images;
        for (int c = 0; c < complex_.n_cells; ++c) {
            for (const NodeImage& image : hulls_[c].images) images.push_back(placed(image, c));
        }
        std::sort(images.begin(), images.end());
        images.erase(std::unique(images.begin(), images.end()), images.end());
        const Lattice& lattice = mesh_.tetrahedra.lattice;
        NodeImage first{-1, {}};
        Vec3 position = Vec3::Zero();
        for (const NodeImage& image : images) {
            if (image.vertex != first.vertex) {
                first = image;
                position =
                    surface_.nodes[image.vertex].position + lattice.translation(image.offset);
            }
            const Offset offset = image.offset - first.offset;
            add_point(image, position + lattice.translation(offset), offset);
        }
        for (int c = 0; c < complex_.n_cells; ++c) {
            const Vec3 shift = complex_.reduced.translation(frames_[c]);
            const CellTetrahedra& cell = cells_[c];
            for (int v = cell.n_hull(); v < cell.n_vertices(); ++v) {
                if (cell.is_used(v)) add_point({inner_[c][v], {}}, cell.point(v) + shift, {});
            }
        }
    }

    int point(const NodeImage& image) const {
        const auto found = std::lower_bound(images_.begin(), images_.end(), image);
        return static_cast<int>(found - images_.begin());
    }

    void add_tetrahedra(SiteId c) {
        const CellTetrahedra& cell = cells_[c];
        std::vector<int> points;
        for (int v = 0; v < cell.n_vertices(); ++v) {
            points.push_back(cell.is_used(v) ? point(image_of(c, v)) : -1);
        }
        for (int t = 0; t < cell.n_numbers(); ++t) {
            if (!cell.is_alive(t)) continue;
            const FourCorners& corners = cell.corners(t);
            mesh_.tetrahedra.tetrahedra.push_back(
                {points[corners[0]], points[corners[1]], points[corners[2]], points[corners[3]]});
            mesh_.tetrahedra.cell.push_back(complex_.site_of(c));
        }
    }

    void add_triangles(int f) {
        const CellFace& face = complex_.faces[f];
        for (const SurfaceTriangle& corners : surface_.triangles[f]) {
            GrainTriangle triangle{.cell = complex_.site_of(face.cell),
                                   .neighbour = complex_.site_of(face.neighbour)};
            for (std::size_t k = 0; k < 3; ++k) {
                const NodeImage here = placed(corners[k], face.cell);
                const NodeImage there =
                    placed({corners[k].vertex, corners[k].offset - face.offset}, face.neighbour);
                triangle.points[k] = point(here);
                triangle.partners[k] = point(there);
                triangle.offset = there.offset - here.offset;
            }
            mesh_.triangles.push_back(triangle);
        }
    }

    const CellComplex& complex_;
    const GrainSurface& surface_;
    const std::vector<CellHull>& hulls_;
    const std::vector<CellTetrahedra>& cells_;
    const Reduction& reduction_;
    /// The offset of the chosen image of each cell, in the reduced basis.
    std::vector<Offset> frames_;
    /// For each cell and vertex inside of it its node.
    std::vector<std::vector<int>> inner_;
    /// The image that each point is: rising.
    std::vector<NodeImage> images_;
    GrainMesh mesh_;
};

}  // namespace

GrainMesh grain_mesh(const Sites& sites, const CellComplex& complex, const GrainSurface& surface,
                     const std::vector<CellHull>& hulls, const std::vector<CellTetrahedra>& cells,
                     const Vec3& origin) {
    return GrainLayout(sites, complex, surface, hulls, cells, origin).build();
}

}  // namespace pcvt::space
