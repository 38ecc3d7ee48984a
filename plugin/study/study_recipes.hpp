#pragma once

#include "mesher/cvt/cvt.hpp"
#include "plugin/study/study.hpp"

namespace pcvt {

// One function a file, study_<name>.cpp.
StudyRecipe table1_recipe();
StudyRecipe fig7_recipe();
StudyRecipe fig8_recipe();
StudyRecipe fig9_recipe();
StudyRecipe fig10_recipe();
StudyRecipe fig11_recipe();

/// The paper's domain.
Lattice unit_square();

/// 5 / (18 sqrt(3) n), the paper's F_hex.
double f_hex(int n);

/// The paper's solver: L-BFGS and nothing else, so that statistics of its minima are its own.
CvtOptions plain_lbfgs(double tolerance, int max_iterations = -1);

/// Of a result, edges shorter than 1e-5 h not counted.
int count_hexagons(const CvtResult& result);

/// The rows of one n, in their order.
std::vector<StudyRow> rows_of(const StudyTable& table, int n);

}  // namespace pcvt
