#pragma once

#include <array>

namespace pcvt {

/// The parts of a solver input besides the mesh: none, or materials and steps that run.
enum class SolverJob { kNone, kElastic };

/// One row of the table of choices (mesher/base/choices.hpp).
struct SolverJobRow {
    SolverJob job;
    const char* word;
    int abi_value;
};
inline constexpr std::array kSolverJobs{SolverJobRow{SolverJob::kElastic, "elastic", 1}};

}  // namespace pcvt
