#include "mesher/space/grains/grains.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/workers.hpp"
#include "mesher/space/grains/cell_filling.hpp"
#include "mesher/space/grains/cell_sizes.hpp"
#include "mesher/space/grains/face_heights.hpp"
#include "mesher/space/grains/shared_moves.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

/// The sine of 18 degrees: cells below are filled again on their moved faces.
constexpr double kFilledAgain = 0.3090169943749474;
/// The sine of 13 degrees: cells below are improved in further rounds.
constexpr double kImprovedAgain = 0.2249510543438650;
constexpr int kMostFurtherRounds = 2;
constexpr int kRelaxations = 3;
constexpr int kMovesInRound = 2;

CellComplex scaled(CellComplex complex, double factor) {
    const Lattice& lattice = complex.reduced;
    complex.reduced = Lattice(factor * lattice.a(), factor * lattice.b(), factor * lattice.c());
    for (Vec3& p : complex.sites) p *= factor;
    for (Vec3& p : complex.vertices) p *= factor;
    return complex;
}

class GrainFilling {
   public:
    GrainFilling(const CellComplex& complex, const GrainChoices& choices, double size,
                 Workers& workers)
        : complex_(complex), choices_(choices), size_(size), workers_(workers) {}

    void run() {
        CellSizes sizes = cell_sizes(complex_, size_);
        sizes_ = std::move(sizes.sizes);
        flat_ = std::move(sizes.flat);
        surface_ = grain_surface(complex_, sizes_, workers_);
        report(0.1);
        hulls_ = cell_hulls(complex_, surface_);
        mark_features();
        fill();
        report(0.5);
        for (int round = 0; round < choices_.n_rounds; ++round) {
            improve();
            report(0.5 + 0.4 * (round + 1) / choices_.n_rounds);
        }
        if (choices_.n_rounds > 0) finish();
    }

    /// @param complex  the cells in units of length.
    /// @param unit     the unit of the cells that were filled, length units.
    Grains result(const Sites& sites, const CellComplex& complex, double unit, const Vec3& origin) {
        SharpFeatures sharp = features();
        for (SharpFeature& feature : sharp.features) feature.place *= unit;
        Grains grains{.mesh = {.tetrahedra = {.lattice = sites.lattice()}}};
        std::vector<Angles> angles(cells_.size());
        workers_.for_each(complex_.n_cells,
                          [&](int c) { angles[c] = angles_of(cells_[c], sharp.near[c]); });
        for (int c = 0; c < complex_.n_cells; ++c) {
            const Angles& some = angles[c];
            if (some.is_flat) throw NarrowFeature(complex_.site_of(c));
            grains.angles.add(some.away);
            grains.angles_at_features.add(some.at_features);
        }
        grains.sharp_features = std::move(sharp.features);
        for (SharpFeature& feature : grains.sharp_features) {
            feature.cell = complex_.site_of(feature.cell);
        }
        scale(unit);
        grains.mesh = grain_mesh(sites, complex, surface_, hulls_, cells_, origin);
        report(1);
        return grains;
    }

   private:
    void report(double part) const {
        if (choices_.progress) choices_.progress(part);
    }

    void scale(double factor) {
        for (SurfaceNode& node : surface_.nodes) node.position *= factor;
        for (CellHull& hull : hulls_) {
            for (Vec3& p : hull.points) p *= factor;
        }
        for (CellTetrahedra& cell : cells_) cell.scale(factor);
    }

    SharpFeatures features() const {
        SharpFeatures sharp = sharp_features(complex_, surface_, hulls_);
        for (const FlatCell& flat : flat_) {
            sharp.features.push_back(
                {SharpFeature::Kind::kFlatCell, flat.cell, complex_.sites[flat.cell], flat.angle});
            std::fill(sharp.near[flat.cell].begin(), sharp.near[flat.cell].end(), 1);
        }
        return sharp;
    }

    /// Marks the points of the hulls that are near to features.
    void mark_features() {
        SharpFeatures sharp = features();
        for (int c = 0; c < complex_.n_cells; ++c) {
            std::vector<char>& near = sharp.near[c];
            if (std::find(near.begin(), near.end(), 1) == near.end()) near.clear();
            if (!cells_.empty()) cells_[c].set_near(near);
            hulls_[c].near = std::move(near);
        }
    }

    void fill() {
        std::vector<std::optional<CellTetrahedra>> filled(hulls_.size());
        workers_.for_each(complex_.n_cells,
                          [&](int c) { filled[c] = fill_cell(hulls_[c], sizes_[c]); });
        fill_smoothed(filled);
        for (int c = 0; c < complex_.n_cells; ++c) {
            if (!filled[c] && complex_.short_edges == 0) throw NarrowFeature(complex_.site_of(c));
            if (!filled[c]) throw FoldedCell(complex_.site_of(c));
            cells_.push_back(std::move(*filled[c]));
        }
    }

    /// Smooths the faces of cells that could not be filled, and fills the cells at these faces.
    void fill_smoothed(std::vector<std::optional<CellTetrahedra>>& filled) {
        std::vector<int> faces;
        std::vector<char> waits(filled.size(), 0);
        for (int f = 0; f < complex_.n_faces(); ++f) {
            const auto& [cell, neighbour, offset] = complex_.faces[f];
            if (filled[cell] && filled[neighbour]) continue;
            faces.push_back(f);
            waits[cell] = waits[neighbour] = 1;
        }
        if (faces.empty()) return;
        smooth_heights(complex_, faces, surface_);
        hulls_ = cell_hulls(complex_, surface_);
        mark_features();
        workers_.for_each(complex_.n_cells, [&](int c) {
            if (waits[c] != 0) filled[c] = fill_cell(hulls_[c], sizes_[c]);
        });
    }

    void improve() {
        SharedMoves shared(complex_, surface_, hulls_, cells_, workers_);
        shared.flip_edges();
        for (int k = 0; k < kMovesInRound; ++k) shared.move_nodes();
        workers_.for_each(complex_.n_cells, [&](int c) { climb(cells_[c], kRelaxations); });
    }

    /// Fills bad cells again, and improves all once more if one remains bad.
    void finish() {
        for (int round = 0;; ++round) {
            // Flips have changed the triangles of hulls, but neither their points nor the order of
            // these.
            hulls_.clear();
            hulls_ = cell_hulls(complex_, surface_);
            mark_features();
            fill_again();
            const bool is_bad = std::any_of(
                cells_.begin(), cells_.end(),
                [](const CellTetrahedra& cell) { return cell.worst() < kImprovedAgain; });
            if (round == kMostFurtherRounds || !is_bad) return;
            improve();
        }
    }

    void fill_again() {
        workers_.for_each(complex_.n_cells, [&](int c) {
            const double worst = cells_[c].worst();
            if (worst > kFilledAgain) return;
            std::optional<CellTetrahedra> again = fill_cell(hulls_[c], sizes_[c]);
            if (again && again->worst() > worst) cells_[c] = std::move(*again);
        });
    }

    struct Angles {
        DihedralRange away = {};
        DihedralRange at_features = {};
        bool is_flat = false;
    };

    static Angles angles_of(const CellTetrahedra& cell, const std::vector<char>& near) {
        Angles angles;
        for (int t = 0; t < cell.n_numbers(); ++t) {
            if (!cell.is_alive(t)) continue;
            const FourCorners& c = cell.corners(t);
            const bool at_feature = std::any_of(
                c.begin(), c.end(), [&](int v) { return v < cell.n_hull() && near[v] != 0; });
            angles.is_flat |= cell.is_flat(t);
            (at_feature ? angles.at_features : angles.away)
                .add(dihedral_range(cell.point(c[0]), cell.point(c[1]), cell.point(c[2]),
                                    cell.point(c[3])));
        }
        return angles;
    }

    const CellComplex& complex_;
    const GrainChoices& choices_;
    double size_;
    Workers& workers_;
    std::vector<double> sizes_;
    std::vector<FlatCell> flat_;
    GrainSurface surface_;
    std::vector<CellHull> hulls_;
    std::vector<CellTetrahedra> cells_;
};

}  // namespace

Grains mesh_grains(const Sites& sites, const CellComplex& complex, const GrainChoices& choices,
                   Workers& workers, const Vec3& origin) {
    // Shapes are measured by products of sixteen lengths, which are near to one in this unit. A
    // power of two changes no bit.
    const double unit = std::ldexp(1.0, std::ilogb(sites.spacing()));
    const CellComplex in_unit = scaled(complex, 1 / unit);
    GrainFilling filling(in_unit, choices, choices.size / unit, workers);
    filling.run();
    return filling.result(sites, complex, unit, origin);
}

}  // namespace pcvt::space
