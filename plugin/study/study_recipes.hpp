#pragma once

#include "mesher/plane/cvt/cvt.hpp"
#include "plugin/study/study.hpp"

namespace pcvt {

// One function a file, study_<name>.cpp.
StudyRecipe table1_recipe();
StudyRecipe fig7_recipe();
StudyRecipe fig8_recipe();
StudyRecipe fig9_recipe();
StudyRecipe fig10_recipe();
StudyRecipe fig11_recipe();
StudyRecipe sizes_recipe();
StudyRecipe symmetry_recipe();
StudyRecipe gersho3d_recipe();
StudyRecipe sizes3d_recipe();

/// The paper's domain.
plane::Lattice unit_square();

/// 5 / (18 sqrt(3) n), the paper's F_hex.
double f_hex(int n);

/// Relative difference of energies of the same minimum. The first run that reaches a minimum is
/// reported.
inline constexpr double kSameEnergy = 1e-9;

/// The paper's solver: only L-BFGS, so that the statistics of minima are comparable.
plane::CvtOptions plain_lbfgs(double tolerance, int max_iterations = -1);

/// The number of cells with six sides; edges shorter than 1e-5 h are not counted.
int count_hexagons(const plane::CvtResult& result);

/// The cells "iterations", "evaluations", "energy", "residual" of a row.
StudyRow run_cells(const RunStatistics& run);

/// The rows of one n, in their order.
std::vector<StudyRow> rows_of(const StudyTable& table, int n);

}  // namespace pcvt
