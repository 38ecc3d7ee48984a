#pragma once

#include <CLI/App.hpp>
#include <initializer_list>
#include <string>

#include "mesher/torus/coincident_sites.hpp"

namespace pcvt::cli {

// Which options say where the sites and the lattice come from, in the plane and in space:
//
//   require_one_site_source(app, options.input);
//   refuse_beside_input(app, {"--seed", "--start"});

/// Requires that --period and --lattice are not both given.
/// @throws InvalidInput
void require_one_lattice(const CLI::App& app);

/// The choice of --duplicates.
/// @throws InvalidInput where no file gives sites.
Duplicates chosen_duplicates(const CLI::App& app, const std::string& word);

/// Requires one of --sites, --input and --centroids, and that the name of the file is not empty.
/// @param input  the value of --input or --centroids.
/// @throws InvalidInput
void require_one_site_source(const CLI::App& app, const std::string& input);

/// Refuses options of random sites where --input or --centroids gives the sites.
/// @throws InvalidInput
void refuse_beside_input(const CLI::App& app, std::initializer_list<const char*> names);

}  // namespace pcvt::cli
