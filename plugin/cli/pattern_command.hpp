#pragma once

#include "plugin/cli/mesh_options.hpp"

namespace pcvt::cli {

/// Adds the options of `pcvt pattern` to `app`: the options of `pcvt mesh` for the lattice and the
/// output.
void add_pattern_options(CLI::App& app, MeshOptions& options);

/// The job of `pcvt pattern` for run_mesh: the best lattice as sites, no optimisation.
/// @param app  that of add_pattern_options, after parsing.
/// @throws InvalidInput, LimitExceeded naming the option.
Job make_pattern_job(const CLI::App& app, const MeshOptions& options);

}  // namespace pcvt::cli
