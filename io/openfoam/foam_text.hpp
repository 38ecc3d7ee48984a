#pragma once

#include <initializer_list>
#include <string>

namespace pcvt {

/// The first lines of a file of an OpenFOAM case: class, folder and name of what it holds.
std::string foam_header(const std::string& kind, const std::string& location,
                        const std::string& object, const std::string& note = "");

/// Appends "(1 2 3)".
void append_foam_vector(std::string& text, std::initializer_list<double> numbers);

/// `text` with each $NAME replaced by a number.
struct FoamNumber {
    const char* name;
    double value;
};
std::string foam_fill(std::string text, std::initializer_list<FoamNumber> numbers);

}  // namespace pcvt
