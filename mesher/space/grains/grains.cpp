#include "mesher/space/grains/grains.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/workers.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/grains/cell_filling.hpp"
#include "mesher/space/grains/shared_moves.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

constexpr double kDefaultPart = 1.0 / 3;
/// The size of tetrahedra in a flat piece of a cell over its thickness, and the least part of their
/// size in the whole cell. Larger tetrahedra are flat, and smaller ones make those beside them
/// flat.
constexpr double kThicknesses = 3;
constexpr double kLeastPart = 0.3;
/// The sine of 18 degrees: cells below are filled again on their moved faces.
constexpr double kFilledAgain = 0.3090169943749474;
constexpr int kRelaxations = 3;
constexpr int kMovesInRound = 2;

/// The volumes of the cells over half of their surfaces: the thickness of flat ones.
std::vector<double> thicknesses(const CellComplex& complex, const std::vector<CellBody>& bodies) {
    std::vector<double> surfaces(bodies.size(), 0);
    for (int f = 0; f < complex.n_faces(); ++f) {
        const auto corners = complex.corners_of(f);
        const Vec3 first = complex.position(corners[0]);
        Vec3 twice = Vec3::Zero();
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            twice += cross_product(complex.position(corners[k]) - first,
                                   complex.position(corners[k + 1]) - first);
        }
        surfaces[complex.faces[f].cell] += length(twice) / 2;
        surfaces[complex.faces[f].neighbour] += length(twice) / 2;
    }
    std::vector<double> found;
    for (std::size_t c = 0; c < bodies.size(); ++c) {
        found.push_back(2 * bodies[c].volume / surfaces[c]);
    }
    return found;
}

/// The sizes of the cells; those of pieces are the sizes of their cells, or about their thickness.
std::vector<double> cell_sizes(const CellComplex& complex, double size) {
    const std::vector<CellBody> bodies = cell_bodies(complex);
    std::vector<double> volumes(bodies.size(), 0);
    for (int c = 0; c < complex.n_cells; ++c) volumes[complex.site_of(c)] += bodies[c].volume;
    std::vector<double> sizes;
    for (int c = 0; c < complex.n_cells; ++c) {
        const double edge = portable_cbrt(volumes[complex.site_of(c)]);
        sizes.push_back(size > 0 ? std::min(size, kLargestSize * edge) : kDefaultPart * edge);
    }
    if (complex.piece_cell.empty()) return sizes;
    const std::vector<double> thickness = thicknesses(complex, bodies);
    for (int c = 0; c < complex.n_cells; ++c) {
        sizes[c] *= std::clamp(kThicknesses * thickness[c] / sizes[c], kLeastPart, 1.0);
    }
    return sizes;
}

class GrainFilling {
   public:
    GrainFilling(const CellComplex& complex, const GrainChoices& choices, Workers& workers)
        : complex_(complex), choices_(choices), workers_(workers) {}

    void run() {
        sizes_ = cell_sizes(complex_, choices_.size);
        surface_ = grain_surface(complex_, sizes_, workers_);
        report(0.1);
        hulls_ = cell_hulls(complex_, surface_);
        fill();
        report(0.5);
        for (int round = 0; round < choices_.n_rounds; ++round) {
            improve();
            report(0.5 + 0.4 * (round + 1) / choices_.n_rounds);
        }
        // Flips have changed the triangles of hulls, but neither their points nor the order of
        // these.
        hulls_ = cell_hulls(complex_, surface_);
        if (choices_.n_rounds > 0) fill_again();
    }

    Grains result(const Sites& sites, const Vec3& origin) const {
        Grains grains{.mesh = grain_mesh(sites, complex_, surface_, hulls_, cells_, origin)};
        SharpFeatures sharp = sharp_features(complex_, surface_, hulls_);
        for (std::size_t c = 0; c < cells_.size(); ++c)
            add_angles(cells_[c], sharp.near[c], grains);
        grains.sharp_features = std::move(sharp.features);
        for (SharpFeature& feature : grains.sharp_features) {
            feature.cell = complex_.site_of(feature.cell);
        }
        report(1);
        return grains;
    }

   private:
    void report(double part) const {
        if (choices_.progress) choices_.progress(part);
    }

    void fill() {
        std::vector<std::optional<CellTetrahedra>> filled(hulls_.size());
        workers_.for_each(complex_.n_cells,
                          [&](int c) { filled[c] = fill_cell(hulls_[c], sizes_[c]); });
        for (int c = 0; c < complex_.n_cells; ++c) {
            if (!filled[c]) throw FoldedCell(complex_.site_of(c));
            cells_.push_back(std::move(*filled[c]));
        }
    }

    void improve() {
        SharedMoves shared(complex_, surface_, hulls_, cells_);
        shared.flip_edges();
        for (int k = 0; k < kMovesInRound; ++k) shared.move_nodes();
        workers_.for_each(complex_.n_cells, [&](int c) { climb(cells_[c], kRelaxations); });
    }

    void fill_again() {
        workers_.for_each(complex_.n_cells, [&](int c) {
            const double worst = cells_[c].worst();
            if (worst > kFilledAgain) return;
            std::optional<CellTetrahedra> again = fill_cell(hulls_[c], sizes_[c]);
            if (again && again->worst() > worst) cells_[c] = std::move(*again);
        });
    }

    static void add_angles(const CellTetrahedra& cell, const std::vector<char>& near,
                           Grains& grains) {
        for (int t = 0; t < cell.n_numbers(); ++t) {
            if (!cell.is_alive(t)) continue;
            const FourCorners& c = cell.corners(t);
            const bool at_feature = std::any_of(
                c.begin(), c.end(), [&](int v) { return v < cell.n_hull() && near[v] != 0; });
            (at_feature ? grains.angles_at_features : grains.angles)
                .add(dihedral_range(cell.point(c[0]), cell.point(c[1]), cell.point(c[2]),
                                    cell.point(c[3])));
        }
    }

    const CellComplex& complex_;
    const GrainChoices& choices_;
    Workers& workers_;
    std::vector<double> sizes_;
    GrainSurface surface_;
    std::vector<CellHull> hulls_;
    std::vector<CellTetrahedra> cells_;
};

}  // namespace

Grains mesh_grains(const Sites& sites, const CellComplex& complex, const GrainChoices& choices,
                   Workers& workers, const Vec3& origin) {
    GrainFilling filling(complex, choices, workers);
    filling.run();
    return filling.result(sites, origin);
}

}  // namespace pcvt::space
