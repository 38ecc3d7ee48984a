#pragma once

#include <string>
#include <vector>

#include "io/formats/formats.hpp"
#include "tests/mutants/mutants.hpp"

namespace pcvt::testing {

/// A valid file, small enough to change each of its fields.
struct BaseFile {
    /// "voronoi box 2x1".
    std::string name;
    plane::MeshKind kind;
    Files files;
};

/// Returns files of the plane in a format: each kind, outline, repetition and form that it holds.
std::vector<BaseFile> base_files(std::string_view extension);

/// Returns the complaint with which `pcvt check` refuses the files; empty if it accepts them.
std::string refusal(std::string_view extension, const Files& files);

}  // namespace pcvt::testing
