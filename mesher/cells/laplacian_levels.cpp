// The levels of LaplacianSolver: the order of sweeps, and slots of entries.

#include <algorithm>
#include <span>

#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/simd.hpp"
#include "mesher/cells/laplacian_solver.hpp"

namespace pcvt {
namespace {

/// The rows of a block, whose vectors stay in the first-level cache while its colours are swept.
constexpr int kRowsPerBlock = 1 << 13;

}  // namespace

/// The smallest colours, in the order of the rows, that no neighbour has.
std::vector<int> LaplacianSolver::colours_of(const Matrix& matrix) {
    std::vector<int> colours(static_cast<std::size_t>(matrix.n_rows()), -1);
    std::vector<int> taken_by;
    for (int row = 0; row < matrix.n_rows(); ++row) {
        checkpoint_each(row);
        for (int k = matrix.row_begin[row]; k < matrix.row_begin[row + 1]; ++k) {
            const int colour = colours[matrix.column[k]];
            if (colour >= 0) taken_by[colour] = row;
        }
        int colour = 0;
        while (colour < std::ssize(taken_by) && taken_by[colour] == row) ++colour;
        if (colour == std::ssize(taken_by)) taken_by.push_back(-1);
        colours[row] = colour;
    }
    return colours;
}

namespace {

/// How many columns of a row a sweep has passed before it, and how many are ahead. Numbers above
/// kMostCounted count as equal.
constexpr int kMostCounted = 31;

struct Shape {
    int n_passed = 0;
    int n_ahead = 0;

    int key() const {
        return std::min(n_passed, kMostCounted) * (kMostCounted + 1) +
               std::min(n_ahead, kMostCounted);
    }
};

}  // namespace

/// Fills the slots of lane `lane` of a bundle, whose first place is `first`.
/// @param stage  the block and the colour of each row.
/// @param place  the place of each row.
void LaplacianSolver::fill_lane(const Matrix& matrix, const std::vector<int>& stage,
                                const std::vector<int>& place, int first, int lane, Level& level) {
    const int bundle = first / kLanes;
    const int row = level.row[first + lane];
    int passed = level.begin[bundle];
    int ahead = level.middle[bundle];
    if (row >= 0) {
        for (int k = matrix.row_begin[row]; k < matrix.row_begin[row + 1]; ++k) {
            const int column = matrix.column[k];
            const int slot = stage[column] < stage[row] ? passed++ : ahead++;
            level.column[kLanes * slot + lane] = place[column];
            level.conductance[kLanes * slot + lane] = matrix.conductance[k];
        }
    }
    // Slots that are not needed couple the place to itself.
    for (; passed < level.middle[bundle]; ++passed) {
        level.column[kLanes * passed + lane] = first + lane;
    }
    for (; ahead < level.begin[bundle + 1]; ++ahead) {
        level.column[kLanes * ahead + lane] = first + lane;
    }
}

namespace {

/// The rows by block and colour, and in each of these by shape, because rows of equal shapes leave
/// no slots empty; -1 at places that are left over.
std::vector<int> ordered_rows(const std::vector<int>& stage, int n_stages,
                              const std::vector<Shape>& shape) {
    const auto n = static_cast<int>(stage.size());
    std::vector<int> by_shape;
    by_shape.reserve(stage.size());
    for_each_bucket(
        n, (kMostCounted + 1) * (kMostCounted + 1), [&](int row) { return shape[row].key(); },
        [&](std::span<const int> rows) {
            by_shape.insert(by_shape.end(), rows.begin(), rows.end());
        });
    std::vector<int> rows;
    const auto stage_of = [&](int k) { return stage[by_shape[k]]; };
    for_each_bucket(n, n_stages, stage_of, [&](std::span<const int> ranks) {
        for (const int k : ranks) rows.push_back(by_shape[k]);
        rows.resize(static_cast<std::size_t>(whole_lanes(static_cast<int>(rows.size()))), -1);
    });
    return rows;
}

/// The largest numbers of the rows of a bundle.
Shape bundle_shape(std::span<const int> rows, const std::vector<Shape>& shape) {
    Shape most;
    for (const int row : rows) {
        if (row < 0) continue;
        most.n_passed = std::max(most.n_passed, shape[row].n_passed);
        most.n_ahead = std::max(most.n_ahead, shape[row].n_ahead);
    }
    return most;
}

}  // namespace

LaplacianSolver::Level LaplacianSolver::level_of(const Matrix& matrix) {
    const int n = matrix.n_rows();
    std::vector<int> stage = colours_of(matrix);
    const int n_colours = n > 0 ? *std::max_element(stage.begin(), stage.end()) + 1 : 0;
    for (int row = 0; row < n; ++row) stage[row] += row / kRowsPerBlock * n_colours;
    std::vector<Shape> shape(static_cast<std::size_t>(n));
    for (int row = 0; row < n; ++row) {
        checkpoint_each(row);
        for (int k = matrix.row_begin[row]; k < matrix.row_begin[row + 1]; ++k) {
            ++(stage[matrix.column[k]] < stage[row] ? shape[row].n_passed : shape[row].n_ahead);
        }
    }
    // Order the rows, and count their slots.
    Level level;
    level.row = ordered_rows(stage, (n + kRowsPerBlock - 1) / kRowsPerBlock * n_colours, shape);
    const int n_places = level.n_places();
    std::vector<int> place(static_cast<std::size_t>(n));
    for (int first = 0; first < n_places; first += kLanes) {
        const std::span rows = std::span<const int>(level.row).subspan(std::size_t(first), kLanes);
        for (int lane = 0; lane < kLanes; ++lane) {
            if (rows[std::size_t(lane)] >= 0) place[rows[std::size_t(lane)]] = first + lane;
        }
        const Shape most = bundle_shape(rows, shape);
        level.middle.push_back(level.begin.back() + most.n_passed);
        level.begin.push_back(level.middle.back() + most.n_ahead);
    }
    // Fill the slots.
    level.column.resize(kLanes * static_cast<std::size_t>(level.begin.back()));
    level.conductance.resize(level.column.size(), 0);
    level.inverse_diagonal.setZero(n_places);
    for (int p = 0; p < n_places; ++p) {
        checkpoint_each(p);
        fill_lane(matrix, stage, place, p - p % kLanes, p % kLanes, level);
        if (level.row[p] >= 0) level.inverse_diagonal[p] = matrix.inverse_diagonal[level.row[p]];
    }
    for (Eigen::VectorXd* v :
         {&level.b, &level.x, &level.first, &level.product, &level.rest, &level.residual}) {
        v->setZero(n_places);
    }
    return level;
}

/// Merges the rows of level k into those of the next one. Places without a row count as rows of
/// the first place.
void LaplacianSolver::aggregate_rows(std::size_t k, const std::vector<int>& aggregate) {
    const Level& coarse = levels_[k + 1];
    std::vector<int> place(static_cast<std::size_t>(coarse.n_places()));
    for (int p = 0; p < coarse.n_places(); ++p) {
        if (coarse.row[p] >= 0) place[coarse.row[p]] = p;
    }
    Level& level = levels_[k];
    level.aggregate.assign(level.row.size(), 0);
    for (int p = 0; p < level.n_places(); ++p) {
        if (level.row[p] >= 0) level.aggregate[p] = place[aggregate[level.row[p]]];
    }
}

void LaplacianSolver::replace_finest(const CellGraph& graph) {
    Level level = level_of(matrix_of(graph));
    Level& finest = levels_.front();
    std::vector<int> aggregate(static_cast<std::size_t>(graph.n_rows()));
    if (levels_.size() > 1) {
        for (int p = 0; p < finest.n_places(); ++p) {
            if (finest.row[p] >= 0) aggregate[finest.row[p]] = finest.aggregate[p];
        }
        level.aggregate.assign(level.row.size(), 0);
        for (int p = 0; p < level.n_places(); ++p) {
            if (level.row[p] >= 0) level.aggregate[p] = aggregate[level.row[p]];
        }
    }
    finest = std::move(level);
    if (levels_.size() == 1) factorize_coarsest();
}

}  // namespace pcvt
