#include "plugin/job/space_box.hpp"

#include <utility>

#include "mesher/base/law_violation.hpp"
#include "mesher/space/box/box_cells.hpp"
#include "mesher/space/box/box_sides.hpp"
#include "mesher/space/proof/box_proof.hpp"

namespace pcvt {

space::Vec3 tile_origin(const Job& job, const space::Tessellation& cells) {
    const bool is_box = job.tile.outline == plane::Outline::kBox;
    return is_box ? cells.box_origin.value_or(job.in_space().origin) : job.in_space().origin;
}

space::CellComplex outlined_cells(const Job& job, const space::Tessellation& cells,
                                  space::CellComplex complex, double snapped) {
    if (job.tile.outline != plane::Outline::kBox) return complex;
    return cells_in_box(cells.sites(), complex, tile_origin(job, cells), snapped);
}

void make_box(const space::Vec3& origin, SpaceTile& tile) {
    put_on_sides(origin, tile.mesh);
    std::vector<SiteId>& piece_cell = tile.mesh.piece_cell;
    if (tile.mesh.n_sites() == tile.mesh.n_cells) {
        // The box cuts no cell: files hold the whole ones.
        piece_cell.clear();
        return;
    }
    const auto of_pieces = [&](const auto& of_cells) {
        std::decay_t<decltype(of_cells)> values;
        if (of_cells.empty()) return values;
        for (const SiteId cell : piece_cell) values.push_back(of_cells[cell]);
        return values;
    };
    tile.materials.site_phase = of_pieces(tile.materials.site_phase);
    tile.materials.site_orientation = of_pieces(tile.materials.site_orientation);
    if (tile.weights.size() == 0) return;
    Eigen::VectorXd weights(std::ssize(piece_cell));
    for (Eigen::Index p = 0; p < weights.size(); ++p) weights[p] = tile.weights[piece_cell[p]];
    tile.weights = std::move(weights);
}

void require_box(const space::PolyhedralMesh& mesh, double tolerance) {
    if (box_corner(mesh, tolerance)) return;
    throw NotATile("the sides of the box are not flat");
}

}  // namespace pcvt
