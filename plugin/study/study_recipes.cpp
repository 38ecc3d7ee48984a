#include "plugin/study/study_recipes.hpp"

#include <algorithm>

#include "mesher/plane/mesh/voronoi.hpp"

namespace pcvt {

plane::Lattice unit_square() { return plane::Lattice::rectangle(1, 1); }

double f_hex(int n) { return plane::hexagonal_bound(1, n); }

plane::CvtOptions plain_lbfgs(double tolerance, int max_iterations) {
    plane::CvtOptions options;
    options.run.solver = Solver::kPlainLbfgs;
    options.run.tolerance = tolerance;
    options.run.max_iterations = max_iterations;
    return options;
}

int count_hexagons(const plane::CvtResult& result) {
    const std::vector<int> sides = cell_sides(result.delaunay);
    return static_cast<int>(std::count(sides.begin(), sides.end(), 6));
}

StudyRow run_cells(const RunStatistics& run) {
    return {std::to_string(run.iterations), std::to_string(run.evaluations), in_full(run.energy),
            in_full(run.residual)};
}

std::vector<StudyRow> rows_of(const StudyTable& table, int n) {
    const std::size_t column = table.column("n");
    const std::string number = std::to_string(n);
    std::vector<StudyRow> rows;
    std::copy_if(table.rows.begin(), table.rows.end(), std::back_inserter(rows),
                 [&](const StudyRow& row) { return row[column] == number; });
    return rows;
}

}  // namespace pcvt
