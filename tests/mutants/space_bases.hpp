#pragma once

#include "tests/mutants/base_files.hpp"

namespace pcvt::testing {

/// Returns files of three dimensions in a format: tiles on several lattices, and the surfaces of
/// their cells and of their boundaries where the format shows both.
std::vector<BaseFile> space_base_files(std::string_view extension);

/// Returns the complaint with which `pcvt check` refuses files of three dimensions; empty if it
/// accepts them.
std::string space_refusal(std::string_view extension, const Files& files);

}  // namespace pcvt::testing
