#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <string>

namespace pcvt {

/// The folder of the mesh in a case.
inline constexpr const char* kMeshFolder = "constant/polyMesh";

/// The comment that each file of a case beside its mesh holds.
inline constexpr const char* kCaseNote =
    "// pcvt check compares this file with its mesh; remove this line to change the file.\n";

/// Requires a path of a case that OpenFOAM opens: it leaves blanks and quotes out of every path, so
/// that it would look for another folder. A relative path counts with the folder in which pcvt
/// runs.
/// @throws InvalidInput  with the remedy.
void require_foam_path(const std::string& path);

/// Returns the first lines of a file of an OpenFOAM case: the class `kind`, the folder `location`
/// and the name `object`.
std::string foam_header(const std::string& kind, const std::string& location,
                        const std::string& object, const std::string& note = "");

/// Returns the first lines of a field with one value a cell, which `n` values and `);` follow.
/// @param type  "scalar" or "vector".
std::string foam_field_head(const std::string& type, const std::string& field,
                            const std::string& dimensions, std::size_t n);

/// Appends "(1 2 3)".
void append_foam_vector(std::string& text, const Eigen::Vector3d& vector);

/// A name in a text, and the number that replaces it.
struct FoamNumber {
    const char* name;
    double value;
};
/// Returns `text` with each $NAME replaced by its number.
std::string foam_fill(std::string text, std::initializer_list<FoamNumber> numbers);

}  // namespace pcvt
