#pragma once

#include "plugin/cli/mesh_options.hpp"

namespace pcvt::cli {

/// Gives `app` the options of `pcvt pattern`: those of `pcvt mesh` that choose the lattice and the
/// output.
void add_pattern_options(CLI::App& app, MeshOptions& options);

/// The job of `pcvt pattern`: run_mesh with the best lattice as sites and without an optimiser.
/// @param app  the one that add_pattern_options was given, after parsing.
/// @throws InvalidInput, LimitExceeded naming the option.
Job make_pattern_job(const CLI::App& app, const MeshOptions& options);

}  // namespace pcvt::cli
