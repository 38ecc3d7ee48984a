#include "mesher/space/grains/cell_filling.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/grains/flat_tetrahedra.hpp"
#include "mesher/space/grains/tetrahedron_flips.hpp"
#include "mesher/space/grains/vertex_insertion.hpp"

namespace pcvt::space {
namespace {

/// The sine of 22 degrees: no further attempt is made.
constexpr double kEnough = 0.374606593415912;
constexpr int kPasses = 8;
/// The first pass that adds and removes vertices, and the sine of 25 degrees, below which it does.
constexpr int kFirstInsertions = 2;
constexpr double kInsertedBelow = 0.42;
/// The target of the first pass, and what later ones add.
constexpr double kFirstTarget = 0.3;
constexpr double kTargetStep = 0.1;
/// The sine below which flips accompany relaxations.
constexpr double kRelaxedBelow = 0.6;

/// Cells of more tetrahedra are filled once, and those with this part of them below kEnough: flat
/// ones, where other densities hardly help.
constexpr int kMostForAttempts = 5000;
constexpr int kOneInSoMany = 20;

/// One way to fill a cell.
struct Attempt {
    /// RefinementChoices, the second and third relative to their defaults.
    double lattice;
    double radius;
    int n_relaxations;
};
constexpr std::array kAttempts{Attempt{1, 1, 3},   Attempt{1, 1, 0},      Attempt{0.97, 0.9, 3},
                               Attempt{1, 0.8, 1}, Attempt{0, 0.85, 0},   Attempt{1.07, 0.95, 2},
                               Attempt{0.9, 1, 3}, Attempt{1.15, 0.85, 1}};
/// Further attempts are made only below the sine of 13 degrees.
constexpr int kUsualAttempts = 5;
constexpr double kPoor = 0.2249510543438650;

class Climb {
   public:
    explicit Climb(CellTetrahedra& cell)
        : cell_(cell), moves_(cell), flips_(cell), insertion_(cell, moves_) {}

    void run(int n_relaxations) {
        for (int k = 0; k < n_relaxations; ++k) {
            checkpoint();
            moves_.relax();
            flip(kRelaxedBelow);
        }
        for (int pass = 0; pass < kPasses; ++pass) {
            checkpoint();
            const double target = std::min(kTargetSine, kFirstTarget + kTargetStep * pass);
            bool changed = move(target);
            changed |= flip(target);
            changed |= move(target);
            if (pass >= kFirstInsertions) changed |= mend(std::min(target, kInsertedBelow));
            if (!changed) break;
        }
    }

   private:
    /// Moves the inner vertices of tetrahedra below the target.
    bool move(double target) {
        waits_.assign(cell_.n_vertices(), 0);
        for (int t = 0; t < cell_.n_numbers(); ++t) {
            if (!cell_.is_alive(t) || cell_.quality(t) > target) continue;
            for (const int v : cell_.corners(t)) waits_[v] = 1;
        }
        bool changed = false;
        for (int v = cell_.n_hull(); v < cell_.n_vertices(); ++v) {
            if (waits_[v] != 0) changed |= moves_.climb(v, target);
        }
        return changed;
    }

    bool flip(double target) {
        bool changed = false;
        for (int t = 0; t < cell_.n_numbers(); ++t) {
            if (!cell_.is_alive(t) || cell_.quality(t) >= target) continue;
            if (cell_.has_failed(CellTetrahedra::kFlip, t)) continue;
            changed |= flips_.flip_at(t);
        }
        return changed;
    }

    bool mend(double target) {
        std::vector<std::pair<double, int>> thin;
        for (int t = 0; t < cell_.n_numbers(); ++t) {
            if (cell_.is_alive(t) && cell_.quality(t) < target) {
                thin.emplace_back(cell_.quality(t), t);
            }
        }
        std::sort(thin.begin(), thin.end());
        bool changed = false;
        for (const auto& [quality, t] : thin) {
            // Those that an earlier step replaced have another quality.
            if (!cell_.is_alive(t) || cell_.quality(t) != quality) continue;
            if (cell_.has_failed(CellTetrahedra::kInsertion, t)) continue;
            changed |= insertion_.mend(t);
        }
        return changed;
    }

    CellTetrahedra& cell_;
    std::vector<char> waits_;
    VertexMoves moves_;
    TetrahedronFlips flips_;
    VertexInsertion insertion_;
};

int n_below(const CellTetrahedra& cell, double quality) {
    int n = 0;
    for (int t = 0; t < cell.n_numbers(); ++t) {
        n += cell.is_alive(t) && cell.quality(t) < quality ? 1 : 0;
    }
    return n;
}

}  // namespace

void climb(CellTetrahedra& cell, int n_relaxations) {
    Climb(cell).run(n_relaxations);
    divide_flat(cell);
    cell.release_memory();
}

std::optional<CellTetrahedra> fill_cell(const CellHull& hull, double size) {
    const std::optional<Vec3> centre = kernel_point(hull);
    if (!centre) return std::nullopt;
    std::optional<CellTetrahedra> best;
    double worst = 0;
    int n_attempts = 0;
    for (const Attempt& attempt : kAttempts) {
        checkpoint();
        RefinementChoices choices{.size = size};
        choices.lattice_edge *= attempt.lattice;
        choices.radius *= attempt.radius;
        CellTetrahedra cell(hull, *centre);
        // A triangle without an area, from which flips would make tetrahedra that overlap.
        if (!(cell.worst() > 0)) return std::nullopt;
        insert_lattice(cell, choices, *centre);
        refine(cell, choices);
        divide_flat(cell);
        climb(cell, attempt.n_relaxations);
        const double quality = cell.worst();
        const bool is_hopeless =
            cell.n_numbers() > kMostForAttempts ||
            static_cast<long>(kOneInSoMany) * n_below(cell, kEnough) > cell.n_numbers();
        if (!best || quality > worst) {
            worst = quality;
            best = std::move(cell);
        }
        ++n_attempts;
        if (is_hopeless || worst >= (n_attempts < kUsualAttempts ? kEnough : kPoor)) break;
    }
    return best;
}

}  // namespace pcvt::space
