#pragma once

#include "plugin/cli/mesh_options.hpp"

namespace pcvt::cli {

/// The job that the options describe, without the sites of `options.input` and the areas of a file,
/// which it does not read. It is in space if --lattice has nine numbers, or --period three.
/// @param app  that of add_mesh_options, after parsing.
/// @throws InvalidInput, LimitExceeded naming the option.
Job make_job(const CLI::App& app, const MeshOptions& options);

}  // namespace pcvt::cli
