#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "mesher/cells/elastic_choices.hpp"

namespace pcvt {

/// Reads the elastic constants that a user chooses: lines as parse_elastic_choices() takes them,
/// and lines with the name of a file .yaml or .yml, whose materials add_material_file() reads.
///
/// Example usage:
///     std::vector<std::string> files;
///     const ElasticChoices choices = read_elastic_choices("steel.yaml\nmatrix:3.5,0.35", files);
///
/// @param files  gets the names of the files.
/// @throws InvalidInput, BadFile with the entry, or the file and the line, and the remedy.
ElasticChoices read_elastic_choices(std::string_view text, std::vector<std::string>& files);

}  // namespace pcvt
