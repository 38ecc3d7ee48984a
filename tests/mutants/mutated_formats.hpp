#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tests/mutants/base_files.hpp"

namespace pcvt::testing {

/// Mutants that `pcvt check` may accept.
struct Harmless {
    /// The name of a field; "v.*" covers all names that begin with "v.".
    std::string_view field;
    /// Empty: every change.
    std::string_view change;
    std::string_view reason;
    /// The beginning of the name of a base file; empty: every file.
    std::string_view base = {};
};

/// The reason for small changes in files of single precision.
inline constexpr std::string_view kSingle =
    "less than the roundings of single precision, which narrow cells magnify";

/// The reason for weights and metrics of triangles.
inline constexpr std::string_view kNotShown =
    "triangles do not show the weights and the metric of the cells; --cvt proves regularity";

/// The reason for orbits of sites beside triangles.
inline constexpr std::string_view kStatedOrbits =
    "triangles do not show which cells have one area, and nothing else states their orbits";

/// The reason for files without a note on orbits.
inline constexpr std::string_view kNoOrbits = "a file without orbits states none";

/// The reason for the highest number of an orbit, raised by 1.
inline constexpr std::string_view kOwnOrbit = "the last site may have an orbit of its own";

/// The reason for small steps in files of 32 bits: a metric stretches the rounding, too.
inline constexpr std::string_view kStretched = "below the rounding of 32 bits in the metric";

/// One row of the table of formats whose fields the campaign changes.
struct MutatedFormat {
    /// As the command line of the campaign names it: "space_obj".
    std::string_view name;
    std::string_view extension;
    /// base_files or space_base_files.
    std::vector<BaseFile> (*bases)(std::string_view extension);
    /// refusal or space_refusal.
    std::string (*refusal)(std::string_view extension, const Files& files);
    /// Every change of every field and row that a consumer reads.
    /// @pre the base outlives the result.
    std::vector<Mutant> (*mutants)(const BaseFile& base);
    std::span<const Harmless> harmless;
};

std::span<const MutatedFormat> mutated_formats();

/// One function a format, in the file of the format.
std::vector<Mutant> obj_mutants(const BaseFile& base);
std::vector<Mutant> msh_mutants(const BaseFile& base);
std::vector<Mutant> inp_mutants(const BaseFile& base);
std::vector<Mutant> vtu_mutants(const BaseFile& base);
std::vector<Mutant> foam_mutants(const BaseFile& base);
std::vector<Mutant> nc_mutants(const BaseFile& base);
std::vector<Mutant> vti_mutants(const BaseFile& base);
std::span<const Harmless> harmless_in_obj();
std::vector<Mutant> ply_mutants(const BaseFile& base);
std::span<const Harmless> harmless_in_ply();
std::vector<Mutant> glb_mutants(const BaseFile& base);
std::vector<Mutant> gltf_mutants(const BaseFile& base);
std::span<const Harmless> harmless_in_gltf();
std::vector<Mutant> om_mutants(const BaseFile& base);
std::span<const Harmless> harmless_in_om();
std::vector<Mutant> stl_mutants(const BaseFile& base);
std::span<const Harmless> harmless_in_stl();
std::span<const Harmless> harmless_in_msh();
std::span<const Harmless> harmless_in_inp();
std::span<const Harmless> harmless_in_vtu();
std::span<const Harmless> harmless_in_foam();
std::span<const Harmless> harmless_in_nc();
std::span<const Harmless> harmless_in_vti();
std::span<const Harmless> harmless_in_space();
std::span<const Harmless> harmless_in_space_glb();

}  // namespace pcvt::testing
